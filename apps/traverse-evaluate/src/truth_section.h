// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scores.h"

#include <traverse/formats/report.h>

namespace traverse::app
{
/** The scores for people. */
formats::Section truthSection(const Scores& scores);
}  // namespace traverse::app
