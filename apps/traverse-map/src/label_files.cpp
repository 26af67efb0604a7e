// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "label_files.h"

#include <traverse/config/strict.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/safe_file.h>

#include <fmt/format.h>
#include <system_error>

namespace traverse::app
{
namespace fs = std::filesystem;

namespace
{
/** Says that a folder's labels are ours, and may be replaced. */
constexpr const char* kMark = "labels.txt";
constexpr const char* kMarkText =
    "Labels by traverse-map --point-labels: one uint32 per point; 0 undefined, 1 ground, "
    "2 obstacle, 3 overhanging.\n";

bool hasFiles(const fs::path& folder)
{
  std::error_code problem;
  const bool is_there = fs::exists(folder, problem);
  const bool is_empty = !is_there || fs::is_empty(folder, problem);
  if (problem)
  {
    throw formats::FileError("look into", folder, problem.value());
  }
  return !is_empty;
}
}  // namespace

LabelFiles::LabelFiles(fs::path folder, bool force) : folder_(std::move(folder))
{
  if (hasFiles(folder_) && !(force && fs::exists(folder_ / kMark)))
  {
    throw formats::FileError(
        folder_, force ? "has files that are no labels of traverse-map: give another folder"
                       : "has files in it; --force replaces labels of an earlier run");
  }
}

/** Nothing is touched before there is something to write. */
void LabelFiles::begin()
{
  std::error_code problem;
  fs::create_directories(folder_, problem);
  if (problem)
  {
    throw formats::FileError("make", folder_, problem.value());
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
  formats::writeFile(folder_ / kMark, kMarkText);
}

void LabelFiles::write(
    const points::Decoded& decoded,
    const poses::PoseTrack& track,
    const std::vector<BuiltMap>& maps)
{
  std::vector<uint32_t> labels;
  for (size_t i = 0; labels.empty() && i < maps.size(); ++i)
  {
    labels = maps[i].consumer->pointLabels(decoded.scan.view(), track);
  }
  if (labels.size() != decoded.scan.size())
  {
    throw config::ConfigError("--point-labels: none of the maps in [Maps] labels points");
  }
  if (number_ == 0)
  {
    begin();
  }
  formats::writeFile(folder_ / fmt::format("{:06}.label", number_++), labelBytes(decoded, labels));
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
