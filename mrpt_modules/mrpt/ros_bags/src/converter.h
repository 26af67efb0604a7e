// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bag_wire.h"
#include "convert.h"
#include "known_types.h"

#include <optional>

namespace traverse::ros_bags
{
/** Messages one by one, as they were recorded, to observations. */
class Converter
{
 public:
  Converter(Preview preview, Notes& notes) : around_(std::move(preview), notes) {}

  /** Nothing where it is none, which is noted. */
  std::optional<Pending> convert(const BagMessage& message);

 private:
  std::optional<Pending> convert(const BagMessage& message, MessageKind kind);
  std::optional<Pending> finish(
      const BagMessage& message, const Header& header, importing::Entry entry);
  Origin originOf(const BagMessage& message, const Header& header);

  Surroundings around_;
};
}  // namespace traverse::ros_bags
