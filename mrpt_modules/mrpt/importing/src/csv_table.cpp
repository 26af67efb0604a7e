// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "csv_table.h"

#include <traverse/formats/decimal.h>
#include <traverse/importing/source.h>

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace traverse::importing
{
namespace
{
std::vector<std::string_view> cellsOf(std::string_view line)
{
  std::vector<std::string_view> cells;
  for (size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(','))
  {
    cells.push_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  cells.push_back(line);
  return cells;
}

/** Takes the next line that is not empty; empty at the end. */
std::string_view takeLine(std::string_view& text)
{
  const size_t begin = std::min(text.find_first_not_of("\r\n"), text.size());
  text.remove_prefix(begin);
  const std::string_view line = text.substr(0, std::min(text.find_first_of("\r\n"), text.size()));
  text.remove_prefix(line.size());
  return line;
}
}  // namespace

CsvTable::CsvTable(std::string text, std::string name) :
    text_(std::move(text)), name_(std::move(name))
{
  std::string_view rest = text_;
  for (const std::string_view column : cellsOf(takeLine(rest)))
  {
    columns_.emplace(column, columns_.size());
  }
  for (std::string_view line = takeLine(rest); !line.empty(); line = takeLine(rest))
  {
    rows_.push_back(cellsOf(line));
    if (rows_.back().size() != columns_.size())
    {
      throw ImportError(
          fmt::format("{}: row {} has not {} columns", name_, rows_.size() + 1, columns_.size()));
    }
  }
}

std::string_view CsvTable::text(size_t row, const std::string& column) const
{
  const auto found = columns_.find(column);
  if (found == columns_.end() || row >= rows_.size())
  {
    throw ImportError(fmt::format("{}: has no column {}", name_, column));
  }
  return rows_[row][found->second];
}

double CsvTable::number(size_t row, const std::string& column) const
{
  const auto value = formats::parseNumber(text(row, column));
  if (!value)
  {
    throw ImportError(fmt::format("{}: row {}: {} is no number", name_, row + 2, column));
  }
  return *value;
}

int64_t CsvTable::integer(size_t row, const std::string& column) const
{
  const std::string_view cell = text(row, column);
  int64_t value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
  {
    throw ImportError(fmt::format("{}: row {}: {} is no integer", name_, row + 2, column));
  }
  return value;
}
}  // namespace traverse::importing
