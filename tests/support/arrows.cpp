// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/arrows.h"

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace traverse::testing
{
namespace
{
/** The library word of arrows.txt for an include, or "" for the standard library and our own. */
std::string libraryOf(const std::string& include)
{
  static const std::vector<std::pair<std::regex, std::string>> kWords = {
      {std::regex("^mrpt/.*"), "MRPT"},
      {std::regex("^(Eigen|unsupported)/.*"), "Eigen"},
      {std::regex("^fmt/.*"), "fmt"},
      {std::regex("^(gdal|ogr|cpl)[_a-z0-9]*\\.h$"), "GDAL"},
      {std::regex("^octo(map|math)/.*"), "OctoMap"},
      {std::regex("^opencv2?/.*"), "OpenCV"},
      {std::regex("^nlohmann/.*"), "nlohmann_json"},
      {std::regex("^CLI/.*"), "CLI11"},
      {std::regex("^zlib\\.h$"), "zlib"},
      {std::regex("^(tbb|oneapi)/.*"), "TBB"},
      {std::regex("^nanoflann.*"), "nanoflann"},
      {std::regex("^embree.*"), "Embree"},
      {std::regex("^ompl/.*"), "OMPL"},
      {std::regex("^dlib/.*"), "dlib"},
      {std::regex("^(rosbag|ros|console_bridge)/.*"), "rosbag"}};
  for (const auto& [pattern, word] : kWords)
  {
    if (std::regex_match(include, pattern))
    {
      return word;
    }
  }
  return "";
}

/** "core/geometry/src/x.cpp" -> geometry; a map's mrpt/ folder is part of the plugin;
 * apps/traverse-map -> map_app. */
std::string roomOf(const fs::path& relative)
{
  std::vector<std::string> parts(relative.begin(), relative.end());
  if (parts.at(0) == "apps")
  {
    const std::string prefix = "traverse-";
    const bool prefixed = parts.at(1).rfind(prefix, 0) == 0;
    return (prefixed ? parts.at(1).substr(prefix.size()) : parts.at(1)) + "_app";
  }
  const bool shell = parts.at(1) == "maps" && parts.at(3) == "mrpt";
  return shell ? "plugin" : parts.at(2);
}

std::string violation(const std::string& include, const std::string& room, const Arrows& arrows)
{
  static const std::regex kOurs("^traverse/([a-z_0-9]+)/.*");
  const auto found = arrows.rooms.find(room);
  if (found == arrows.rooms.end())
  {
    return "room '" + room + "' has no line in cmake/arrows.txt";
  }
  std::smatch match;
  const bool ours = std::regex_match(include, match, kOurs);
  const bool shell =
      ours && match[1].str() == "maps";  // the shells, which only the plugin is made of
  if (shell && room == "plugin")
  {
    return "";
  }
  const std::string used = ours ? match[1].str() : libraryOf(include);
  const auto& allowed = ours ? found->second.rooms : found->second.libraries;
  if (used.empty() || allowed.count(used) != 0)
  {
    return "";
  }
  return "room '" + room + "' may not use " + used + " (<" + include +
         ">); read cmake/arrows.txt and doc/architecture.md, 'Arrows'";
}

void checkFile(
    const fs::path& file,
    const std::string& relative,
    const Arrows& arrows,
    std::vector<std::string>& bad)
{
  static const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"].*");
  std::ifstream in(file);
  int number = 0;
  for (std::string line; std::getline(in, line);)
  {
    ++number;
    std::smatch match;
    if (std::regex_match(line, match, kInclude))
    {
      const std::string what = violation(match[1].str(), roomOf(relative), arrows);
      if (!what.empty())
      {
        bad.push_back(relative + ":" + std::to_string(number) + ": " + what);
      }
    }
  }
}
}  // namespace

Arrows Arrows::read(const fs::path& file)
{
  static const std::regex kLine("^([a-z_0-9]+) *:([^:]*):(.*)$");
  std::ifstream in(file);
  if (!in)
  {
    throw std::runtime_error(file.string() + ": cannot be read");
  }
  Arrows arrows;
  for (std::string line; std::getline(in, line);)
  {
    std::smatch match;
    if (!std::regex_match(line, match, kLine))
    {
      continue;
    }
    Room& room = arrows.rooms[match[1].str()];
    room.rooms.insert(match[1].str());
    std::istringstream used(match[2].str());
    for (std::string name; used >> name;)
    {
      const Room& other = arrows.rooms.at(name);  // a room uses those above it only
      room.rooms.insert(name);
      room.libraries.insert(other.libraries.begin(), other.libraries.end());
    }
    std::istringstream libraries(match[3].str());
    for (std::string name; libraries >> name;)
    {
      room.libraries.insert(name);
    }
  }
  return arrows;
}

std::vector<std::string> forbiddenIncludes(const fs::path& root, const Arrows& arrows)
{
  std::vector<std::string> bad;
  for (const char* top : {"mrpt_modules", "apps"})
  {
    for (const auto& entry : fs::recursive_directory_iterator(root / top))
    {
      const std::string extension = entry.path().extension();
      if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
      {
        checkFile(entry.path(), fs::relative(entry.path(), root), arrows, bad);
      }
    }
  }
  return bad;
}
}  // namespace traverse::testing
