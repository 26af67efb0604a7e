// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "convert.h"

#include <traverse/formats/bytes.h>

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace traverse::ros_bags
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationImage;

/** An encoding of bytes: where red, green and blue (or one grey) stand in a pixel. */
struct ByteEncoding
{
  std::string_view name;
  uint32_t channels;
  std::array<uint8_t, 3> bgr;
};

constexpr std::array<ByteEncoding, 8> kByteEncodings = {{
    {"mono8", 1, {0, 0, 0}},
    {"8UC1", 1, {0, 0, 0}},
    {"rgb8", 3, {2, 1, 0}},
    {"bgr8", 3, {0, 1, 2}},
    {"8UC3", 3, {0, 1, 2}},
    {"rgba8", 4, {2, 1, 0}},
    {"bgra8", 4, {0, 1, 2}},
    {"8UC4", 4, {0, 1, 2}},
}};

void checkRowLength(const Image& image, uint32_t pixel_bytes)
{
  if (image.width == 0 || image.height == 0 || image.step < image.width * pixel_bytes)
  {
    throw formats::FormatError("Image: rows shorter than its encoding needs");
  }
}

mrpt::img::CImage pictureOf(const Image& image, const ByteEncoding& encoding)
{
  checkRowLength(image, encoding.channels);
  const bool colour = encoding.channels > 1;
  std::vector<uint8_t> bytes;
  bytes.reserve(size_t{image.width} * image.height * (colour ? 3 : 1));
  for (size_t row = 0; row < image.height; ++row)
  {
    const char* at = image.data.data() + row * image.step;
    for (size_t i = 0; i < image.width; ++i, at += encoding.channels)
    {
      for (size_t c = 0; c < (colour ? 3U : 1U); ++c)
      {
        bytes.push_back(static_cast<uint8_t>(at[encoding.bgr[c]]));
      }
    }
  }
  mrpt::img::CImage picture;
  picture.loadFromMemoryBuffer(image.width, image.height, colour, bytes.data());
  return picture;
}

importing::Entry fromPicture(
    const Image& image, const ByteEncoding& encoding, const Origin& origin, Surroundings& around)
{
  auto to = CObservationImage::Create();
  to->image = pictureOf(image, encoding);
  to->cameraPose = around.sensorPose(image.header.frame, origin.stamp_ns);
  const auto camera = around.camera(origin.topic, image.width, image.height);
  if (!camera)
  {
    around.notes().warn(origin.topic + ": images without calibration (no camera_info beside it)");
  }
  mrpt::img::TCamera none;
  none.ncols = image.width;
  none.nrows = image.height;
  none.intrinsicParams.setZero();
  to->cameraParams = camera.value_or(none);
  return {to, {}};
}

/** Millimetres; 0 for none. Beyond 65.535 m there is no number: `too_far` counts. */
uint16_t millimetres(const char* at, const Image& image, bool metres, uint64_t& too_far)
{
  if (!metres)
  {
    const auto low = static_cast<uint8_t>(at[image.big_endian ? 1 : 0]);
    const auto high = static_cast<uint8_t>(at[image.big_endian ? 0 : 1]);
    return static_cast<uint16_t>(low | high << 8U);
  }
  std::array<char, 4> bytes{at[0], at[1], at[2], at[3]};
  if (image.big_endian)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  constexpr float kMmPerM = 1000;
  const float mm = std::bit_cast<float>(bytes) * kMmPerM;
  if (!(mm > 0) || std::isinf(mm))
  {
    return 0;
  }
  if (mm > static_cast<float>(std::numeric_limits<uint16_t>::max()))
  {
    ++too_far;
    return 0;
  }
  return static_cast<uint16_t>(std::lround(mm));
}

