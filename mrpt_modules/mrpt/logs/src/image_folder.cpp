// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image_folder.h"

namespace traverse::logs
{
std::filesystem::path imageFolder(const JobSettings& settings)
{
  const std::filesystem::path beside = std::filesystem::absolute(settings.log).parent_path();
  if (!settings.sensors.image_folder.empty())
  {
    return beside / settings.sensors.image_folder;
  }
  for (const char* ending : {"_Images", "_images", "_IMAGES"})
  {
    std::filesystem::path folder = beside / (settings.log.stem().string() + ending);
    std::error_code none;
    if (std::filesystem::is_directory(folder, none))
    {
      return folder;
    }
  }
  return beside / "Images";
}
}  // namespace traverse::logs
