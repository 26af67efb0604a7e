// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "entries.h"
#include "folders.h"
#include "image_size.h"

#include <traverse/observations/convert.h>

#include <mrpt/img/CImage.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>

namespace traverse::importing
{
namespace
{
mrpt::img::CImage loadPicture(const std::filesystem::path& file)
{
  checkPicture(file);
  constexpr int kAsItIs = -1;
  mrpt::img::CImage image;
  if (!image.loadFromFile(file.string(), kAsItIs) || image.isEmpty())
  {
    throw ImportError(file.string() + ": is a damaged picture");
  }
  return image;
}

mrpt::img::TCamera cameraOf(const Camera& camera, const mrpt::img::CImage& image)
{
  mrpt::img::TCamera out;
  out.ncols = static_cast<uint32_t>(image.getWidth());
  out.nrows = static_cast<uint32_t>(image.getHeight());
  out.setIntrinsicParamsFromValues(camera.fx, camera.fy, camera.cx, camera.cy);
  return out;
}

void takeDepth(
    const mrpt::img::CImage& image,
    const std::filesystem::path& file,
    mrpt::obs::CObservation3DRangeScan& scan)
{
  if (image.getPixelDepth() != mrpt::img::PixelDepth::D16U || image.isColor())
  {
    throw ImportError(file.string() + ": is no picture of 16-bit depths");
  }
  const auto rows = static_cast<int>(image.getHeight());
  const auto columns = static_cast<int>(image.getWidth());
  scan.hasRangeImage = true;
  scan.range_is_depth = true;
  scan.rangeImage_setSize(rows, columns);
  for (int row = 0; row < rows; ++row)
  {
    const auto* from = image.ptrLine<uint16_t>(static_cast<unsigned>(row));
    for (int column = 0; column < columns; ++column)
    {
      scan.rangeImage(row, column) = from[column];
    }
  }
}
}  // namespace

Entry imageEntry(const std::filesystem::path& file, const SensorAt& sensor, const Camera& camera)
{
  auto observation = mrpt::obs::CObservationImage::Create();
  observation->sensorLabel = sensor.label;
  observation->timestamp = observations::toTimePoint(sensor.stamp);
  observation->image = loadPicture(file);
  observation->cameraPose = observations::toPose3D(sensor.T_base_sensor);
  observation->cameraParams = cameraOf(camera, observation->image);
  return {observation, {}};
}

Entry depthEntry(const DepthFrame& frame, const SensorAt& sensor)
{
  auto scan = mrpt::obs::CObservation3DRangeScan::Create();
  scan->sensorLabel = sensor.label;
  scan->timestamp = observations::toTimePoint(sensor.stamp);
  scan->sensorPose = observations::toPose3D(sensor.T_base_sensor);
  const mrpt::img::CImage depth = loadPicture(frame.depth);
  takeDepth(depth, frame.depth, *scan);
  scan->rangeUnits = static_cast<float>(frame.metres_per_count);
  scan->maxRange = static_cast<float>(frame.metres_per_count * 65535);
  scan->cameraParams = cameraOf(frame.camera, depth);
  if (!frame.colour.empty())
  {
    scan->intensityImage = loadPicture(frame.colour);
    scan->hasIntensityImage = true;
    scan->intensityImageChannel = mrpt::obs::CObservation3DRangeScan::CH_VISIBLE;
    scan->cameraParamsIntensity = cameraOf(frame.camera, scan->intensityImage);
    // One viewpoint: the depth is registered to the colours.
    scan->relativePoseIntensityWRTDepth = observations::toPose3D(fromOptical());
  }
  return {scan, {}};
}
}  // namespace traverse::importing
