// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>
#include <zlib.h>

namespace traverse::logs
{
/** The bytes of a file, unpacked where it is gzip (any number of members, one after the other), and
 * where and why they end. */
class ByteSource
{
 public:
  /** Reads from the start of an open file, which stays the caller's. */
  explicit ByteSource(int fd);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /** Fills the buffer as far as there are bytes; fewer only at the end, good or bad. */
  size_t read(void* buffer, size_t n);

  /** Bytes of the file that were used. */
  uint64_t offset() const { return offset_ - input_.size() + used_; }

  bool compressed() const { return compressed_; }

  /** Why the bytes ended too early; empty where they did not (so far). */
  const std::string& damage() const { return damage_; }

 private:
  bool refill();
  size_t readPlain(uint8_t* to, size_t n);
  size_t inflateSome(uint8_t* to, size_t n);
  bool nextMember();

  int fd_;
  std::vector<uint8_t> input_;
  size_t used_ = 0;      // of input_
  uint64_t offset_ = 0;  // of the file, at the end of input_
  bool compressed_ = false;
  bool ended_ = false;
  std::string damage_;
  z_stream zlib_{};
};
}  // namespace traverse::logs
