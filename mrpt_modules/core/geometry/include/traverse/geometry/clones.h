// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** Before a function's definition: compiles it for several generations of processors, of which the
 * running one's is called. The bits of results do not depend on it as long as contraction is off
 * (CMakeLists.txt), and only in files that see no types of Eigen or MRPT: their inline functions
 * and alignments change with the target, and the linker keeps any one of them. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define TRAVERSE_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define TRAVERSE_CLONES
#endif
