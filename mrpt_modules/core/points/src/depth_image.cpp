// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_trig.h"

#include <traverse/points/depth_image.h>

#include <limits>
#include <stdexcept>

namespace traverse::points
{
namespace
{
void check(const DepthImage& in)
{
  if (!in.camera.valid())
  {
    throw std::invalid_argument("the depth camera has no calibration");
  }
  const size_t pixels =
      static_cast<size_t>(in.camera.rows) * static_cast<size_t>(in.camera.columns);
  if (in.values.size() != pixels || in.step < 1 || !(in.unit_m > 0) || !std::isfinite(in.unit_m))
  {
    throw std::invalid_argument("a depth image does not have the size that its camera says");
  }
  if (in.colour == nullptr)
  {
    return;
  }
  const ColourImage& c = *in.colour;
  const bool channels_ok = c.channels == 1 || c.channels == 3;
  if (!c.camera.valid() || !channels_ok ||
      c.row_bytes < static_cast<size_t>(c.camera.columns) * static_cast<size_t>(c.channels) ||
      c.bytes.size() < c.row_bytes * static_cast<size_t>(c.camera.rows))
  {
    throw std::invalid_argument("a colour image does not have the size that its camera says");
  }
}

uint32_t colourAt(const ColourImage& image, const Eigen::Vector3d& p_camera)
{
  const auto pixel = sensors::project(image.camera, p_camera);
  if (!pixel)
  {
    return 0;
  }
  const double u = std::floor(pixel->x() + 0.5);
  const double v = std::floor(pixel->y() + 0.5);
  if (!(u >= 0 && v >= 0 && u < image.camera.columns && v < image.camera.rows))
  {
    return 0;
  }
  const size_t at = static_cast<size_t>(v) * image.row_bytes +
                    static_cast<size_t>(u) * static_cast<size_t>(image.channels);
  const uint32_t blue = image.bytes[at];
  const uint32_t green = image.channels == 3 ? image.bytes[at + 1] : blue;
  const uint32_t red = image.channels == 3 ? image.bytes[at + 2] : blue;
  return red << 16U | green << 8U | blue;
}

/** Takes the pixels one by one. */
class Decoder
{
 public:
  explicit Decoder(const DepthImage& in) : in_(in)
  {
    out_.scan.stamp = out_.image.stamp = in.stamp;
    out_.scan.sensor_label = out_.image.sensor_label = in.sensor_label;
    out_.scan.T_base_sensor = out_.image.T_base_sensor = in.T_base_sensor;
    out_.image.rows = (in.camera.rows + in.step - 1) / in.step;
    out_.image.columns = (in.camera.columns + in.step - 1) / in.step;
    out_.image.max_range_m = in.limits.max_m;
    if (in.colour != nullptr)
    {
      sensor_to_camera_ = in.colour->T_sensor_camera.inverse();
    }
  }

  void take(int u, int v)
  {
    const auto along = sensors::ray(in_.camera, u, v);
    // Optical axes (right, down, forward) to the sensor's (forward, left, up).
    const Eigen::Vector3d d =
        along ? Eigen::Vector3d(1, -along->x(), -along->y()) : Eigen::Vector3d(1, 0, 0);
    const double norm = d.norm();
    const uint16_t value = in_.values[static_cast<size_t>(v) * in_.camera.columns + u];
    const double metres = value * in_.unit_m;
    const double range = in_.along_axis ? metres * norm : metres;
    const Beam beam = along ? classify(value, range) : reject(Reject::flagged);
    const bool hit = beam == Beam::hit;
    out_.image.beam.push_back(beam);
    out_.image.range_m.push_back(
        hit ? static_cast<float>(range) : std::numeric_limits<float>::quiet_NaN());
    out_.image.azimuth_rad.push_back(static_cast<float>(std::atan2(d.y(), d.x())));
    out_.image.elevation_rad.push_back(static_cast<float>(std::asin(d.z() / norm)));
    if (hit)
    {
      addPoint(d * (range / norm), out_.image.rows - 1 - v / in_.step);
    }
  }

  Decoded result() { return std::move(out_); }

 private:
  Beam reject(Reject reason)
  {
    out_.rejects.add(reason);
    return reason == Reject::beyond_range ? Beam::no_return : Beam::rejected;
  }

  Beam classify(uint16_t value, double range)
  {
    if (value == 0)
    {
      return reject(Reject::flagged);
    }
    if (range < in_.limits.min_m)
    {
      return reject(Reject::below_range);
    }
    return range > in_.limits.max_m ? reject(Reject::beyond_range) : Beam::hit;
  }

  void addPoint(const Eigen::Vector3d& p_sensor, int row)
  {
    const Eigen::Vector3d p = in_.T_base_sensor * p_sensor;
    out_.scan.x.push_back(static_cast<float>(p.x()));
    out_.scan.y.push_back(static_cast<float>(p.y()));
    out_.scan.z.push_back(static_cast<float>(p.z()));
    out_.scan.ring.push_back(static_cast<uint16_t>(row));
    if (in_.colour != nullptr)
    {
      out_.scan.rgb.push_back(colourAt(*in_.colour, sensor_to_camera_ * p_sensor));
    }
  }

  const DepthImage& in_;
  Eigen::Isometry3d sensor_to_camera_ = Eigen::Isometry3d::Identity();
  Decoded out_;
};
}  // namespace

Decoded decodeDepth(const DepthImage& input)
{
  check(input);
  Decoder decoder(input);
  const auto last = [&](int size) { return (size - 1) / input.step * input.step; };
  for (int v = last(input.camera.rows); v >= 0; v -= input.step)
  {
    for (int u = last(input.camera.columns); u >= 0; u -= input.step)
    {
      decoder.take(u, v);
    }
  }
  return decoder.result();
}
}  // namespace traverse::points
