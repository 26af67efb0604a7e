// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/octree_file.h>

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace traverse::formats
{
namespace
{
constexpr std::string_view kBinaryTitle = "# Octomap OcTree binary file";
constexpr std::string_view kFullTitle = "# Octomap OcTree file";
constexpr int kDeepest = 16;  // nodes of this depth are the finest leaves
constexpr int kChildren = 8;

struct Header
{
  bool is_binary = false;
  uint64_t nodes = 0;
  double resolution_m = 0;
  size_t size = 0;  // bytes, the line "data" included
};

template <class T>
T number(std::string_view text, const char* what)
{
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
  {
    throw FormatError(fmt::format("octree: the header's {} is no number", what));
  }
  return value;
}

std::string_view trimmed(std::string_view line)
{
  constexpr std::string_view kBlank = " \t\r";
  const size_t from = std::min(line.find_first_not_of(kBlank), line.size());
  return line.substr(from, line.find_last_not_of(kBlank) + 1 - from);
}

/** Takes `id`, `size` or `res`; other lines are refused. */
void readHeaderLine(std::string_view line, Header& header)
{
  const size_t space = line.find(' ');
  const std::string_view key = line.substr(0, space);
  const std::string_view value =
      space == std::string_view::npos ? std::string_view{} : trimmed(line.substr(space));
  if (key == "id" && value == "OcTree")
  {
    return;
  }
  if (key == "size")
  {
    header.nodes = number<uint64_t>(value, "size");
  }
  else if (key == "res")
  {
    header.resolution_m = number<double>(value, "res");
  }
  else
  {
    throw FormatError(
        key == "id" ? "octree: of another type than OcTree (colours, stamps): not read here"
                    : "octree: a line in the header that is none of id, size, res, data");
  }
}

Header readHeader(std::string_view bytes)
{
  constexpr size_t kLongestHeader = 65536;
  Header header;
  header.is_binary = bytes.starts_with(kBinaryTitle);
  if (!header.is_binary && !bytes.starts_with(kFullTitle))
  {
    throw FormatError("not an octree: it begins as no .bt and no .ot file of OctoMap does");
  }
  const std::string_view head = bytes.substr(0, kLongestHeader);
  for (size_t at = 0; at < head.size();)
  {
    const size_t end = head.find('\n', at);
    if (end == std::string_view::npos)
    {
      break;
    }
    const std::string_view line = trimmed(head.substr(at, end - at));
    at = end + 1;
    if (line == "data")
    {
      header.size = at;
      break;
    }
    if (!line.empty() && line.front() != '#')
    {
      readHeaderLine(line, header);
    }
  }
  if (header.size == 0)
  {
    throw FormatError("octree truncated: its header has no end");
  }
  if (!(header.resolution_m >= 1e-4 && header.resolution_m <= 1e4))
  {
    throw FormatError("octree: a resolution outside 0.0001 to 10000 m");
  }
  return header;
}

/** The smallest leaf of a node, and the node's depth below the root. */
struct Node
{
  uint32_t x = 0;
  uint32_t y = 0;
  uint32_t z = 0;
  int depth = 0;

  /** Leaves along an edge. */
  uint32_t side() const { return 1U << static_cast<unsigned>(kDeepest - depth); }

  Node child(int i) const
  {
    const uint32_t half = side() / 2;
    return {
        x + ((i & 1) != 0 ? half : 0), y + ((i & 2) != 0 ? half : 0), z + ((i & 4) != 0 ? half : 0),
        depth + 1};
  }
};

/** Walks the nodes, depth first as they stand in the file; no deeper than the tree can be. */
class Walk
{
 public:
  /** Only nodes above the depth `leaves_at` may have nodes of their own below them. Leaves are
   * collected where `occupied` is given, and counted anyway. */
  Walk(ByteReader in, int leaves_at, OctreeSummary& summary, std::vector<OctreeKey>* occupied) :
      in_(std::move(in)), leaves_at_(leaves_at), summary_(summary), occupied_(occupied)
  {
  }

  /** .bt: two bits a child: 1 free, 2 occupied, 3 a node of its own. */
  void binary(const Node& node)
  {
    ++summary_.nodes;
    const uint16_t children = in_.u16();
    if (children == 0)
    {
      in_.fail("a node with children that has none");
    }
    for (int i = 0; i < kChildren; ++i)
    {
      const unsigned kind = static_cast<unsigned>(children >> (2 * i)) & 3U;
      summary_.nodes += static_cast<uint64_t>(kind == 1 || kind == 2);
      summary_.free_leaves += static_cast<uint64_t>(kind == 1);
      if (kind == 2)
      {
        takeOccupied(node.child(i));
      }
    }
    for (int i = 0; i < kChildren; ++i)
    {
      if ((static_cast<unsigned>(children >> (2 * i)) & 3U) == 3)
      {
        binary(deeper(node, i));
      }
    }
  }

  /** .ot: log-odds, then one bit a child. */
  void full(const Node& node)
  {
    ++summary_.nodes;
    const float log_odds = in_.f32();
    const uint8_t children = in_.u8();
    if (!std::isfinite(log_odds))
    {
      in_.fail("log-odds that are no number");
    }
    if (children == 0 && log_odds >= 0)
    {
      takeOccupied(node);
    }
    summary_.free_leaves += static_cast<uint64_t>(children == 0 && log_odds < 0);
    for (int i = 0; i < kChildren; ++i)
    {
      if ((static_cast<unsigned>(children >> i) & 1U) == 1)
      {
        full(deeper(node, i));
      }
    }
  }

  void expectEnd() const { in_.expectEnd(); }

 private:
  Node deeper(const Node& node, int i) const
  {
    if (node.depth >= leaves_at_)
    {
      in_.fail("nodes below the finest leaves");
    }
    return node.child(i);
  }

  void takeOccupied(const Node& node)
  {
    const uint64_t side = node.side();
    summary_.occupied_leaves += side * side * side;  // never above the 2^48 of all space
    for (uint64_t i = 0; occupied_ != nullptr && i < side * side * side; ++i)
    {
      occupied_->push_back(
          {static_cast<uint16_t>(node.x + i % side),
           static_cast<uint16_t>(node.y + i / side % side),
           static_cast<uint16_t>(node.z + i / side / side)});
    }
  }

  ByteReader in_;
  int leaves_at_;
  OctreeSummary& summary_;
  std::vector<OctreeKey>* occupied_;
};

OctreeSummary walk(std::string_view bytes, std::vector<OctreeKey>* occupied)
{
  const Header header = readHeader(bytes);
  OctreeSummary summary;
  summary.resolution_m = header.resolution_m;
  summary.tree = bytes.substr(header.size);
  // In .bt a leaf is two bits of its parent; in .ot it is a node.
  const int leaves_at = header.is_binary ? kDeepest - 1 : kDeepest;
  Walk walk(ByteReader(summary.tree, "octree", header.size), leaves_at, summary, occupied);
  if (header.nodes > 0)
  {
    header.is_binary ? walk.binary({}) : walk.full({});
  }
  walk.expectEnd();
  if (summary.nodes != header.nodes)
  {
    throw FormatError(fmt::format(
        "octree damaged: its header says {} nodes, {} are there", header.nodes, summary.nodes));
  }
  return summary;
}
}  // namespace

OctreeSummary checkOctree(std::string_view bytes)
{
  return walk(bytes, nullptr);
}

Octree readOctree(std::string_view bytes, size_t most_leaves)
{
  const OctreeSummary summary = checkOctree(bytes);
  if (summary.occupied_leaves > most_leaves)
  {
    throw FormatError(fmt::format(
        "octree: {} occupied leaves of the finest size, at most {} are read",
        summary.occupied_leaves, most_leaves));
  }
  Octree octree{summary.resolution_m, {}};
  octree.occupied.reserve(summary.occupied_leaves);
  walk(bytes, &octree.occupied);
  return octree;
}
}  // namespace traverse::formats
