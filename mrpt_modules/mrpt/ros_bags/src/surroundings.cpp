// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surroundings.h"

#include <traverse/formats/safe_file.h>
#include <traverse/observations/convert.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::ros_bags
{
namespace
{
std::optional<mrpt::img::DistortionModel> modelOf(const std::string& name)
{
  using mrpt::img::DistortionModel;
  if (name == "plumb_bob" || name == "rational_polynomial")
  {
    return DistortionModel::plumb_bob;
  }
  if (name == "equidistant" || name == "fisheye")
  {
    return DistortionModel::kannala_brandt;
  }
  return name.empty() ? std::optional(DistortionModel::none) : std::nullopt;
}

void setDistortion(mrpt::img::TCamera& camera, const CameraInfo& info)
{
  const auto model = modelOf(info.distortion_model);
  const auto& d = info.distortion;
  const bool any = std::any_of(d.begin(), d.end(), [](double v) { return v != 0; });
  camera.distortion = mrpt::img::DistortionModel::none;
  camera.dist.fill(0);
  if (!any)
  {
    return;
  }
  camera.distortion = *model;
  if (model == mrpt::img::DistortionModel::kannala_brandt && d.size() >= 4)
  {
    camera.setDistortionKannalaBrandt(d[0], d[1], d[2], d[3]);
    return;
  }
  std::copy_n(d.begin(), std::min(d.size(), camera.dist.size()), camera.dist.begin());
}

/** Usable for images of this size. */
bool fits(const CameraInfo& info, uint32_t width, uint32_t height)
{
  const auto finite = [](double v) { return std::isfinite(v); };
  return info.width / std::max(info.binning_x, 1U) >= width &&
         info.height / std::max(info.binning_y, 1U) >= height &&
         std::all_of(info.k.begin(), info.k.end(), finite) &&
         std::all_of(info.p.begin(), info.p.end(), finite) &&
         std::all_of(info.distortion.begin(), info.distortion.end(), finite) &&
         modelOf(info.distortion_model).has_value();
}
}  // namespace

mrpt::poses::CPose3D Surroundings::sensorPose(const std::string& frame, int64_t stamp_ns)
{
  if (frame.empty() || preview_.base.empty())
  {
    notes_.warn(fmt::format("no tf for frame '{}': its sensors stand at the origin", frame));
    return {};
  }
  const auto pose = preview_.tree.find(preview_.base, frame, stamp_ns);
  if (!pose)
  {
    notes_.warn(fmt::format(
        "tf does not join frame '{}' to '{}': its sensors stand at the origin", frame,
        preview_.base));
    return {};
  }
  return observations::toPose3D(*pose);
}

std::string Surroundings::label(const std::string& topic)
{
  const auto known = labels_.find(topic);
  if (known != labels_.end())
  {
    return known->second;
  }
  std::string plain = topic.rfind('/', 0) == 0 ? topic.substr(1) : topic;
  std::replace(plain.begin(), plain.end(), '/', '_');
  plain = formats::safeFileName(plain);
  std::string free = plain;
  for (int i = 2; !taken_.insert(free).second; ++i)
  {
    free = plain + "-" + std::to_string(i);
  }
  labels_[topic] = free;
  return free;
}

std::optional<mrpt::img::TCamera> Surroundings::camera(
    const std::string& image_topic, uint32_t width, uint32_t height)
{
  const std::string folder = image_topic.substr(0, image_topic.rfind('/') + 1);
  const auto found = preview_.cameras.find(folder + "camera_info");
  if (found == preview_.cameras.end())
  {
    return std::nullopt;
  }
  const CameraInfo& info = found->second;
  const bool rectified = image_topic.find("rect", folder.size()) != std::string::npos;
  const double fx = rectified ? info.p[0] : info.k[0];
  const double fy = rectified ? info.p[5] : info.k[4];
  if (!fits(info, width, height) || !(fx > 0) || !(fy > 0))
  {
    notes_.warn(folder + "camera_info does not fit its images, and is not used");
    return std::nullopt;
  }
  const double bin_x = std::max(info.binning_x, 1U);
  const double bin_y = std::max(info.binning_y, 1U);
  mrpt::img::TCamera camera;
  camera.ncols = width;
  camera.nrows = height;
  camera.fx(fx / bin_x);
  camera.fy(fy / bin_y);
  camera.cx(((rectified ? info.p[2] : info.k[2]) - info.roi_x) / bin_x);
  camera.cy(((rectified ? info.p[6] : info.k[5]) - info.roi_y) / bin_y);
  if (rectified)
  {
    camera.distortion = mrpt::img::DistortionModel::none;
    return camera;
  }
  setDistortion(camera, info);
  return camera;
}

void Surroundings::setCamera(const std::string& topic, const CameraInfo& info)
{
  preview_.cameras[topic] = info;
}

float Surroundings::intensityScale(const std::string& topic, const std::vector<float>& values)
{
  constexpr float kByte = 255;
  constexpr float kWord = 65535;
  float most = 0;
  for (const float v : values)
  {
    most = std::max(most, std::isfinite(v) ? v : 0.0F);
  }
  const float needed = most <= 1 ? 1 : (most <= kByte ? kByte : kWord);
  const auto [scale, is_new] = scales_.emplace(topic, needed);
  if (needed > scale->second)
  {
    notes_.warn(fmt::format(
        "{}: from here on intensities are divided by {}, not {}: they were taken for darker ones",
        topic, needed, scale->second));
    scale->second = needed;
  }
  return scale->second;
}
}  // namespace traverse::ros_bags
