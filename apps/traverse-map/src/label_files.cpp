// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "label_files.h"

#include <traverse/config/strict.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/safe_file.h>

#include <cerrno>
#include <fmt/format.h>
#include <system_error>

namespace traverse::app
{
namespace fs = std::filesystem;

LabelFiles::LabelFiles(fs::path folder, bool force) : folder_(std::move(folder))
{
  std::error_code problem;
  fs::create_directories(folder_, problem);
  const bool has_files = !problem && !fs::is_empty(folder_, problem);
  if (problem)
  {
    throw formats::FileError("make", folder_, problem.value());
  }
  if (has_files && !force)
  {
    throw formats::FileError(folder_, "has files in it; --force replaces its labels");
  }
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder_))
  {
    if (entry.path().extension() == ".label")
    {
      old.push_back(entry.path());
    }
  }
  for (const fs::path& file : old)
  {
    fs::remove(file);
  }
}

void LabelFiles::write(
    const points::Decoded& decoded,
    const poses::PoseTrack& track,
    const std::vector<BuiltMap>& maps)
{
  for (const BuiltMap& map : maps)
  {
    const std::vector<uint32_t> labels = map.consumer->pointLabels(decoded.scan.view(), track);
    if (labels.size() == decoded.scan.size() && !labels.empty())
    {
      formats::writeFile(
          folder_ / fmt::format("{:06}.label", number_), labelBytes(decoded, labels));
      ++number_;
      return;
    }
  }
  if (decoded.scan.size() > 0)
  {
    throw config::ConfigError("--point-labels: none of the maps in [Maps] labels points");
  }
  formats::writeFile(folder_ / fmt::format("{:06}.label", number_), labelBytes(decoded, {}));
  ++number_;
}

std::string labelBytes(const points::Decoded& decoded, const std::vector<uint32_t>& labels)
{
  const std::vector<uint32_t>& index = decoded.scan.input_index;
  std::vector<uint32_t> all(index.empty() ? labels.size() : decoded.scan.input_points, 0);
  for (size_t i = 0; i < labels.size(); ++i)
  {
    all[index.empty() ? i : index[i]] = labels[i];
  }
  formats::ByteWriter out;
  for (const uint32_t label : all)
  {
    out.u32(label);
  }
  return out.take();
}
}  // namespace traverse::app
