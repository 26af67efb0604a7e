// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace traverse::formats
{
/** The bytes as a gzip file, without name or time: the same bytes give the same file. */
std::string gzip(std::string_view bytes);

/** gzip() of bytes that come one after the other. */
class GzipStream
{
 public:
  GzipStream();
  ~GzipStream();
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;

  /** What can be written of the file by now; may be empty. */
  std::string add(std::string_view bytes);

  /** The rest; nothing may be added afterwards. */
  std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/** True for bytes that begin as a gzip file. */
bool isGzip(std::string_view bytes);

/** What a gzip file of one or more members holds. Throws FormatError where it is damaged, cut
 * short, or holds more than max_bytes. */
std::string gunzip(std::string_view bytes, size_t max_bytes);
}  // namespace traverse::formats
