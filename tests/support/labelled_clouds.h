// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>
#include <zlib.h>

// Real clouds with a label for each point, cloud by cloud.
namespace traverse::testing
{
/** Whose files, frame, mount and label numbers. */
enum class Layout : uint8_t
{
  kitti,     //!< SemanticKITTI: velodyne/, labels/; HDL-64E 1.73 m up
  nuscenes,  //!< lidar/, labels/; HDL-32E 1.84 m up, its x to the right and y forward
};

/** A cloud in the sensor's place: x forward, y left, z up from the sensor. */
struct LabelledCloud
{
  points::ScanBuffer scan;
  std::vector<uint32_t> labels;
};

/** Whether a label means ground; nothing where it is left out of the score. */
inline std::optional<bool> isGround(Layout layout, uint32_t label)
{
  const auto is_one_of = [label](auto... some) { return ((label == some) || ...); };
  if (layout == Layout::nuscenes)
  {
    return is_one_of(4U, 10U) ? std::nullopt : std::optional(label <= 1);
  }
  return is_one_of(0U, 65535U) ? std::nullopt : std::optional(is_one_of(40U, 44U, 48U, 49U, 72U));
}

inline double mountHeight_m(Layout layout)
{
  return layout == Layout::kitti ? 1.73 : 1.84;
}

/** A file's bytes, through gzip where it is compressed. Throws std::runtime_error. */
inline std::vector<char> unpacked(const std::filesystem::path& file)
{
  gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr)
  {
    throw std::runtime_error("cannot open " + file.string());
  }
  std::vector<char> bytes;
  std::array<char, 65536> piece{};
  int got = 0;
  while ((got = gzread(in, piece.data(), piece.size())) > 0)
  {
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + got);
  }
  const bool failed = got < 0;
  gzclose(in);
  if (failed)
  {
    throw std::runtime_error("damaged: " + file.string());
  }
  return bytes;
}

/** Throws std::runtime_error where files are missing, damaged or of different lengths. */
inline LabelledCloud readLabelled(
    Layout layout, const std::filesystem::path& points, const std::filesystem::path& labels)
{
  const std::vector<char> raw = unpacked(points);
  const std::vector<char> ids = unpacked(labels);
  LabelledCloud cloud;
  cloud.labels.resize(ids.size() / sizeof(uint32_t));
  std::copy_n(ids.data(), cloud.labels.size() * 4, reinterpret_cast<char*>(cloud.labels.data()));
  std::vector<std::array<float, 4>> values(raw.size() / sizeof(std::array<float, 4>));
  std::copy_n(raw.data(), values.size() * 16, reinterpret_cast<char*>(values.data()));
  if (values.size() != cloud.labels.size())
  {
    throw std::runtime_error(points.string() + " and its labels are of different lengths");
  }
  for (const auto& [x, y, z, intensity] : values)
  {
    const bool turned = layout == Layout::nuscenes;
    cloud.scan.x.push_back(turned ? y : x);
    cloud.scan.y.push_back(turned ? -x : y);
    cloud.scan.z.push_back(z);
  }
  return cloud;
}

/** The clouds of a folder and their labels, by name. Throws std::runtime_error where it has none.
 */
inline std::vector<std::pair<std::filesystem::path, std::filesystem::path>> labelledFiles(
    Layout layout, const std::filesystem::path& folder)
{
  namespace fs = std::filesystem;
  std::vector<std::pair<fs::path, fs::path>> files;
  const fs::path clouds = folder / (layout == Layout::kitti ? "velodyne" : "lidar");
  for (const auto& entry : fs::directory_iterator(clouds))
  {
    const std::string name = entry.path().filename();
    const std::string stem = name.substr(0, name.find('.'));
    for (const char* ending : {".label.gz", ".label"})
    {
      const fs::path labels = folder / "labels" / (stem + std::string(ending));
      if (fs::exists(labels))
      {
        files.emplace_back(entry.path(), labels);
        break;
      }
    }
  }
  if (files.empty())
  {
    throw std::runtime_error("no clouds with labels in " + folder.string());
  }
  std::sort(files.begin(), files.end());
  return files;
}
}  // namespace traverse::testing
