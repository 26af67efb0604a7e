// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sandbox/reader_process.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

// What a child says to its parent: frames of a header and a flat payload, in the machine's own byte
// order (both ends are one program). The parent trusts none of it.
namespace traverse::sandbox
{
struct FrameHeader
{
  static constexpr uint32_t kMagic = 0x5456'4c46;
  static constexpr uint64_t kLongest = uint64_t{1} << 30U;
  uint32_t magic = kMagic;
  uint32_t type = 0;    //!< what the payload is; the rooms at both ends agree on it
  uint64_t length = 0;  //!< of the payload
};

/** A frame; its payload is good until the next one is asked for. */
struct Frame
{
  uint32_t type = 0;
  std::span<const uint8_t> payload;
};

/** A frame that no child of ours would send. */
class WireError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** The child died, was ended, or spoke nonsense; says which. */
class ReaderFailure : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** Somebody asked to stop. */
class ReaderStopped : public std::runtime_error
{
 public:
  ReaderStopped() : std::runtime_error("stopped on request") {}
};

/** The parent's end: a child, and its frames one by one. */
class FrameStream
{
 public:
  /** `stop`, set from elsewhere, makes a waiting next() return soon. Throws std::system_error where
   * there is no process or pipe to be had. */
  FrameStream(
      int input_fd,
      const ReaderLimits& limits,
      const ReaderJob& job,
      const std::atomic<bool>* stop = nullptr);

  /** The next frame, waited for; nothing once the child has left in an orderly way. Throws
   * ReaderFailure and ReaderStopped. */
  std::optional<Frame> next();

  /** Ends the child, if it still runs. */
  void finish() { process_.finish(); }

  const SharedProgress& progress() const { return process_.progress(); }

 private:
  bool frameComplete() const;
  Frame takeFrame();
  bool receiveMore();

  const std::atomic<bool>* stop_;
  ReaderProcess process_;
  std::vector<uint8_t> received_;
  size_t used_ = 0;
};

/** The child's end: writes all of it. Throws std::system_error where nobody listens any more. */
void writeAll(int frames_fd, std::span<const uint8_t> bytes);
}  // namespace traverse::sandbox
