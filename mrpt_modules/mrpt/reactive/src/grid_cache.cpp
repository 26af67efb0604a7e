// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_cache.h"

#include <atomic>
#include <cstdint>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

namespace traverse::reactive
{
namespace
{
namespace fs = std::filesystem;

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
}  // namespace

GridCache::GridCache(const fs::path& cache, std::string_view ini) :
    kept_(cache / fmt::format("{:016x}", hashOf(ini))), folder_(kept_)
{
  static std::atomic<int> counter = 0;
  if (!fs::exists(kept_))
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
  std::error_code error;
  fs::rename(folder_, kept_, error);
  if (!error)
  {
    folder_ = kept_;
  }
}
}  // namespace traverse::reactive
