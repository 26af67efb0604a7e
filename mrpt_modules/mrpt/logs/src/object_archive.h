// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "byte_source.h"

#include <traverse/sandbox/shared_progress.h>

#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace traverse::logs
{
using sandbox::SharedProgress;

/** A log that goes on with something that is none; what() says what, without file and place. */
class LogDamage : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** What stands before an object in MRPT's serialisation. */
struct ObjectHeader
{
  std::string type;
  bool old_format = false;  //!< of before 2005: no mark at the end
  uint8_t version = 0;

  bool null() const { return type == "nullptr"; }
};

/** MRPT's archive over our bytes: a short read is an error (MRPT would go on with whatever stood in
 * memory), and so is an object that never ends. */
class ObjectArchive : public mrpt::serialization::CArchive
{
 public:
  ObjectArchive(ByteSource& source, SharedProgress& progress) : source_(source), progress_(progress)
  {
  }

  /** Nothing at the end of the bytes. Throws LogDamage for anything that is no header. */
  std::optional<ObjectHeader> readHeader();

  /** The body and end mark of an object that was created by its header; nullptr for a null one. */
  void readBody(mrpt::serialization::CSerializable* object, const ObjectHeader& header);

  /** The mark behind an object whose body was read value by value. */
  void readEndMark(const ObjectHeader& header);

  /** An object by its header, of a class that MRPT knows; throws LogDamage. */
  static mrpt::serialization::CSerializable::Ptr create(const ObjectHeader& header);

  /** A header and a body. */
  mrpt::serialization::CSerializable::Ptr readWhole();

  const ByteSource& source() const { return source_; }

 protected:
  size_t write(const void* buffer, size_t length) override;
  size_t read(void* buffer, size_t length) override;

 private:
  [[noreturn]] void fail(const std::string& why);

  ByteSource& source_;
  SharedProgress& progress_;
  uint64_t body_bytes_ = 0;
  std::string fault_;  // of this object; MRPT's readers swallow exceptions and throw their own
};
}  // namespace traverse::logs
