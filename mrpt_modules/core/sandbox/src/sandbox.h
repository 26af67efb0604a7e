// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sandbox/reader_process.h>

#include <sys/types.h>

namespace traverse::sandbox
{
/** The descriptors that a child keeps. */
struct ChildFiles
{
  int input = -1;
  int frames = -1;
  int talk = -1;
};

/** Makes the calling, freshly forked process a reader: signal handlers as at birth (an interrupt
 * from the keyboard is the parent's affair), no other files, limits, death with the parent. Returns
 * the descriptors under their new numbers. Ends the process where the parent is gone already. */
ChildFiles enterSandbox(const ChildFiles& files, const ReaderLimits& limits, pid_t parent);

/** Address space (or, of another process, resident memory) now, bytes; 0 where it is not known. */
uint64_t addressSpace();
uint64_t residentMemory(pid_t pid);

/** Processor time used so far, s; 0 where it is not known. */
double processorTime(pid_t pid);
}  // namespace traverse::sandbox
