// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::importing
{
/** Text with commas between, its columns named by the first row. */
class CsvTable
{
 public:
  /** Throws ImportError, with `name`, where a row has another number of columns than the first. */
  CsvTable(std::string text, std::string name);

  size_t rows() const { return rows_.size(); }

  /** Each throws ImportError where there is no such column, or no such value in it. */
  std::string_view text(size_t row, const std::string& column) const;
  double number(size_t row, const std::string& column) const;
  int64_t integer(size_t row, const std::string& column) const;

 private:
  std::string text_;
  std::string name_;
  std::map<std::string, size_t> columns_;
  std::vector<std::vector<std::string_view>> rows_;
};
}  // namespace traverse::importing
