// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/ini_document.h>
#include <traverse/config/strict.h>

#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sstream>

namespace traverse::config
{
namespace
{
constexpr size_t kLargestFile = 4U << 20U;
constexpr size_t kLongestLine = 64U << 10U;

char lower(char c)
{
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string trimmed(std::string_view text)
{
  const size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos)
  {
    return {};
  }
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1));
}

/** Finds sections and keys with their lines; values come from MRPT's own parser, so that both
 * agree. */
class LineScanner
{
 public:
  explicit LineScanner(std::string name) : name_(std::move(name)) {}

  std::vector<Entry> scan(const std::string& text)
  {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
      ++number_;
      const bool continued = continues_;
      if (line.size() > kLongestLine)
      {
        throw ConfigError(fmt::format(
            "{}: this line has {} characters; the limit is {}", place(), line.size(),
            kLongestLine));
      }
      if (line.find('\0') != std::string::npos)
      {
        throw ConfigError(fmt::format("{}: a NUL byte: this is no ini file", place()));
      }
      line = trimmed(line);
      continues_ = !line.empty() && line.back() == '\\';
      if (continues_ && (isComment(line) || line.find("//") != std::string::npos))
      {
        throw ConfigError(
            fmt::format("{}: a comment that ends in '\\' would swallow the next line", place()));
      }
      if (!continued)
      {
        take(line);
      }
    }
    return std::move(entries_);
  }

 private:
  std::string place() const { return fmt::format("{}:{}", name_, number_); }

  static bool isComment(const std::string& line)
  {
    return line.empty() || line[0] == ';' || line[0] == '#' || line[0] == '@' ||
           line.rfind("//", 0) == 0;
  }

  void take(const std::string& line)
  {
    if (isComment(line))
    {
      return;
    }
    if (line[0] == '[')
    {
      const size_t end = line.find(']');
      if (end == std::string::npos)
      {
        throw ConfigError(fmt::format("{}: '[' without ']'", place()));
      }
      section_ = trimmed(line.substr(1, end - 1));
      return;
    }
    const size_t equals = line.find('=');
    const std::string key = trimmed(line.substr(0, equals));
    if (equals == std::string::npos || key.empty())
    {
      throw ConfigError(
          fmt::format("{}: neither [section] nor key = value: '{:.60}'", place(), line));
    }
    if (section_.empty())
    {
      throw ConfigError(fmt::format("{}: '{}' stands before the first [section]", place(), key));
    }
    refuseTwice(key);
    entries_.push_back({section_, key, "", place()});
  }

  void refuseTwice(const std::string& key)
  {
    const auto [first, is_new] =
        seen_.try_emplace(lowerCase(section_) + '\n' + lowerCase(key), place());
    if (!is_new)
    {
      throw ConfigError(fmt::format(
          "{}: [{}] {} stands twice; first at {}", place(), section_, key, first->second));
    }
  }

  std::string name_;
  int number_ = 0;
  bool continues_ = false;
  std::string section_;
  std::vector<Entry> entries_;
  std::map<std::string, std::string> seen_;  // section and key -> place
};
}  // namespace

bool sameName(std::string_view a, std::string_view b)
{
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

IniDocument IniDocument::fromFile(
    const std::filesystem::path& file, const std::vector<std::string>& assignments)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
  {
    throw ConfigError(fmt::format("{}: no such file", file.string()));
  }
  if (std::filesystem::file_size(file, error) > kLargestFile || error)
  {
    throw ConfigError(fmt::format("{}: larger than 4 MB: this is no ini file", file.string()));
  }
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in)
  {
    throw ConfigError(fmt::format("{}: cannot be read", file.string()));
  }
  IniDocument document = fromText(text.str(), file.string());
  document.folder_ = std::filesystem::absolute(file).parent_path();
  for (const std::string& assignment : assignments)
  {
    document.set(assignment);
  }
  return document;
}

IniDocument IniDocument::fromText(const std::string& text, const std::string& name)
{
  IniDocument document;
  document.entries_ = LineScanner(name).scan(text);
  try
  {
    const mrpt::config::CConfigFileMemory values(text);
    for (Entry& entry : document.entries_)
    {
      entry.value = trimmed(values.read_string(entry.section, entry.key, ""));
    }
  }
  catch (const std::exception& e)
  {
    throw ConfigError(fmt::format("{}: {}", name, e.what()));
  }
  return document;
}

void IniDocument::set(std::string_view assignment)
{
  const size_t equals = assignment.find('=');
  const size_t dot = assignment.substr(0, equals).rfind('.');
  if (equals == std::string_view::npos || dot == std::string_view::npos || dot == 0 ||
      dot + 1 == equals)
  {
    throw ConfigError(fmt::format("--set {}: not of the form section.key=value", assignment));
  }
  const std::string section = trimmed(assignment.substr(0, dot));
  const std::string key = trimmed(assignment.substr(dot + 1, equals - dot - 1));
  const std::string value = trimmed(assignment.substr(equals + 1));
  const std::string place = fmt::format("--set {}.{}", section, key);
  for (Entry& entry : entries_)
  {
    if (sameName(entry.section, section) && sameName(entry.key, key))
    {
      entry.value = value;
      entry.place = place;
      return;
    }
  }
  entries_.push_back({section, key, value, place});
}

const Entry* IniDocument::find(std::string_view section, std::string_view key) const
{
  const auto found = std::find_if(
      entries_.begin(), entries_.end(),
      [&](const Entry& e) { return sameName(e.section, section) && sameName(e.key, key); });
  return found == entries_.end() ? nullptr : &*found;
}

std::string IniDocument::pathOf(
    std::string_view section, std::string_view key, const std::string& name) const
{
  const Entry* entry = find(section, key);
  const bool written_in_ini = entry != nullptr && entry->place.rfind("--set", 0) != 0;
  const bool relative = !name.empty() && std::filesystem::path(name).is_relative();
  return written_in_ini && relative ? (folder_ / name).string() : name;
}

std::vector<std::string> IniDocument::sections() const
{
  std::vector<std::string> all;
  for (const Entry& e : entries_)
  {
    if (std::none_of(
            all.begin(), all.end(), [&](const std::string& s) { return sameName(s, e.section); }))
    {
      all.push_back(e.section);
    }
  }
  return all;
}

std::string IniDocument::text() const
{
  std::string all;
  for (const std::string& section : sections())
  {
    all += fmt::format("[{}]\n", section);
    for (const Entry& e : entries_)
    {
      if (sameName(e.section, section))
      {
        all += fmt::format("{} = {}\n", e.key, e.value);
      }
    }
  }
  return all;
}
}  // namespace traverse::config
