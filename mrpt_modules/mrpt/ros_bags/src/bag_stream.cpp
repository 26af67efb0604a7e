// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_stream.h"

#include <traverse/formats/bytes.h>

#include <fmt/format.h>

namespace traverse::ros_bags
{
namespace
{
constexpr int kMostDeaths = 8;

sandbox::InputFile openBagFile(const std::filesystem::path& file)
{
  try
  {
    return sandbox::openInput(file);
  }
  catch (const sandbox::InputError& e)
  {
    throw importing::ImportError(e.what());
  }
}
}  // namespace

BagStream::BagStream(
    std::filesystem::path file,
    const BagParams& params,
    BagSelection want,
    const std::atomic<bool>* stop) :
    file_(std::move(file)),
    limits_{params.reader_memory_mb, params.reader_timeout_s},
    want_(std::move(want)),
    stop_(stop),
    bag_(openBagFile(file_))
{
  start();
}

/** A child that reads from want_.first on, up to where it has the bag open. */
void BagStream::start()
{
  opened_ = false;
  const auto job = [want = want_](int bag_fd, int frames_fd, sandbox::SharedProgress& progress)
  { runBagJob(bag_fd, frames_fd, progress, want); };
  frames_ = std::make_unique<sandbox::FrameStream>(bag_.fd.get(), limits_, job, stop_);
  while (!opened_ && !over_)
  {
    nextNews();
  }
}

std::optional<BagNews> BagStream::next()
{
  while (!over_)
  {
    if (auto news = nextNews())
    {
      return news;
    }
  }
  return std::nullopt;
}

std::optional<BagNews> BagStream::nextNews()
{
  std::string why = "its reader ended too early";
  try
  {
    if (const auto frame = frames_->next())
    {
      return take(*frame);
    }
  }
  catch (const sandbox::ReaderStopped& e)
  {
    deaths_ = kMostDeaths;
    why = e.what();
  }
  catch (const sandbox::ReaderFailure& e)
  {
    why = e.what();
  }
  catch (const formats::FormatError& e)
  {
    why = e.what();
  }
  failed(why);
  return std::nullopt;
}

std::optional<BagNews> BagStream::take(const sandbox::Frame& frame)
{
  BagNews news = readNews(frame);
  if (const auto* opened = std::get_if<BagOpened>(&news))
  {
    opened_ = true;
    messages_ = opened->messages;
    return std::nullopt;
  }
  if (const auto* failure = std::get_if<BagFailed>(&news))
  {
    deaths_ = kMostDeaths;  // not for one message's sake: it would fail again
    failed(failure->why);
    return std::nullopt;
  }
  if (std::holds_alternative<BagEnd>(news))
  {
    over_ = true;
    return std::nullopt;
  }
  ++want_.first;
  return news;
}

/** Goes on behind the message that the child died of, or ends it. */
void BagStream::failed(const std::string& why)
{
  frames_->finish();
  if (!opened_)
  {
    over_ = true;
    if (deaths_ > 0 && want_.first > 0)
    {
      damage_.push_back(fmt::format("{}: {} on opening it again", file_.string(), why));
      return;
    }
    throw importing::ImportError(fmt::format("{}: {}", file_.string(), why));
  }
  damage_.push_back(
      fmt::format("{}: {} at message {} of {}", file_.string(), why, want_.first + 1, messages_));
  ++want_.first;
  over_ = ++deaths_ > kMostDeaths || want_.first >= messages_;
  if (!over_)
  {
    start();
  }
}

double BagStream::progress() const
{
  if (over_ || messages_ == 0)
  {
    return over_ ? 1.0 : 0.0;
  }
  return static_cast<double>(std::min(want_.first, messages_)) / static_cast<double>(messages_);
}
}  // namespace traverse::ros_bags
