// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_cache.h"

#include <atomic>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <system_error>
#include <unistd.h>

namespace traverse::reactive
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* kSums = "sums.txt";

/** FNV-1a of 64 bits. */
uint64_t hashOf(std::string_view text)
{
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text)
  {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return hash;
}

std::string textOf(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/** A line for each grid, with its check sum. */
std::string sumsOf(const fs::path& folder)
{
  std::map<std::string, uint64_t> sums;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.path().filename() != kSums)
    {
      sums[entry.path().filename().string()] = hashOf(textOf(entry.path()));
    }
  }
  std::string text;
  for (const auto& [name, sum] : sums)
  {
    text += fmt::format("{:016x} {}\n", sum, name);
  }
  return text;
}
}  // namespace

GridCache::GridCache(const fs::path& cache, std::string_view ini) :
    kept_(cache / fmt::format("{:016x}", hashOf(ini))), folder_(kept_)
{
  static std::atomic<int> counter = 0;
  const bool is_kept = fs::exists(kept_);
  const bool is_whole = is_kept && sumsOf(kept_) == textOf(kept_ / kSums);
  if (is_kept && !is_whole)
  {
    fs::remove_all(kept_);
  }
  if (!is_whole)
  {
    folder_ += fmt::format(".{}.{}.partial", getpid(), counter++);
    fs::create_directories(folder_);
  }
}

GridCache::~GridCache()
{
  if (folder_ != kept_)
  {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
}

void GridCache::keep()
{
  if (folder_ == kept_)
  {
    return;
  }
  std::ofstream(folder_ / kSums, std::ios::binary) << sumsOf(folder_);
  std::error_code error;
  fs::rename(folder_, kept_, error);
  if (!error)
  {
    folder_ = kept_;
  }
}
}  // namespace traverse::reactive
