// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace traverse::formats
{
/** Bytes or text that are not what they should be; the message says what and where. */
class FormatError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

static_assert(std::endian::native == std::endian::little, "files are little-endian");

/** Appends numbers and texts, little-endian, without padding. */
class ByteWriter
{
 public:
  void u8(uint8_t value) { append(value); }

  void u16(uint16_t value) { append(value); }

  void u32(uint32_t value) { append(value); }

  void u64(uint64_t value) { append(value); }

  void i32(int32_t value) { append(value); }

  void i64(int64_t value) { append(value); }

  void f32(float value) { append(value); }

  void f64(double value) { append(value); }

  /** Length (u32), then the bytes. Throws std::length_error beyond 4 GiB. */
  void str(std::string_view text);

  /** The bytes alone. */
  void raw(std::string_view bytes) { bytes_.append(bytes); }

  /** Count (u64), then the numbers. */
  template <class T>
  void array(std::span<const T> values)
  {
    static_assert(std::is_arithmetic_v<T>);
    u64(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }

  template <class T>
  void array(const std::vector<T>& values)
  {
    array(std::span<const T>(values));
  }

  const std::string& bytes() const { return bytes_; }

  /** The bytes, moved out. */
  std::string take() { return std::exchange(bytes_, {}); }

 private:
  template <class T>
  void append(T value)
  {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  std::string bytes_;
};

/** Takes what ByteWriter wrote out of bytes that may be hostile. Every read is checked against what
 * is left, and every count before anything is allocated; a read beyond the end throws FormatError
 * with the name given and the byte. Looks into the caller's bytes: they must outlive it. */
class ByteReader
{
 public:
  /** `first_byte` is where these bytes start in their file, for messages. */
  explicit ByteReader(std::string_view bytes, std::string name = "bytes", size_t first_byte = 0) :
      bytes_(bytes), name_(std::move(name)), first_byte_(first_byte)
  {
  }

  uint8_t u8() { return number<uint8_t>(); }

  uint16_t u16() { return number<uint16_t>(); }

  uint32_t u32() { return number<uint32_t>(); }

  uint64_t u64() { return number<uint64_t>(); }

  int32_t i32() { return number<int32_t>(); }

  int64_t i64() { return number<int64_t>(); }

  /** Any bits: NaN and Inf pass. */
  float f32() { return number<float>(); }

  /** Any bits: NaN and Inf pass. */
  double f64() { return number<double>(); }

  /** What ByteWriter::str wrote, if it is not longer than max_length. */
  std::string str(size_t max_length = 1U << 20U);

  /** The next `length` bytes. */
  std::string_view raw(size_t length);

  /** A count (u64) of elements of at least element_bytes (> 0) each that the rest can hold. */
  size_t count(size_t element_bytes);

  /** What ByteWriter::array wrote. */
  template <class T>
  std::vector<T> array()
  {
    static_assert(std::is_arithmetic_v<T>);
    const size_t size = count(sizeof(T));
    const std::string_view from = raw(size * sizeof(T));
    std::vector<T> values(size);
    if (size > 0)
    {
      std::memcpy(values.data(), from.data(), from.size());
    }
    return values;
  }

  size_t remaining() const { return bytes_.size() - next_; }

  /** Byte of the next read, counted as in the constructor. */
  size_t position() const { return first_byte_ + next_; }

  /** Throws FormatError where bytes are left. */
  void expectEnd() const;

  /** Throws FormatError: "<name>, byte <position>: <problem>". For values that make no sense. */
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  template <class T>
  T number()
  {
    T value;
    std::memcpy(&value, raw(sizeof value).data(), sizeof value);
    return value;
  }

  std::string_view bytes_;
  std::string name_;
  size_t first_byte_;
  size_t next_ = 0;
};
}  // namespace traverse::formats
