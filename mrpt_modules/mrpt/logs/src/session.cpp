// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "session.h"

#include <traverse/options/untrusted_text.h>

#include <fmt/format.h>

namespace traverse::logs
{
namespace
{
constexpr size_t kLongest = 200;  // bytes of a reason
}  // namespace

Session::Session(
    const std::filesystem::path& file,
    const LogParams& params,
    const ReadOptions& options,
    const sandbox::ReaderJob& job) :
    file_(file),
    log_(sandbox::openInput(file)),
    frames_(log_.fd.get(), {params.reader_memory_mb, params.reader_timeout_s}, job, options.stop)
{
  report_.file_size = log_.size;
}

std::optional<Session::Product> Session::next()
{
  while (report_.end == LogEnd::reading)
  {
    try
    {
      const auto frame = frames_.next();
      if (!frame)
      {
        over(ended_well_ ? LogEnd::complete : LogEnd::damaged, "the reader ended too early");
      }
      else if (auto product = take(*frame))
      {
        return product;
      }
    }
    catch (const sandbox::ReaderStopped& e)
    {
      over(LogEnd::stopped, e.what());
    }
    catch (const sandbox::ReaderFailure& e)
    {
      over(LogEnd::damaged, e.what());
    }
    catch (const WireError& e)
    {
      over(LogEnd::damaged, fmt::format("the reader spoke nonsense: {}", e.what()));
    }
  }
  return std::nullopt;
}

std::optional<Session::Product> Session::take(const sandbox::Frame& frame)
{
  report_.bytes_read = std::min<uint64_t>(frames_.progress().offset, log_.size);
  switch (static_cast<FrameType>(frame.type))
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
      options::countBounded(report_.observations, count.type);
      break;
    case Counted::ignored:
      options::countBounded(report_.ignored, count.type);
      break;
    case Counted::rejected:
      options::countBounded(report_.rejected, count.type + ": " + count.reason);
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
    case Counted::channels:
      options::countBounded(report_.channels, count.reason);
      break;
    case Counted::channels_damage:
      report_.channels_damage = options::printable(count.reason, kLongest);
      break;
    case Counted::note:
      report_.notes.emplace(count.type, options::printable(count.reason, kLongest));
      break;
  }
}

std::string Session::place() const
{
  const sandbox::SharedProgress& at = frames_.progress();
  const std::string type = at.typeText();
  return fmt::format(
      "at object {}{} near byte {} of {}", at.object.load() + 1,
      type.empty() ? "" : " (" + type + ")", std::min<uint64_t>(at.offset, log_.size), log_.size);
}

void Session::over(LogEnd end, const std::string& why)
{
  report_.end = end;
  report_.bytes_read = std::min<uint64_t>(frames_.progress().offset, log_.size);
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
  frames_.finish();
}
}  // namespace traverse::logs
