// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "frame_pipe.h"

#include <cerrno>
#include <system_error>
#include <unistd.h>

namespace traverse::logs
{
void FramePipe::flush()
{
  std::vector<uint8_t>& bytes = frames_.bytes();
  size_t sent = 0;
  while (sent < bytes.size())
  {
    const ssize_t some = ::write(fd_, bytes.data() + sent, bytes.size() - sent);
    if (some < 0 && errno != EINTR)
    {
      throw std::system_error(errno, std::generic_category(), "the log reader's pipe");
    }
    sent += some > 0 ? static_cast<size_t>(some) : 0;
  }
  bytes.clear();
}
}  // namespace traverse::logs
