// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace traverse::testing
{
/** An empty folder of its own, gone with its owner. */
class ScratchFolder
{
 public:
  ScratchFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "traverse-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }

  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};
}  // namespace traverse::testing
