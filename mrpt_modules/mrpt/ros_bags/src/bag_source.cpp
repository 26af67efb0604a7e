// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_stream.h"
#include "converter.h"
#include "known_types.h"

#include <traverse/ros_bags/open_bag.h>

#include <deque>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace traverse::ros_bags
{
namespace
{
constexpr double kNsPerS = 1e9;

BagSelection selectionOf(const BagParams& params)
{
  BagSelection want;
  for (const KnownType& known : kKnownTypes)
  {
    if (known.kind != MessageKind::transforms)
    {
      want.types.emplace(known.type);
    }
  }
  std::istringstream topics(params.topics);
  for (std::string topic; topics >> topic;)
  {
    want.topics.insert(topic);
    // Images need their calibration, whoever asked for it or not.
    want.topics.insert(topic.substr(0, topic.rfind('/') + 1) + "camera_info");
  }
  return want;
}

std::string shortClass(const mrpt::obs::CObservation& observation)
{
  const std::string name = observation.GetRuntimeClass()->className;
  return name.substr(name.rfind(':') + 1);
}

class BagSource : public importing::Source
{
 public:
  BagSource(
      const std::filesystem::path& file, const BagParams& params, const std::atomic<bool>* stop) :
      reorder_(static_cast<int64_t>(params.reorder_s * kNsPerS)),
      converter_(readPreview(file, params, stop, notes_), notes_),
      stream_(file, params, selectionOf(params), stop)
  {
  }

  std::optional<importing::Entry> next() override
  {
    while (ready_.empty() && !over_)
    {
      advance();
    }
    if (ready_.empty())
    {
      return std::nullopt;
    }
    importing::Entry entry = std::move(ready_.front());
    ready_.pop_front();
    notes_.imported(entry.observation->sensorLabel + " " + shortClass(*entry.observation));
    return entry;
  }

  double progress() const override { return stream_.progress(); }

  const importing::ImportReport& report() const override { return notes_.report(); }

 private:
  void advance()
  {
    std::vector<Pending> group = reorder_.takeReady();
    if (!group.empty())
    {
      joinColour(group);
      for (Pending& pending : group)
      {
        ready_.push_back(std::move(pending.entry));
      }
      return;
    }
    if (ended_)
    {
      over_ = true;
    }
    else if (const auto news = stream_.next())
    {
      take(*news);
    }
    else
    {
      end();
    }
  }

  void take(const BagNews& news)
  {
    if (const auto* message = std::get_if<BagMessage>(&news))
    {
      if (auto pending = converter_.convert(*message))
      {
        reorder_.add(std::move(*pending));
      }
    }
    else if (const auto* skipped = std::get_if<BagSkipped>(&news))
    {
      const KnownType* known = knownType(skipped->type);
      if (known == nullptr)
      {
        notes_.skipped(skipped->topic + ": its type " + skipped->type);
      }
      else if (known->kind != MessageKind::transforms)
      {
        notes_.skipped(skipped->topic + ": not asked for");
      }
    }
    else if (const auto* unreadable = std::get_if<BagUnreadable>(&news))
    {
      notes_.damage(
          fmt::format("{}: a message of the bag: {}", unreadable->topic, unreadable->why));
    }
  }

  void end()
  {
    ended_ = true;
    reorder_.end();
    for (const std::string& damage : stream_.damage())
    {
      notes_.damage(damage);
    }
    if (reorder_.strange() > 0)
    {
      notes_.warn(fmt::format(
          "{} observations have stamps further than reorder_s from their recording, and stand in "
          "the order of that",
          reorder_.strange()));
    }
    if (reorder_.late() > 0)
    {
      notes_.warn(fmt::format(
          "{} observations came later than reorder_s, and are out of order", reorder_.late()));
    }
  }

  Notes notes_;
  Reorder reorder_;
  Converter converter_;
  BagStream stream_;
  std::deque<importing::Entry> ready_;
  bool ended_ = false;
  bool over_ = false;
};
}  // namespace

bool looksLikeBag(const std::filesystem::path& file)
{
  constexpr std::string_view kMark = "#ROSBAG V";
  std::ifstream in(file, std::ios::binary);
  std::string start(kMark.size(), '\0');
  return in.read(start.data(), static_cast<std::streamsize>(start.size())) && start == kMark;
}

std::unique_ptr<importing::Source> openBag(
    const std::filesystem::path& file, const BagParams& params, const std::atomic<bool>* stop)
{
  options::check(params);
  return std::make_unique<BagSource>(file, params, stop);
}
}  // namespace traverse::ros_bags
