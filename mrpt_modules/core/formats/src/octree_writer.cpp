// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "octree_writer.h"

#include <traverse/formats/bytes.h>

#include <array>
#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
constexpr unsigned kChildren = 8;

/** .bt, as octree_file.cpp reads it. */
void writeBinary(const octomap::OcTree& tree, const octomap::OcTreeNode& node, ByteWriter& out)
{
  constexpr unsigned kFree = 1;
  constexpr unsigned kOccupied = 2;
  constexpr unsigned kInner = 3;
  std::array<const octomap::OcTreeNode*, kChildren> inner{};
  unsigned kinds = 0;
  for (unsigned i = 0; i < kChildren; ++i)
  {
    if (tree.nodeChildExists(&node, i))
    {
      const octomap::OcTreeNode* child = tree.getNodeChild(&node, i);
      const bool is_inner = tree.nodeHasChildren(child);
      inner.at(i) = is_inner ? child : nullptr;
      kinds |= (is_inner ? kInner : tree.isNodeOccupied(child) ? kOccupied : kFree) << (2 * i);
    }
  }
  out.u16(static_cast<uint16_t>(kinds));
  for (const octomap::OcTreeNode* child : inner)
  {
    if (child != nullptr)
    {
      writeBinary(tree, *child, out);
    }
  }
}

/** .ot, the same. */
void writeFull(const octomap::OcTree& tree, const octomap::OcTreeNode& node, ByteWriter& out)
{
  unsigned children = 0;
  for (unsigned i = 0; i < kChildren; ++i)
  {
    children |= static_cast<unsigned>(tree.nodeChildExists(&node, i)) << i;
  }
  out.f32(node.getLogOdds());
  out.u8(static_cast<uint8_t>(children));
  for (unsigned i = 0; i < kChildren; ++i)
  {
    if ((children >> i & 1U) == 1)
    {
      writeFull(tree, *tree.getNodeChild(&node, i), out);
    }
  }
}

using Write = void (*)(const octomap::OcTree&, const octomap::OcTreeNode&, ByteWriter&);

std::string fileOf(const octomap::OcTree& tree, const char* title, Write write)
{
  ByteWriter out;
  out.raw(fmt::format(
      "{}\nid OcTree\nsize {}\nres {}\ndata\n", title, tree.size(), tree.getResolution()));
  if (const octomap::OcTreeNode* root = tree.getRoot())
  {
    write(tree, *root, out);
  }
  return out.take();
}
}  // namespace

std::string binaryOctreeFile(const octomap::OcTree& tree)
{
  return fileOf(tree, "# Octomap OcTree binary file", writeBinary);
}

std::string fullOctreeFile(const octomap::OcTree& tree)
{
  return fileOf(tree, "# Octomap OcTree file", writeFull);
}
}  // namespace traverse::formats
