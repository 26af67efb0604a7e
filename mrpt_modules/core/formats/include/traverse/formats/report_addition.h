// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/report.h>

#include <string>
#include <string_view>

namespace traverse::formats
{
/** A page of html() with one section more at its end, and a link to it. A section that was added
 * under the same `id` (letters, digits, '-') is replaced; the rest of the page stays as it is, byte
 * for byte, and so does its policy: the section can have no LayerMap. The same page and section
 * give the same bytes.
 *
 * Throws FormatError where the bytes are no page of html(), and std::invalid_argument for another
 * id or a section with a LayerMap. */
std::string withAddedSection(std::string_view page, std::string_view id, const Section& section);
}  // namespace traverse::formats
