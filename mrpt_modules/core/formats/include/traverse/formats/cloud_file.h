// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** A point cloud as it stands in a file. Channels have the length of x or are empty. */
struct CloudFile
{
  std::vector<double> x, y, z;      //!< metres, in the file's own frame; any bits (NaN: no return)
  std::vector<float> intensity;     //!< in the file's own unit
  std::vector<uint16_t> ring;       //!< as the file numbers them
  std::vector<float> time_s;        //!< relative to `stamp_ns`, or to the file's own zero
  std::optional<int64_t> stamp_ns;  //!< first time of a point, where the file's times are a clock's
  std::vector<uint32_t> rgb;        //!< 0x00RRGGBB
  uint64_t width = 0;               //!< of an organised cloud; height 1 where it is none
  uint64_t height = 1;
  Eigen::Isometry3d viewpoint = Eigen::Isometry3d::Identity();  //!< PCD's: of the sensor
  std::string note;  //!< what was not taken, e.g. times that are none; empty: all

  size_t size() const { return x.size(); }
};

// Each reads untrusted bytes: nothing is allocated on the word of a header. They throw FormatError
// where the bytes are not of the format, cut short, or have no x, y and z.
//
// Fields are known by name (x y z; intensity, reflectivity, remission; ring, channel, laser_number;
// time, timestamp, t, offset_ns ...; rgb, rgba; red green blue), others are skipped. Times: values
// of 1e8 and more are a clock's (s, ms, us or ns since 1970 by their size); smaller ones are
// relative: seconds where they are fractions, nanoseconds where they are integers.

/** PCD 0.7 and before: ascii, binary, binary_compressed. */
CloudFile readPcd(std::string_view bytes);

/** PLY: ascii and binary of both byte orders; the element "vertex", others are skipped. */
CloudFile readPly(std::string_view bytes);

/** KITTI's .bin: float32 x, y, z, intensity. */
CloudFile readCloudBin(std::string_view bytes);

/** Text of numbers with commas between; the first row names the columns. */
CloudFile readCloudCsv(std::string_view bytes);

/** True for names that readCloud() knows: .pcd .ply .bin .csv, each also with .gz. */
bool isCloudName(const std::filesystem::path& path);

/** Reads a file by its name's ending. Throws FileError and FormatError, with the path. */
CloudFile readCloud(const std::filesystem::path& path);
}  // namespace traverse::formats
