// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>
#include <string>

namespace traverse::formats
{
/** The tree as OctoMap's own writers write it; those also talk to stderr. Inner nodes must be up to
 * date. */
std::string binaryOctreeFile(const octomap::OcTree& tree);  //!< .bt
std::string fullOctreeFile(const octomap::OcTree& tree);    //!< .ot
}  // namespace traverse::formats