void setDepth(
    CObservation3DRangeScan& to, const Image& image, const Origin& origin, Surroundings& around)
{
  const bool metres = image.encoding == "32FC1";
  const uint32_t pixel_bytes = metres ? 4 : 2;
  checkRowLength(image, pixel_bytes);
  uint64_t too_far = 0;
  to.hasRangeImage = true;
  to.rangeImage_setSize(static_cast<int>(image.height), static_cast<int>(image.width));
  for (size_t row = 0; row < image.height; ++row)
  {
    const char* at = image.data.data() + row * image.step;
    for (size_t i = 0; i < image.width; ++i, at += pixel_bytes)
    {
      to.rangeImage(static_cast<int>(row), static_cast<int>(i)) =
          millimetres(at, image, metres, too_far);
    }
  }
  if (too_far > 0)
  {
    around.notes().skipped(origin.topic + ": pixels beyond 65.535 m", too_far);
  }
}

importing::Entry fromDepth(const Image& image, const Origin& origin, Surroundings& around)
{
  const auto camera = around.camera(origin.topic, image.width, image.height);
  if (!camera)
  {
    throw formats::FormatError("a depth image without calibration (camera_info beside it)");
  }
  auto to = CObservation3DRangeScan::Create();
  to->cameraParams = *camera;
  to->rangeUnits = 0.001F;
  to->range_is_depth = true;
  setDepth(*to, image, origin, around);
  // An image's frame looks along z with y down; this class looks along x with z up.
  const mrpt::poses::CPose3D T_optical_sensor =
      mrpt::poses::CPose3D() - to->relativePoseIntensityWRTDepth;
  to->sensorPose = around.sensorPose(image.header.frame, origin.stamp_ns) + T_optical_sensor;
  return {to, {}};
}

size_t commonPrefix(const std::string& a, const std::string& b)
{
  return static_cast<size_t>(
      std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

/** The colour image of the group that fits a depth image best; end where there is none. */
std::vector<Pending>::iterator colourFor(const Pending& depth, std::vector<Pending>& group)
{
  auto best = group.end();
  std::pair<bool, size_t> best_fit;
  for (auto it = group.begin(); it != group.end(); ++it)
  {
    const auto* image = dynamic_cast<CObservationImage*>(it->entry.observation.get());
    const bool usable = image != nullptr && it->stamp_ns == depth.stamp_ns &&
                        image->image.isColor() && image->cameraParams.fx() > 0;
    const std::pair<bool, size_t> fit(
        it->frame == depth.frame, commonPrefix(it->topic, depth.topic));
    // One character in common is only the leading slash.
    if (usable && (fit.first || fit.second > 1) && (best == group.end() || fit > best_fit))
    {
      best = it;
      best_fit = fit;
    }
  }
  return best;
}
}  // namespace

importing::Entry fromImage(const Image& image, const Origin& origin, Surroundings& around)
{
  for (const ByteEncoding& encoding : kByteEncodings)
  {
    if (image.encoding == encoding.name)
    {
      return fromPicture(image, encoding, origin, around);
    }
  }
  const bool depth =
      image.encoding == "16UC1" || image.encoding == "32FC1" ||
      (image.encoding == "mono16" && origin.topic.find("depth") != std::string::npos);
  if (!depth)
  {
    throw formats::FormatError("Image: encoding '" + image.encoding + "' is not understood");
  }
  return fromDepth(image, origin, around);
}

void joinColour(std::vector<Pending>& same_stamp)
{
  for (size_t i = 0; i < same_stamp.size(); ++i)
  {
    auto* depth = dynamic_cast<CObservation3DRangeScan*>(same_stamp[i].entry.observation.get());
    const auto colour = depth != nullptr ? colourFor(same_stamp[i], same_stamp) : same_stamp.end();
    if (colour == same_stamp.end())
    {
      continue;
    }
    const auto& image = dynamic_cast<const CObservationImage&>(*colour->entry.observation);
    depth->hasIntensityImage = true;
    depth->intensityImageChannel = CObservation3DRangeScan::CH_VISIBLE;
    depth->intensityImage = image.image;
    depth->cameraParamsIntensity = image.cameraParams;
    depth->relativePoseIntensityWRTDepth = image.cameraPose - depth->sensorPose;
    i -= colour - same_stamp.begin() < static_cast<std::ptrdiff_t>(i) ? 1 : 0;
    same_stamp.erase(colour);
  }
}
}  // namespace traverse::ros_bags
