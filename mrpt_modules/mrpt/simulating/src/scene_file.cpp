// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/strict.h>
#include <traverse/simulating/scene_file.h>

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace traverse::simulating
{
namespace
{
using config::ConfigError;
using simulation::numberedSection;
using simulation::SceneParams;

/** [Drive] belongs to the sensors; here only the way that a random scene proposes. */
const options::Option kDriveXs{"xs_m", "corners of the vehicle's way: x, m", {-1e5, 1e5}};
const options::Option kDriveYs{"ys_m", "the same corners' y, m", {-1e5, 1e5}};

bool beginsWith(const std::string& section, std::string_view prefix)
{
  return section.size() >= prefix.size() &&
         config::sameName(std::string_view(section).substr(0, prefix.size()), prefix);
}

std::string placeOf(const config::IniDocument& ini, const std::string& section)
{
  const auto entry = std::find_if(
      ini.entries().begin(), ini.entries().end(),
      [&](const config::Entry& e) { return config::sameName(e.section, section); });
  return entry == ini.entries().end() ? "" : entry->place + ": ";
}

/** "Object_07" is 7; throws where there is no whole number behind the prefix. */
size_t numberOf(const config::IniDocument& ini, const std::string& section, std::string_view prefix)
{
  const std::string_view digits = std::string_view(section).substr(prefix.size());
  size_t number = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = error == std::errc{} && stop == digits.data() + digits.size();
  if (!whole || !config::sameName(section, numberedSection(std::string(prefix), number)))
  {
    throw ConfigError(
        placeOf(ini, section) + "section [" + section +
            "]: allowed: " + numberedSection(std::string(prefix), 0) + ", " +
            numberedSection(std::string(prefix), 1) + " ...",
        section);
  }
  return number;
}

/** All [prefixNN], which must be numbered 00, 01 ... */
template <class P>
std::vector<P> readNumbered(const config::IniDocument& ini, std::string_view prefix)
{
  std::vector<size_t> numbers;
  for (const std::string& section : ini.sections())
  {
    if (beginsWith(section, prefix))
    {
      numbers.push_back(numberOf(ini, section, prefix));
    }
  }
  std::sort(numbers.begin(), numbers.end());
  std::vector<P> all(numbers.size());
  for (size_t i = 0; i < numbers.size(); ++i)
  {
    const std::string section = numberedSection(std::string(prefix), i);
    if (numbers[i] != i)
    {
      const std::string there = numberedSection(std::string(prefix), numbers[i]);
      throw ConfigError(
          fmt::format("{}there is a section [{}] but no [{}]", placeOf(ini, there), there, section),
          section);
    }
    config::load(ini, section, all[i]);
  }
  return all;
}

/** Sections that are nearly ours would silently do nothing. */
void refuseLookalikes(const config::IniDocument& ini)
{
  for (const std::string& section : ini.sections())
  {
    for (const std::string_view name : {"Scene", "Random"})
    {
      if (beginsWith(section, name) && !config::sameName(section, name))
      {
        throw ConfigError(
            placeOf(ini, section) + "section [" + section + "]: did you mean [" +
                std::string(name) + "]?",
            section);
      }
    }
    for (const std::string_view name : {"Terrain", "Object"})
    {
      if (beginsWith(section, name) && !beginsWith(section, std::string(name) + "_"))
      {
        throw ConfigError(
            placeOf(ini, section) + "section [" + section + "]: allowed: " + std::string(name) +
                "_00, " + std::string(name) + "_01 ...",
            section);
      }
    }
  }
}

void readCorners(
    const config::IniDocument& ini, const options::Option& option, std::vector<double>& corners)
{
  const config::Entry* entry = ini.find("Drive", option.key);
  if (entry == nullptr)
  {
    return;
  }
  try
  {
    options::parse(option, entry->value, corners);
  }
  catch (const options::OptionError& e)
  {
    throw ConfigError(entry->place + ": [Drive] " + e.what(), "Drive", std::string(option.key));
  }
}

/** Whether MRPT's reader gives the text back as it is. */
bool standsInIni(const std::string& text)
{
  const bool printable = std::all_of(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= ' '; });
  const bool blanks = !text.empty() && (text.front() == ' ' || text.back() == ' ');
  return printable && !blanks && text.find("//") == std::string::npos &&
         text.find('$') == std::string::npos && text.find('@') == std::string::npos &&
         (text.empty() || text.back() != '\\');
}

std::string keyLine(const std::string& section, std::string_view key, const std::string& value)
{
  if (!standsInIni(value))
  {
    throw ConfigError(
        "[" + section + "] " + std::string(key) +
            ": this text cannot stand in an ini file (no //, $, @, line ends, blanks at its ends)",
        section, std::string(key));
  }
  return std::string(key) + " = " + value + "\n";
}

/** The keys of p that are not as in P{}; for numbered sections `kind` always. */
template <class P>
std::string keysText(const std::string& section, const P& p)
{
  const std::vector<options::Row> usual = options::rows(P{});
  const std::vector<options::Row> rows = options::rows(p);
  std::string text;
  for (size_t i = 0; i < rows.size(); ++i)
  {
    if (rows[i].value != usual[i].value || rows[i].key == "kind")
    {
      text += keyLine(section, rows[i].key, rows[i].value);
    }
  }
  return text;
}

template <class P>
std::string sectionText(const std::string& section, const P& p)
{
  const std::string keys = keysText(section, p);
  return keys.empty() ? "" : "[" + section + "]\n" + keys + "\n";
}
}  // namespace

SceneParams readScene(const config::IniDocument& ini)
{
  refuseLookalikes(ini);
  SceneParams scene;
  scene.folder = ini.folder();
  config::load(ini, "Scene", scene.extent);
  config::load(ini, "Random", scene.random);
  scene.terrains = readNumbered<simulation::TerrainParams>(ini, "Terrain_");
  scene.objects = readNumbered<simulation::ObjectParams>(ini, "Object_");
  readCorners(ini, kDriveXs, scene.drive_xs_m);
  readCorners(ini, kDriveYs, scene.drive_ys_m);
  return scene;
}

std::string sceneText(const SceneParams& scene)
{
  std::string text = sectionText("Scene", scene.extent) + sectionText("Random", scene.random);
  for (size_t i = 0; i < scene.terrains.size(); ++i)
  {
    text += sectionText(numberedSection("Terrain_", i), scene.terrains[i]);
  }
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    text += sectionText(numberedSection("Object_", i), scene.objects[i]);
  }
  if (!scene.drive_xs_m.empty())
  {
    text += "[Drive]\n" + keyLine("Drive", "xs_m", options::format(scene.drive_xs_m)) +
            keyLine("Drive", "ys_m", options::format(scene.drive_ys_m));
  }
  return text;
}
}  // namespace traverse::simulating
