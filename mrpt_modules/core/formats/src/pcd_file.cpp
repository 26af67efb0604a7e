// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_table.h"
#include "lzf.h"
#include "text_lines.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/decimal.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <map>

namespace traverse::formats
{
namespace
{
constexpr size_t kMostFields = 256;
constexpr size_t kMostCount = 4096;  // numbers of one field
constexpr size_t kMostPoints = 1U << 28U;

/** What a header says: a list of words for each keyword. */
using Header = std::map<std::string, std::vector<std::string_view>>;

uint64_t wholeNumber(std::string_view text)
{
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
  {
    throw FormatError("a header with a count that is none");
  }
  return value;
}

/** Up to and with the line DATA. */
Header readHeader(TextLines& lines)
{
  constexpr size_t kMostLines = 100;
  Header header;
  for (size_t i = 0; i < kMostLines && !lines.atEnd(); ++i)
  {
    std::vector<std::string_view> words = wordsOf(lines.line());
    if (words.empty() || words[0][0] == '#')
    {
      continue;
    }
    const std::string key = lowerCase(words[0]);
    words.erase(words.begin());
    header[key] = words;
    if (key == "data")
    {
      return header;
    }
  }
  throw FormatError("has no PCD header");
}

const std::vector<std::string_view>& get(const Header& header, const char* key, size_t words)
{
  const auto found = header.find(key);
  if (found == header.end() || found->second.size() < words)
  {
    throw FormatError(fmt::format("its header has no {}", key));
  }
  return found->second;
}

/** One entry for each field of the file; fields of several numbers are "" (nobody asks for them).
 */
struct Layout
{
  std::vector<CloudField> fields;
  std::vector<size_t> count;
};

Layout layoutOf(const Header& header)
{
  const auto& names = get(header, header.count("fields") > 0 ? "fields" : "columns", 1);
  const auto& sizes = get(header, "size", names.size());
  const auto& types = get(header, "type", names.size());
  const auto counts = header.count("count") > 0 ? get(header, "count", names.size())
                                                : std::vector<std::string_view>();
  if (names.size() > kMostFields)
  {
    throw FormatError("has too many fields");
  }
  Layout layout;
  for (size_t i = 0; i < names.size(); ++i)
  {
    CloudField field;
    setType(field, types[i][0], wholeNumber(sizes[i]));
    const size_t count = counts.empty() ? 1 : wholeNumber(counts[i]);
    if (count > kMostCount)
    {
      throw FormatError("has a field of too many numbers");
    }
    field.name = count == 1 ? lowerCase(names[i]) : "";
    layout.fields.push_back(field);
    layout.count.push_back(count);
  }
  return layout;
}

/** Point by point. Returns the bytes of a point. */
size_t layByPoint(Layout& layout)
{
  size_t stride = 0;
  for (size_t i = 0; i < layout.fields.size(); ++i)
  {
    layout.fields[i].offset = stride;
    stride += layout.fields[i].size * layout.count[i];
  }
  for (CloudField& field : layout.fields)
  {
    field.step = stride;
  }
  return stride;
}

/** Field by field, as binary_compressed has it. */
void layByField(Layout& layout, size_t points)
{
  size_t offset = 0;
  for (size_t i = 0; i < layout.fields.size(); ++i)
  {
    layout.fields[i].offset = offset;
    layout.fields[i].step = layout.fields[i].size * layout.count[i];
    offset += layout.fields[i].step * points;
  }
}

std::string readAscii(const Layout& layout, size_t points, TextLines& lines, size_t left)
{
  size_t numbers = 0;
  size_t stride = 0;
  for (size_t i = 0; i < layout.fields.size(); ++i)
  {
    numbers += layout.count[i];
    stride += layout.count[i] * layout.fields[i].size;
  }
  if (numbers == 0 || points > left / numbers)  // a number and what parts it from the next
  {
    throw FormatError("is cut short");
  }
  std::string bytes;
  bytes.reserve(points * stride);
  for (size_t p = 0; p < points; ++p)
  {
    for (size_t i = 0; i < layout.fields.size(); ++i)
    {
      for (size_t n = 0; n < layout.count[i]; ++n)
      {
        appendText(bytes, layout.fields[i], lines.word());
      }
    }
  }
  return bytes;
}

std::string unpack(std::string_view data, size_t bytes)
{
  ByteReader in(data, "compressed data");
  const size_t packed = in.u32();
  if (in.u32() != bytes)
  {
    throw FormatError("compressed data of another size than the header's");
  }
  return lzfDecompress(in.raw(packed), bytes);
}

CloudTable readData(
    const Header& header, Layout& layout, size_t points, std::string_view data, TextLines& lines)
{
  CloudTable table;
  table.points = points;
  const size_t stride = layByPoint(layout);
  const std::string how = lowerCase(get(header, "data", 1)[0]);
  if (how == "ascii")
  {
    table.storage = readAscii(layout, points, lines, data.size() + 1);
  }
  else if (how == "binary_compressed" && points > 0)
  {
    table.storage = unpack(data, points * stride);
    layByField(layout, points);
  }
  else if (how == "binary" || how == "binary_compressed")
  {
    if (stride > 0 && points > data.size() / stride)
    {
      throw FormatError("is cut short");
    }
    table.bytes = data;
  }
  else
  {
    throw FormatError("its DATA are of an unknown kind");
  }
  table.bytes = table.storage.empty() ? table.bytes : std::string_view(table.storage);
  table.fields = layout.fields;
  return table;
}

/** Identity where it is missing or no pose. */
Eigen::Isometry3d viewpointOf(const Header& header)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const auto found = header.find("viewpoint");
  if (found == header.end() || found->second.size() != 7)
  {
    return T;
  }
  Eigen::Matrix<double, 7, 1> v;
  for (size_t i = 0; i < 7; ++i)
  {
    v[static_cast<Eigen::Index>(i)] = parseNumber(found->second[i]).value_or(std::nan(""));
  }
  const Eigen::Quaterniond q(v[3], v[4], v[5], v[6]);
  if (!v.allFinite() || std::abs(q.norm() - 1) > 0.01 || v.head<3>().norm() > 1e8)
  {
    return T;
  }
  T.linear() = q.normalized().toRotationMatrix();
  T.translation() = v.head<3>();
  return T;
}
}  // namespace

CloudFile readPcd(std::string_view bytes)
{
  TextLines lines(bytes);
  const Header header = readHeader(lines);
  Layout layout = layoutOf(header);
  const uint64_t width = wholeNumber(get(header, "width", 1)[0]);
  const uint64_t height = header.count("height") > 0 ? wholeNumber(get(header, "height", 1)[0]) : 1;
  if (width > kMostPoints || height > kMostPoints || width * height > kMostPoints)
  {
    throw FormatError("announces too many points");
  }
  const size_t points = width * height;
  if (header.count("points") > 0 && wholeNumber(get(header, "points", 1)[0]) != points)
  {
    throw FormatError("its POINTS are not WIDTH x HEIGHT");
  }
  const std::string_view data = bytes.substr(std::min(lines.position(), bytes.size()));
  CloudFile cloud = cloudOf(readData(header, layout, points, data, lines));
  cloud.width = width;
  cloud.height = height;
  cloud.viewpoint = viewpointOf(header);
  return cloud;
}
}  // namespace traverse::formats
