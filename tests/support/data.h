// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace traverse::testing
{
/** A file or folder of the real sensor data that is never copied into the project. */
inline std::filesystem::path sharedData(const std::string& name)
{
  return std::filesystem::path(TRAVERSE_DATA_DIR) / name;
}

/** A log that Debian's mrpt-common ships. */
inline std::string mrptData(const std::string& name)
{
  return std::string(TRAVERSE_MRPT_DATA_DIR) + "/" + name;
}
}  // namespace traverse::testing

/** Skips a test, loudly, where real data is missing. */
#define TRAVERSE_NEEDS(path)                                                  \
  do                                                                          \
  {                                                                           \
    if (!std::filesystem::exists(path))                                       \
    {                                                                         \
      GTEST_SKIP() << "SKIPPED: real data is missing: " << std::string(path); \
    }                                                                         \
  } while (false)
