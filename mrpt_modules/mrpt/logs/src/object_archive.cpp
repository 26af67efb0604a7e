// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "object_archive.h"

#include <traverse/observations/cause.h>

#include <mrpt/rtti/CObject.h>

#include <algorithm>
#include <cctype>

namespace traverse::logs
{
namespace
{
constexpr uint8_t kNewFormat = 0x80;
constexpr uint8_t kEndMark = 0x88;
constexpr size_t kLongestType = 120;
constexpr uint64_t kLargestObject = uint64_t{1} << 30U;

bool isTypeName(const std::string& name)
{
  return !name.empty() && std::all_of(
                              name.begin(), name.end(),
                              [](unsigned char c)
                              {
                                return std::isalnum(c) != 0 ||
                                       std::string_view("_:<>, ").find(static_cast<char>(c)) !=
                                           std::string_view::npos;
                              });
}
}  // namespace

void ObjectArchive::fail(const std::string& why)
{
  // The first reason explains all that comes of it, and one of the bytes themselves (cut short, bad
  // check sum) even that.
  fault_ = fault_.empty() ? why : fault_;
  throw LogDamage(source_.damage().empty() ? fault_ : source_.damage());
}

size_t ObjectArchive::write(const void* /*buffer*/, size_t /*length*/)
{
  return 0;
}

size_t ObjectArchive::read(void* buffer, size_t length)
{
  body_bytes_ += length;
  if (body_bytes_ > kLargestObject)
  {
    fail("an object of absurd size");
  }
  const size_t got = source_.read(buffer, length);
  progress_.offset = source_.offset();
  if (got < length)
  {
    fail("the file is cut short within an object");
  }
  return got;
}

std::optional<ObjectHeader> ObjectArchive::readHeader()
{
  body_bytes_ = 0;
  fault_.clear();
  uint8_t length = 0;
  if (source_.read(&length, 1) == 0)
  {
    if (!source_.damage().empty())
    {
      fail("");
    }
    return std::nullopt;
  }
  ObjectHeader header;
  header.old_format = (length & kNewFormat) == 0;
  if (header.old_format && ReadAs<uint16_t>() + ReadAs<uint8_t>() != 0)
  {
    fail("no object begins here");
  }
  length &= static_cast<uint8_t>(~kNewFormat);
  header.type.resize(length);
  if (length > kLongestType || length == 0)
  {
    fail("no object begins here");
  }
  ReadBuffer(header.type.data(), length);
  if (!isTypeName(header.type))
  {
    fail("no object begins here");
  }
  progress_.setType(header.type);
  if (header.old_format)
  {
    header.version = static_cast<uint8_t>(std::clamp(ReadAs<int32_t>(), 0, 255));
  }
  else if (!header.null())
  {
    header.version = ReadAs<uint8_t>();
  }
  return header;
}

void ObjectArchive::readBody(mrpt::serialization::CSerializable* object, const ObjectHeader& header)
{
  try
  {
    internal_ReadObject(
        object, header.type, header.old_format, static_cast<int8_t>(header.version));
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const LogDamage&)
  {
    throw;
  }
  catch (const std::exception& e)
  {
    fail("an object that cannot be read (" + observations::causeOf(e) + ")");
  }
}

void ObjectArchive::readEndMark(const ObjectHeader& header)
{
  if (!header.old_format && ReadAs<uint8_t>() != kEndMark)
  {
    fail("an object does not end where it should");
  }
}

mrpt::serialization::CSerializable::Ptr ObjectArchive::create(const ObjectHeader& header)
{
  if (header.null())
  {
    return {};
  }
  const mrpt::rtti::TRuntimeClassId* type = mrpt::rtti::findRegisteredClass(header.type);
  if (type == nullptr)
  {
    throw LogDamage("an object of the unknown class '" + header.type + "'");
  }
  auto object = std::dynamic_pointer_cast<mrpt::serialization::CSerializable>(type->createObject());
  if (!object)
  {
    throw LogDamage("an object of class '" + header.type + "', which is never stored");
  }
  return object;
}

mrpt::serialization::CSerializable::Ptr ObjectArchive::readWhole()
{
  const auto header = readHeader();
  if (!header)
  {
    fail("the file is cut short within an object");
  }
  auto object = create(*header);
  readBody(object.get(), *header);
  return object;
}
}  // namespace traverse::logs
