// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "part_store.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/checksum.h>
#include <traverse/formats/safe_file.h>

#include <fmt/format.h>

namespace traverse::app
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* kMadeOf = "made_of.txt";
constexpr size_t kMostBytes = size_t{1} << 34U;

void makeFolder(const fs::path& folder)
{
  std::error_code failed;
  fs::create_directory(folder, failed);
  if (failed)
  {
    throw formats::FileError("make the folder", folder, failed.value());
  }
}

void clear(const fs::path& folder)
{
  std::error_code failed;
  fs::remove_all(folder, failed);
  if (failed)
  {
    throw formats::FileError("clear", folder, failed.value());
  }
}
}  // namespace

PartStore::PartStore(const fs::path& output, const std::string& made_of) : folder_(output)
{
  folder_ += ".parts";
  const fs::path marker = folder_ / kMadeOf;
  if (fs::exists(fs::symlink_status(folder_)))
  {
    const bool is_folder = fs::is_directory(fs::symlink_status(folder_));
    if (!is_folder || (!fs::is_empty(folder_) && !fs::exists(marker)))
    {
      throw formats::FileError(
          folder_, "is not replaced: it has no made_of.txt, so no run of traverse-sim made it");
    }
    if (fs::exists(marker) && formats::readFile(marker, kMostBytes) == made_of)
    {
      return;
    }
    clear(folder_);
  }
  makeFolder(folder_);
  formats::writeFile(marker, made_of);
}

fs::path PartStore::logOf(size_t number) const
{
  return folder_ / fmt::format("{:06}.log.gz", number);
}

fs::path PartStore::labelsOf(size_t number) const
{
  return folder_ / fmt::format("{:06}.labels", number);
}

bool PartStore::has(size_t number) const
{
  if (!fs::exists(logOf(number)))
  {
    return false;
  }
  try
  {
    get(number);
    return true;
  }
  catch (const formats::FileError&)
  {
    return false;
  }
  catch (const formats::FormatError&)
  {
    return false;
  }
}

void PartStore::put(size_t number, const Part& part) const
{
  const std::string labels = labelBytes(part.labels);
  formats::ByteWriter writer;
  writer.u64(part.log.size());
  writer.u32(formats::crc32(part.log));
  writer.u32(formats::crc32(labels));
  writer.raw(labels);
  formats::writeFile(labelsOf(number), writer.bytes());
  formats::writeFile(logOf(number), part.log);  // last: a part is there with its log
}

Part PartStore::get(size_t number) const
{
  const std::string name = labelsOf(number).string();
  const std::string bytes = formats::readFile(name, kMostBytes);
  formats::ByteReader reader(bytes, name);
  const uint64_t log_size = reader.u64();
  const uint32_t log_crc = reader.u32();
  const uint32_t labels_crc = reader.u32();
  const std::string labels(reader.raw(reader.remaining()));
  if (log_size > kMostBytes || formats::crc32(labels) != labels_crc)
  {
    throw formats::FormatError(fmt::format("'{}' is damaged", name));
  }
  Part part;
  part.log = formats::readFile(logOf(number), log_size);
  if (part.log.size() != log_size || formats::crc32(part.log) != log_crc)
  {
    throw formats::FormatError(fmt::format("'{}' is damaged", logOf(number).string()));
  }
  part.labels = labelsIn(labels, name);
  return part;
}

void PartStore::remove() const
{
  std::error_code ignored;  // the next run of the same DIR clears what is left
  fs::remove_all(folder_, ignored);
}
}  // namespace traverse::app
