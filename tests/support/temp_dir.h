// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace traverse::testing
{
/** A folder of its own that goes away with the test. */
class TempDir
{
 public:
  TempDir()
  {
    std::string name = std::filesystem::temp_directory_path() / "traverse-test-XXXXXX";
    if (mkdtemp(name.data()) == nullptr)
    {
      throw std::runtime_error("no temporary folder");
    }
    path_ = name;
  }

  ~TempDir()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  TempDir(const TempDir&) = delete;
  TempDir& operator=(const TempDir&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string readBytes(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void writeBytes(const std::filesystem::path& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}
}  // namespace traverse::testing
