// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "preview.h"

#include "known_types.h"

#include <traverse/formats/bytes.h>

#include <cmath>

namespace traverse::ros_bags
{
namespace
{
class Collector
{
 public:
  explicit Collector(Notes& notes) : notes_(notes) {}

  void take(const BagMessage& message)
  {
    const KnownType* known = knownType(message.type);
    if (known == nullptr || known->md5sum != message.md5sum)
    {
      return;  // the second pass tells of it
    }
    try
    {
      take(message, known->kind);
    }
    catch (const formats::FormatError& e)
    {
      if (known->kind == MessageKind::transforms)
      {
        notes_.skipped(message.topic + ": " + e.what());
      }
    }
  }

  /** Only of transforms, which the second pass does not read. */
  void take(const BagUnreadable& message)
  {
    const KnownType* known = knownType(message.type);
    if (known != nullptr && known->kind == MessageKind::transforms)
    {
      notes_.damage(message.topic + ": a message of the bag: " + message.why);
    }
  }

  Preview finish(const BagParams& params)
  {
    preview_.base = params.base_frame.empty() ? likelyBase(preview_.tree) : params.base_frame;
    if (preview_.tree.full())
    {
      notes_.warn("there are too many transforms; the last ones are left out");
    }
    if (!preview_.tree.empty() && !preview_.tree.has(preview_.base))
    {
      notes_.warn(
          params.base_frame.empty()
              ? "tf knows no frame that looks like the vehicle's: give base_frame"
              : "tf does not know the frame '" + preview_.base + "'");
    }
    for (const auto& [topic, child] : children_)
    {
      // Odometry of a frame beside the vehicle's origin: only a robot pose has its place.
      const auto beside = preview_.tree.find(preview_.base, child, INT64_MAX);
      if (beside && !isPlanarIdentity(*beside))
      {
        preview_.spatial.insert(topic);
      }
    }
    return std::move(preview_);
  }

 private:
  void take(const BagMessage& message, MessageKind kind)
  {
    if (kind == MessageKind::transforms)
    {
      const bool fixed = message.topic.find("tf_static") != std::string::npos;
      for (const Transform& transform : parseTransforms(message.bytes))
      {
        preview_.tree.add(transform, fixed);
      }
    }
    else if (kind == MessageKind::camera_info && preview_.cameras.count(message.topic) == 0)
    {
      preview_.cameras.emplace(message.topic, parseCameraInfo(message.bytes));
    }
    else if (kind == MessageKind::odometry)
    {
      const Odometry odometry = parseOdometry(message.bytes);
      children_.emplace(message.topic, odometry.child_frame);
      if (!isPlanar(odometry.T_odom_child))
      {
        preview_.spatial.insert(message.topic);
      }
    }
  }

  static bool isPlanarIdentity(const Eigen::Isometry3d& pose)
  {
    constexpr double kSame = 1e-6;
    return pose.translation().head<2>().norm() < kSame &&
           (pose.linear() - Eigen::Matrix3d::Identity()).norm() < kSame;
  }

  Notes& notes_;
  Preview preview_;
  std::map<std::string, std::string> children_;  // child frame by topic of odometry
};
}  // namespace

bool isPlanar(const Eigen::Isometry3d& pose)
{
  constexpr double kLevel_m = 1e-6;
  constexpr double kUpright = 1e-9;  // cosine of 0.05 mrad
  return std::abs(pose.translation().z()) < kLevel_m && pose.linear()(2, 2) > 1 - kUpright;
}

Preview readPreview(
    const std::filesystem::path& file,
    const BagParams& params,
    const std::atomic<bool>* stop,
    Notes& notes)
{
  BagSelection want;
  want.name_others = false;
  want.types = {
      "tf2_msgs/TFMessage", "tf/tfMessage", "sensor_msgs/CameraInfo", "nav_msgs/Odometry"};
  BagStream stream(file, params, want, stop);
  Collector collector(notes);
  while (const auto news = stream.next())
  {
    if (const auto* message = std::get_if<BagMessage>(&*news))
    {
      collector.take(*message);
    }
    else if (const auto* unreadable = std::get_if<BagUnreadable>(&*news))
    {
      collector.take(*unreadable);
    }
  }
  for (const std::string& damage : stream.damage())
  {
    notes.damage("transforms and calibrations: " + damage);
  }
  return collector.finish(params);
}
}  // namespace traverse::ros_bags
