// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exports.h"
#include "metrics.h"
#include "settings.h"

#include <traverse/formats/report.h>
#include <traverse/layers/layer_set.h>

#include <string>
#include <vector>

namespace traverse::app
{
/** The ini's title, or the log's name. */
std::string titleOf(const Settings& settings);

/** The section of a map: pictures, legend, a map to explore, cells by class, histograms of its
 * floating layers. */
formats::Section mapSection(
    const MapMetrics& map, const MapLayers& shown, std::vector<formats::Picture> pictures);

/** The whole page as HTML. */
std::string reportPage(
    const Settings& settings, const RunMetrics& metrics, std::vector<formats::Section> maps);
}  // namespace traverse::app
