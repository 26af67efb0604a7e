// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/bytes.h>

#include <nlohmann/json.hpp>
#include <string>

namespace traverse::app
{
using Json = nlohmann::ordered_json;

/** Labels come from the log: bytes that are not UTF-8 are replaced, never an exception. */
inline std::string textOf(const Json& json)
{
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

/** A metrics.json, of anybody: texts are written and compared by recursion, so depth is bounded.
 * Throws FormatError, or Json's own exceptions. */
inline Json parsedMetrics(const std::string& text)
{
  const auto refuse_depth = [](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/)
  {
    constexpr int kDeepest = 8;
    if (depth > kDeepest)
    {
      throw formats::FormatError(
          "is damaged: objects within objects, deeper than a run writes them");
    }
    return true;
  };
  return Json::parse(text, refuse_depth);
}
}  // namespace traverse::app
