// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "decoders.h"
#include "external_files.h"

#include <traverse/points/organise.h>

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace traverse::observations
{
namespace
{
using mrpt::maps::CPointsMap;

std::optional<points::Reject> refusal(const Eigen::Vector3f& p, const points::RangeLimits& limits)
{
  using points::Reject;
  if (!p.allFinite())
  {
    return Reject::nonfinite;
  }
  const float range = p.norm();
  if (range == 0)
  {
    return Reject::no_return;  // how many drivers write a beam without echo
  }
  if (range < limits.min_m)
  {
    return Reject::below_range;
  }
  return range > limits.max_m ? std::optional(Reject::beyond_range) : std::nullopt;
}

/** Intensity and colour of the kept points, where the cloud has such. */
class Channels
{
 public:
  explicit Channels(const CPointsMap& cloud) :
      intensity_(dynamic_cast<const mrpt::maps::CPointsMapXYZI*>(&cloud)),
      colour_(dynamic_cast<const mrpt::maps::CColouredPointsMap*>(&cloud))
  {
    if (intensity_ != nullptr)
    {
      const auto& all = intensity_->getPointsBufferRef_intensity();
      // 0..1 by MRPT's rule; importers are met that keep a byte's 0..255.
      const bool bytes = std::any_of(all.begin(), all.end(), [](float v) { return v > 1; });
      scale_ = bytes ? 1.0F / 255 : 1.0F;
    }
  }

  void add(size_t i, points::ScanBuffer& scan) const
  {
    if (intensity_ != nullptr)
    {
      const float v = intensity_->getPointIntensity(i) * scale_;
      scan.intensity.push_back(std::isfinite(v) ? std::clamp(v, 0.0F, 1.0F) : 0.0F);
    }
    if (colour_ != nullptr)
    {
      float x = 0;
      float y = 0;
      float z = 0;
      std::array<float, 3> rgb{};
      colour_->getPointRGB(i, x, y, z, rgb[0], rgb[1], rgb[2]);
      uint32_t packed = 0;
      for (const float c : rgb)
      {
        const float level = std::isfinite(c) ? std::clamp(c, 0.0F, 1.0F) * 255 : 0.0F;
        packed = packed << 8U | static_cast<uint32_t>(std::lround(level));
      }
      scan.rgb.push_back(packed);
    }
  }

 private:
  const mrpt::maps::CPointsMapXYZI* intensity_;
  const mrpt::maps::CColouredPointsMap* colour_;
  float scale_ = 1;
};

void takePoints(const CPointsMap& cloud, const points::RangeLimits& limits, points::Decoded& out)
{
  const auto& x = cloud.getPointsBufferRef_x();
  const auto& y = cloud.getPointsBufferRef_y();
  const auto& z = cloud.getPointsBufferRef_z();
  if (x.size() != y.size() || x.size() != z.size())
  {
    throw Refused("its cloud has coordinates of different lengths");
  }
  const Channels channels(cloud);
  for (size_t i = 0; i < x.size(); ++i)
  {
    const Eigen::Vector3f p_sensor(x[i], y[i], z[i]);
    if (const auto reason = refusal(p_sensor, limits))
    {
      out.rejects.add(*reason);
      continue;
    }
    const Eigen::Vector3d p = out.scan.T_base_sensor * p_sensor.cast<double>();
    out.scan.x.push_back(static_cast<float>(p.x()));
    out.scan.y.push_back(static_cast<float>(p.y()));
    out.scan.z.push_back(static_cast<float>(p.z()));
    channels.add(i, out.scan);
    out.scan.input_index.push_back(static_cast<uint32_t>(i));
  }
  if (out.scan.size() == x.size())
  {
    out.scan.input_index.clear();
    return;
  }
  out.scan.input_points = static_cast<uint32_t>(x.size());
}
}  // namespace

points::Decoded decodePointCloud(const Request& request)
{
  const auto& cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud&>(request.observation);
  std::vector<std::string> names;
  if (cloud.isExternallyStored() && !cloud.pointcloud)
  {
    names.push_back(cloud.getExternalStorageFile());
  }
  const ExternalFiles files(cloud, names, request.image_folder);
  if (!cloud.pointcloud)
  {
    throw Refused("it has no cloud");
  }
  points::Decoded out;
  out.scan.stamp = stampOf(cloud);
  out.scan.sensor_label = cloud.sensorLabel;
  out.scan.T_base_sensor = sensorPoseOf(cloud);
  takePoints(*cloud.pointcloud, request.limits(), out);
  out.image = points::organise(out.scan.view());
  return out;
}
}  // namespace traverse::observations
