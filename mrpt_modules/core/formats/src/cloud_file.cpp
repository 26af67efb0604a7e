// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_table.h"
#include "text_lines.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/gzip.h>
#include <traverse/formats/safe_file.h>

#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
constexpr size_t kLargestFile = size_t{1} << 32U;

std::vector<std::string_view> cellsOf(std::string_view line)
{
  std::vector<std::string_view> cells;
  for (size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(','))
  {
    cells.push_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  cells.push_back(line);
  for (std::string_view& cell : cells)
  {
    const std::vector<std::string_view> words = wordsOf(cell);
    cell = words.empty() ? std::string_view() : words[0];
  }
  return cells;
}

/** Integers are kept exactly: nanoseconds since 1970 do not fit a double. */
std::vector<CloudField> columnsOf(std::string_view head, std::string_view first_row)
{
  const std::vector<std::string_view> values = cellsOf(first_row);
  std::vector<CloudField> fields;
  for (const std::string_view name : cellsOf(head))
  {
    CloudField field;
    field.name = lowerCase(name);
    const size_t at = fields.size();
    const bool whole =
        at < values.size() && values[at].find_first_not_of("0123456789-") == std::string_view::npos;
    const bool position = field.name == "x" || field.name == "y" || field.name == "z";
    setType(field, whole && !position ? 'I' : 'F', 8);
    fields.push_back(field);
  }
  return fields;
}

/** The ending in lower case, without .gz. */
std::string endingOf(const std::filesystem::path& path)
{
  std::filesystem::path name = path.filename();
  if (lowerCase(name.extension().string()) == ".gz")
  {
    name = name.stem();
  }
  return lowerCase(name.extension().string());
}
}  // namespace

CloudFile readCloudBin(std::string_view bytes)
{
  CloudTable table;
  for (const char* name : {"x", "y", "z", "intensity"})
  {
    table.fields.emplace_back().name = name;
  }
  const size_t stride = layOut(table.fields);
  if (bytes.size() % stride != 0)
  {
    throw FormatError("is no whole number of points of 16 bytes");
  }
  table.bytes = bytes;
  table.points = bytes.size() / stride;
  return cloudOf(table);
}

CloudFile readCloudCsv(std::string_view bytes)
{
  TextLines lines(bytes);
  const std::string_view head = lines.line();
  CloudTable table;
  for (std::string_view row = lines.line(); !row.empty(); row = lines.line())
  {
    if (table.points == 0)
    {
      table.fields = columnsOf(head, row);
      layOut(table.fields);
    }
    const std::vector<std::string_view> cells = cellsOf(row);
    if (cells.size() != table.fields.size())
    {
      throw FormatError(fmt::format("row {}: has {} columns", table.points + 2, cells.size()));
    }
    for (size_t i = 0; i < cells.size(); ++i)
    {
      appendText(table.storage, table.fields[i], cells[i]);
    }
    ++table.points;
  }
  if (table.fields.empty())
  {
    table.fields = columnsOf(head, "");
    layOut(table.fields);
  }
  table.bytes = table.storage;
  return cloudOf(table);
}

bool isCloudName(const std::filesystem::path& path)
{
  const std::string ending = endingOf(path);
  return ending == ".pcd" || ending == ".ply" || ending == ".bin" || ending == ".csv";
}

CloudFile readCloud(const std::filesystem::path& path)
{
  std::string bytes = readFile(path, kLargestFile);
  try
  {
    if (isGzip(bytes))
    {
      bytes = gunzip(bytes, kLargestFile);
    }
    const std::string ending = endingOf(path);
    return ending == ".pcd"   ? readPcd(bytes)
           : ending == ".ply" ? readPly(bytes)
           : ending == ".csv" ? readCloudCsv(bytes)
                              : readCloudBin(bytes);
  }
  catch (const FormatError& e)
  {
    throw FormatError(fmt::format("{}: {}", path.string(), e.what()));
  }
}
}  // namespace traverse::formats
