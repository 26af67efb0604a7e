// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "frame_pipe.h"

namespace traverse::logs
{
void FramePipe::flush()
{
  sandbox::writeAll(fd_, frames_.bytes());
  frames_.bytes().clear();
}
}  // namespace traverse::logs
