// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/json_text.h>
#include <traverse/formats/checksum.h>

namespace traverse::app
{
/** Over all but the checksum itself. */
inline uint32_t metricsChecksum(Json json)
{
  json.erase("crc32");
  return formats::crc32(textOf(json));
}
}  // namespace traverse::app
