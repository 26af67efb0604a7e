// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_table.h"
#include "text_lines.h"

#include <traverse/formats/bytes.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace traverse::formats
{
namespace
{
constexpr size_t kMostProperties = 256;

struct Property
{
  CloudField field;                 //!< of a list: of its elements
  std::optional<CloudField> count;  //!< of a list
};

struct Element
{
  std::string name;
  size_t count = 0;
  std::vector<Property> properties;
};

struct Header
{
  std::string format;
  std::vector<Element> elements;
};

CloudField fieldOf(std::string_view type, std::string_view name)
{
  struct Known
  {
    char letter;
    size_t size;
  };

  static const std::map<std::string_view, Known> kTypes = {
      {"char", {'I', 1}},  {"int8", {'I', 1}},    {"uchar", {'U', 1}},  {"uint8", {'U', 1}},
      {"short", {'I', 2}}, {"int16", {'I', 2}},   {"ushort", {'U', 2}}, {"uint16", {'U', 2}},
      {"int", {'I', 4}},   {"int32", {'I', 4}},   {"uint", {'U', 4}},   {"uint32", {'U', 4}},
      {"int64", {'I', 8}}, {"uint64", {'U', 8}},  {"long", {'I', 8}},   {"ulong", {'U', 8}},
      {"float", {'F', 4}}, {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
  const auto known = kTypes.find(type);
  if (known == kTypes.end())
  {
    throw FormatError("has a property of an unknown type");
  }
  CloudField field;
  setType(field, known->second.letter, known->second.size);
  field.name = lowerCase(name);
  return field;
}

void takeElement(const std::vector<std::string_view>& words, Header& header)
{
  uint64_t count = 0;
  if (words.size() < 3 ||
      std::from_chars(words[2].data(), words[2].data() + words[2].size(), count).ec != std::errc())
  {
    throw FormatError("has an element without a count");
  }
  header.elements.push_back({lowerCase(words[1]), count, {}});
}

void takeProperty(const std::vector<std::string_view>& words, Header& header)
{
  const bool list = words.size() == 5 && words[1] == "list";
  if (header.elements.empty() || (words.size() != 3 && !list) ||
      header.elements.back().properties.size() >= kMostProperties)
  {
    throw FormatError("has a property that is none");
  }
  Property property;
  if (list)
  {
    property.count = fieldOf(words[2], "");
    if (property.count->kind == NumberKind::floating)
    {
      throw FormatError("has a list with a count that is no integer");
    }
  }
  property.field = list ? fieldOf(words[3], words[4]) : fieldOf(words[1], words[2]);
  header.elements.back().properties.push_back(property);
}

Header readHeader(TextLines& lines)
{
  constexpr size_t kMostLines = 2000;
  Header header;
  if (lines.line() != "ply")
  {
    throw FormatError("has no PLY header");
  }
  for (size_t i = 0; i < kMostLines && !lines.atEnd(); ++i)
  {
    const std::vector<std::string_view> words = wordsOf(lines.line());
    if (words.empty())
    {
      continue;
    }
    if (words[0] == "end_header")
    {
      return header;
    }
    if (words[0] == "format" && words.size() > 1)
    {
      header.format = words[1];
    }
    else if (words[0] == "element")
    {
      takeElement(words, header);
    }
    else if (words[0] == "property")
    {
      takeProperty(words, header);
    }
  }
  throw FormatError("has a PLY header without an end");
}

/** The length of a list, from one number. */
size_t lengthOf(const CloudField& count, const std::string& raw, bool big_endian)
{
  CloudTable one;
  one.bytes = raw;
  one.big_endian = big_endian;
  const int64_t length = one.integer(count, 0);
  if (length < 0)
  {
    throw FormatError("has a list of negative length");
  }
  return static_cast<size_t>(length);
}

void skipBinary(const Element& element, ByteReader& in, bool big_endian)
{
  for (size_t i = 0; i < element.count && !element.properties.empty(); ++i)
  {
    for (const Property& property : element.properties)
    {
      size_t n = 1;
      if (property.count)
      {
        n = lengthOf(*property.count, std::string(in.raw(property.count->size)), big_endian);
      }
      if (n > in.remaining() / property.field.size)
      {
        throw FormatError("is cut short");
      }
      in.raw(n * property.field.size);
    }
  }
}

void skipWords(size_t n, TextLines& lines)
{
  for (size_t i = 0; i < n; ++i)
  {
    if (lines.word().empty())
    {
      throw FormatError("is cut short");
    }
  }
}

void skipText(const Element& element, TextLines& lines)
{
  for (size_t i = 0; i < element.count && !element.properties.empty(); ++i)
  {
    for (const Property& property : element.properties)
    {
      std::string raw;
      size_t n = 1;
      if (property.count)
      {
        appendText(raw, *property.count, lines.word());
        n = lengthOf(*property.count, raw, false);
      }
      skipWords(n, lines);
    }
  }
}

std::vector<CloudField> fieldsOf(const Element& vertex)
{
  std::vector<CloudField> fields;
  for (const Property& property : vertex.properties)
  {
    if (property.count)
    {
      throw FormatError("has lists in its vertices");
    }
    fields.push_back(property.field);
  }
  return fields;
}

CloudFile readText(const Header& header, size_t vertex, std::string_view data)
{
  TextLines lines(data);
  for (size_t i = 0; i < vertex; ++i)
  {
    skipText(header.elements[i], lines);
  }
  CloudTable table;
  table.points = header.elements[vertex].count;
  table.fields = fieldsOf(header.elements[vertex]);
  const size_t stride = layOut(table.fields);
  if (table.fields.empty() || table.points > (data.size() + 1) / table.fields.size())
  {
    throw FormatError("is cut short");
  }
  table.storage.reserve(stride * table.points);
  for (size_t i = 0; i < table.points; ++i)
  {
    for (const CloudField& field : table.fields)
    {
      appendText(table.storage, field, lines.word());
    }
  }
  table.bytes = table.storage;
  return cloudOf(table);
}

CloudFile readBinary(const Header& header, size_t vertex, std::string_view data, bool big_endian)
{
  ByteReader in(data, "PLY data");
  for (size_t i = 0; i < vertex; ++i)
  {
    skipBinary(header.elements[i], in, big_endian);
  }
  CloudTable table;
  table.big_endian = big_endian;
  table.points = header.elements[vertex].count;
  table.fields = fieldsOf(header.elements[vertex]);
  const size_t stride = layOut(table.fields);
  if (stride == 0 || table.points > in.remaining() / stride)
  {
    throw FormatError("is cut short");
  }
  table.bytes = in.raw(table.points * stride);
  return cloudOf(table);
}
}  // namespace

CloudFile readPly(std::string_view bytes)
{
  TextLines lines(bytes);
  const Header header = readHeader(lines);
  const auto vertex = std::find_if(
      header.elements.begin(), header.elements.end(),
      [](const Element& element) { return element.name == "vertex"; });
  if (vertex == header.elements.end())
  {
    throw FormatError("has no element vertex");
  }
  const auto at = static_cast<size_t>(vertex - header.elements.begin());
  const std::string_view data = bytes.substr(std::min(lines.position(), bytes.size()));
  if (header.format == "ascii")
  {
    return readText(header, at, data);
  }
  if (header.format != "binary_little_endian" && header.format != "binary_big_endian")
  {
    throw FormatError("its PLY format is unknown");
  }
  return readBinary(header, at, data, header.format == "binary_big_endian");
}
}  // namespace traverse::formats
