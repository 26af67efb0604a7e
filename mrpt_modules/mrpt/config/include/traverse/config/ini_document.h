// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::config
{
/** A configuration that cannot be used. what() names the file and line (or "--set"), section and
 * key. section() and key() let a caller who knows the file add the line. */
class ConfigError : public std::runtime_error
{
 public:
  explicit ConfigError(const std::string& message, std::string section = {}, std::string key = {}) :
      std::runtime_error(message), section_(std::move(section)), key_(std::move(key))
  {
  }

  const std::string& section() const { return section_; }

  const std::string& key() const { return key_; }

 private:
  std::string section_;
  std::string key_;
};

/** One `key = value` with where it stands. */
struct Entry
{
  std::string section;
  std::string key;
  std::string value;  //!< as MRPT expands it (@define, ${}, $env{}, $eval{}); `//` comments removed
  std::string place;  //!< "file:line", or "--set section.key"
};

/** An ini file in MRPT's syntax, read strictly: what stands twice, has no section or is no `key =
 * value` is an error with file:line, and a missing file is one too. Names are compared without
 * case. */
class IniDocument
{
 public:
  /** With assignments, as of set(), over what the file says. Throws ConfigError; files over 4 MB
   * are refused. */
  static IniDocument fromFile(
      const std::filesystem::path& file, const std::vector<std::string>& assignments = {});

  /** `name` stands for the file in messages. */
  static IniDocument fromText(const std::string& text, const std::string& name);

  /** Applies "section.key=value" over what the file says. The section may itself contain dots. */
  void set(std::string_view assignment);

  const std::vector<Entry>& entries() const { return entries_; }

  const Entry* find(std::string_view section, std::string_view key) const;

  /** In the order of the file, each once. */
  std::vector<std::string> sections() const;

  /** The whole document, overrides included, as plain ini text for MRPT's own readers. */
  std::string text() const;

  /** The file that a key names: a relative name that stands in the ini starts at its folder, one
   * that set() brought at the working folder. An empty name stays empty. */
  std::string pathOf(std::string_view section, std::string_view key, const std::string& name) const;

  /** Relative file names in the ini are relative to this folder. */
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::vector<Entry> entries_;
  std::filesystem::path folder_;
};

/** True where the two are equal but for the case of ASCII letters. */
bool sameName(std::string_view a, std::string_view b);
}  // namespace traverse::config
