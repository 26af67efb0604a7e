// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/layers/height_slabs.h>

namespace traverse::layers
{
HeightSlab* HeightSlabs::obtain(int32_t& head, int32_t level)
{
  int32_t* link = &head;
  while (*link != kNone && at(*link).level < level)
  {
    link = &at(*link).next;
  }
  if (*link != kNone && at(*link).level == level)
  {
    return &at(*link);
  }
  const int32_t fresh = take();
  if (fresh == kNone)
  {
    return nullptr;
  }
  HeightSlab& slab = at(fresh);
  slab = HeightSlab{};
  slab.level = level;
  slab.next = *link;
  *link = fresh;
  return &slab;
}

int32_t HeightSlabs::take()
{
  if (used_ >= most_)
  {
    return kNone;
  }
  if (free_ == kNone && made_ == chunks_.size() * kChunk)
  {
    chunks_.emplace_back();
  }
  ++used_;
  if (free_ == kNone)
  {
    return static_cast<int32_t>(made_++);
  }
  const int32_t slab = free_;
  free_ = at(slab).next;
  return slab;
}

void HeightSlabs::release(int32_t& head)
{
  while (head != kNone)
  {
    HeightSlab& slab = at(head);
    const int32_t next = slab.next;
    slab.next = free_;
    free_ = head;
    head = next;
    --used_;
  }
}

void HeightSlabs::clear()
{
  chunks_.clear();
  made_ = 0;
  used_ = 0;
  free_ = kNone;
}
}  // namespace traverse::layers
