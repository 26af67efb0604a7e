// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace traverse::app
{
using Json = nlohmann::ordered_json;

/** Labels come from the log: bytes that are not UTF-8 are replaced, never an exception. */
inline std::string textOf(const Json& json)
{
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
}  // namespace traverse::app
