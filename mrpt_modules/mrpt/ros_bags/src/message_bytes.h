// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "messages.h"

#include <traverse/formats/bytes.h>

#include <optional>

namespace traverse::ros_bags
{
/** ROS 1 serialisation: little-endian, nothing aligned, texts and arrays behind a u32 count. */
class MessageBytes : public formats::ByteReader
{
 public:
  using ByteReader::ByteReader;

  int64_t time();
  Header header();

  std::string text() { return str(kLongestText); }

  /** A frame's name, without a leading slash (tf's old style). */
  std::string frame();

  /** A count (u32) of elements that take at least element_bytes each. */
  size_t elements(size_t element_bytes);

  /** A count (u32) of bytes, and those. */
  std::string_view blob() { return raw(elements(1)); }

  template <class T>
  std::vector<T> numbers()
  {
    std::vector<T> values(elements(sizeof(T)));
    copy(values.data(), values.size() * sizeof(T));
    return values;
  }

  template <class T, size_t N>
  std::array<T, N> fixed()
  {
    std::array<T, N> values;
    copy(values.data(), sizeof(values));
    return values;
  }

  Eigen::Vector3d vector();

  /** x y z, then a quaternion x y z w; nothing where that is no rigid motion. */
  std::optional<Eigen::Isometry3d> motionIfAny();

  /** Fails where that is none. */
  Eigen::Isometry3d motion();

 private:
  static constexpr size_t kLongestText = 4096;

  void copy(void* to, size_t bytes)
  {
    const std::string_view from = raw(bytes);
    if (bytes > 0)
    {
      std::memcpy(to, from.data(), bytes);
    }
  }
};
}  // namespace traverse::ros_bags
