// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "session.h"

#include <fmt/format.h>

namespace traverse::logs
{
namespace
{
constexpr size_t kMostKeys = 256;

/** One more of a kind; what a hostile log makes up does not fill the memory. */
void countKey(std::map<std::string, uint64_t>& counts, const std::string& key)
{
  const std::string clean = printable(key);
  const bool room = counts.size() < kMostKeys || counts.count(clean) > 0;
  ++counts[room ? clean : "others"];
}
}  // namespace

Session::Session(
    const std::filesystem::path& file,
    const LogParams& params,
    const ReadOptions& options,
    const ReaderJob& job) :
    file_(file), options_(options), log_(openLog(file)), process_(log_.fd.get(), params, job)
{
  report_.file_size = log_.size;
}

std::optional<Session::Product> Session::next()
{
  while (report_.end == LogEnd::reading && waitForFrame())
  {
    try
    {
      if (auto product = take(takeFrame()))
      {
        return product;
      }
    }
    catch (const WireError& e)
    {
      over(LogEnd::damaged, fmt::format("the reader spoke nonsense: {}", e.what()));
    }
  }
  return std::nullopt;
}

bool Session::frameComplete() const
{
  FrameHeader header;
  const size_t there = received_.size() - used_;
  if (there < sizeof(header))
  {
    return false;
  }
  std::memcpy(&header, received_.data() + used_, sizeof(header));
  if (header.magic != FrameHeader::kMagic || header.length > FrameHeader::kLongest)
  {
    throw WireError("a frame without its mark, or of absurd length");
  }
  return there >= sizeof(header) + header.length;
}

Session::Frame Session::takeFrame()
{
  FrameHeader header;
  std::memcpy(&header, received_.data() + used_, sizeof(header));
  const uint8_t* payload = received_.data() + used_ + sizeof(header);
  used_ += sizeof(header) + header.length;
  return {header.type, {payload, static_cast<size_t>(header.length)}};
}

bool Session::waitForFrame()
{
  try
  {
    while (!frameComplete())
    {
      if (options_.stop != nullptr && *options_.stop)
      {
        over(LogEnd::stopped, "stopped on request");
        return false;
      }
      const std::string misbehaviour = process_.misbehaviour();
      if (!misbehaviour.empty())
      {
        over(LogEnd::damaged, misbehaviour);
        return false;
      }
      received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(used_));
      used_ = 0;
      process_.wait();
      if (!process_.receive(received_))
      {
        const std::string how = process_.finish();
        const bool well = ended_well_ && how.empty();
        over(
            well ? LogEnd::complete : LogEnd::damaged,
            how.empty() ? "the reader ended too early" : how);
        return false;
      }
    }
  }
  catch (const WireError& e)
  {
    over(LogEnd::damaged, fmt::format("the reader spoke nonsense: {}", e.what()));
    return false;
  }
  return true;
}

std::optional<Session::Product> Session::take(const Frame& frame)
{
  report_.bytes_read = std::min<uint64_t>(process_.progress().offset, log_.size);
  switch (frame.type)
  {
    case FrameType::scan:
      return readScan(frame.payload);
    case FrameType::pose:
      return readPose(frame.payload);
    case FrameType::count:
      count(readCount(frame.payload));
      return std::nullopt;
    case FrameType::sighting:
      census_.add(readSighting(frame.payload), report_.sensors);
      return std::nullopt;
    case FrameType::object:
      ++report_.objects;
      return std::nullopt;
    case FrameType::damage:
    {
      const DamageFrame damage = readDamage(frame.payload);
      over(damage.not_a_log ? LogEnd::not_a_log : LogEnd::damaged, damage.message);
      return std::nullopt;
    }
    case FrameType::end:
      ended_well_ = true;
      return std::nullopt;
  }
  throw WireError("a frame of an unknown kind");
}

void Session::count(const CountFrame& count)
{
  switch (count.what)
  {
    case Counted::delivered:
      countKey(report_.observations, count.type);
      break;
    case Counted::ignored:
      countKey(report_.ignored, count.type);
      break;
    case Counted::rejected:
      countKey(report_.rejected, count.type + ": " + count.reason);
      break;
    case Counted::repeated_stamp:
      ++report_.repeated_stamps;
      break;
    case Counted::backward_stamp:
      ++report_.backward_stamps;
      break;
    case Counted::bad_stamp:
      ++report_.bad_stamps;
      break;
  }
}

std::string Session::place() const
{
  const SharedProgress& at = process_.progress();
  const std::string type = at.typeText();
  return fmt::format(
      "at object {}{} near byte {} of {}", at.object.load() + 1,
      type.empty() ? "" : " (" + type + ")", std::min<uint64_t>(at.offset, log_.size), log_.size);
}

void Session::over(LogEnd end, const std::string& why)
{
  report_.end = end;
  report_.bytes_read = std::min<uint64_t>(process_.progress().offset, log_.size);
  switch (end)
  {
    case LogEnd::complete:
    case LogEnd::reading:
      break;
    case LogEnd::not_a_log:
      report_.damage = fmt::format("{}: is no rawlog ({})", file_.string(), why);
      break;
    case LogEnd::stopped:
    case LogEnd::damaged:
      report_.damage = fmt::format("{}: {} {}", file_.string(), why, place());
      break;
  }
  process_.finish();
}
}  // namespace traverse::logs
