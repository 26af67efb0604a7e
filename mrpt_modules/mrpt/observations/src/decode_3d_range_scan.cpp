// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "decoders.h"
#include "external_files.h"

#include <traverse/observations/convert.h>
#include <traverse/points/depth_image.h>

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <optional>

namespace traverse::observations
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;

sensors::Pinhole toPinhole(const mrpt::img::TCamera& camera)
{
  if (camera.distortion == mrpt::img::DistortionModel::kannala_brandt)
  {
    throw Refused("its camera is a fish-eye, which is not supported");
  }
  sensors::Pinhole pinhole;
  pinhole.columns = static_cast<int>(std::min<uint32_t>(camera.ncols, 1U << 16U));
  pinhole.rows = static_cast<int>(std::min<uint32_t>(camera.nrows, 1U << 16U));
  pinhole.fx_px = camera.intrinsicParams(0, 0);
  pinhole.fy_px = camera.intrinsicParams(1, 1);
  pinhole.cx_px = camera.intrinsicParams(0, 2);
  pinhole.cy_px = camera.intrinsicParams(1, 2);
  if (camera.distortion == mrpt::img::DistortionModel::plumb_bob)
  {
    pinhole.distortion = camera.dist;
  }
  return pinhole;
}

std::vector<std::string> externalNames(const CObservation3DRangeScan& scan)
{
  std::vector<std::string> names;
  if (scan.hasPoints3D && scan.points3D_isExternallyStored())
  {
    names.push_back(scan.points3D_getExternalStorageFile());
  }
  if (scan.hasRangeImage && scan.rangeImage_isExternallyStored())
  {
    names.push_back(scan.rangeImage_getExternalStorageFile(""));
    for (const auto& [layer, ignored] : scan.rangeImageOtherLayers)
    {
      names.push_back(scan.rangeImage_getExternalStorageFile(layer));
    }
  }
  for (const mrpt::img::CImage* image : {&scan.intensityImage, &scan.confidenceImage})
  {
    if (image->isExternallyStored())
    {
      names.push_back(image->getExternalStorageFile());
    }
  }
  return names;
}

/** Colour is a bonus: where the picture or its calibration is no good, the points go without. */
std::optional<points::ColourImage> colourOf(const CObservation3DRangeScan& scan)
{
  if (!scan.hasIntensityImage || scan.intensityImage.isEmpty() ||
      scan.intensityImage.getPixelDepth() != mrpt::img::PixelDepth::D8U)
  {
    return std::nullopt;
  }
  const mrpt::img::CImage& image = scan.intensityImage;
  points::ColourImage colour;
  colour.camera = toPinhole(scan.cameraParamsIntensity);
  colour.channels = image.channelCount();
  colour.row_bytes = image.getRowStride();
  colour.T_sensor_camera = toIsometry(scan.relativePoseIntensityWRTDepth);
  const bool fits =
      colour.camera.valid() && colour.camera.columns == static_cast<int>(image.getWidth()) &&
      colour.camera.rows == static_cast<int>(image.getHeight()) &&
      colour.T_sensor_camera.matrix().allFinite() && (colour.channels == 1 || colour.channels == 3);
  if (!fits)
  {
    return std::nullopt;
  }
  // Rows have a stride; the last one may end at its last pixel.
  const size_t bytes = colour.row_bytes * image.getHeight();
  colour.bytes = {image.ptrLine<uint8_t>(0), bytes};
  return colour;
}
}  // namespace

points::Decoded decode3DRangeScan(const Request& request)
{
  const auto& scan = dynamic_cast<const CObservation3DRangeScan&>(request.observation);
  if (!scan.hasRangeImage)
  {
    throw Refused("it has no range image");
  }
  const ExternalFiles files(scan, externalNames(scan), request.image_folder);
  points::DepthImage input;
  input.stamp = stampOf(scan);
  input.sensor_label = scan.sensorLabel;
  input.T_base_sensor = sensorPoseOf(scan);
  input.camera = toPinhole(scan.cameraParams);
  if (!input.camera.valid())
  {
    throw Refused("its depth camera has no calibration");
  }
  if (scan.rangeImage.rows() != input.camera.rows || scan.rangeImage.cols() != input.camera.columns)
  {
    throw Refused("its range image does not have the size that its calibration says");
  }
  input.values = {scan.rangeImage.data(), static_cast<size_t>(scan.rangeImage.size())};
  input.unit_m = scan.rangeUnits;
  input.along_axis = scan.range_is_depth;
  input.step = request.params.depth_image_step;
  input.limits = request.limits();
  const std::optional<points::ColourImage> colour = colourOf(scan);
  input.colour = colour ? &*colour : nullptr;
  return points::decodeDepth(input);
}
}  // namespace traverse::observations
