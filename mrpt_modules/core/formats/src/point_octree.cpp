// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "octree_writer.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/octree_file.h>
#include <traverse/formats/point_octree.h>
#include <traverse/geometry/floor_divider.h>
#include <traverse/geometry/lattice.h>

#include <fmt/format.h>
#include <octomap/OcTree.h>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace traverse::formats
{
namespace
{
/** A node with its share of the arrays of children, as malloc rounds them up. */
constexpr size_t kNodeBytes = 88;
constexpr size_t kBytesPerMb = 1'000'000;
constexpr size_t kDepth = 16;

size_t mostNodes(const OctomapParams& params)
{
  return static_cast<size_t>(params.max_memory_mb) * kBytesPerMb / kNodeBytes;
}

octomap::OcTreeKey treeKey(OctreeKey k)
{
  return {k.x, k.y, k.z};
}

/** From a point of the vehicle frame to the leaf that it is in, by the lattice of all maps. */
class KeyFinder
{
 public:
  KeyFinder(const Eigen::Isometry3d& T_map_base, double resolution_m) :
      T_map_base_(T_map_base), by_leaf_(static_cast<int32_t>(geometry::toMillimetres(resolution_m)))
  {
  }

  /** Nothing, and counted, where there is no leaf for it. */
  std::optional<OctreeKey> operator()(const Eigen::Vector3f& p_base, OctreeCounts& counts) const
  {
    const Eigen::Vector3d p = T_map_base_ * p_base.cast<double>();
    if (!(p.cwiseAbs().maxCoeff() <= geometry::kFarthest_m) || !p.allFinite())
    {
      ++counts.bad_points;
      return std::nullopt;
    }
    const int64_t x = along(p.x());
    const int64_t y = along(p.y());
    const int64_t z = along(p.z());
    if (!isKey(x) || !isKey(y) || !isKey(z))
    {
      ++counts.beyond;
      return std::nullopt;
    }
    return OctreeKey{static_cast<uint16_t>(x), static_cast<uint16_t>(y), static_cast<uint16_t>(z)};
  }

 private:
  int64_t along(double metres) const
  {
    return by_leaf_(geometry::toMillimetres(metres)).quotient + OctreeKey::kZero;
  }

  static bool isKey(int64_t k) { return k >= 0 && k < int64_t{2} * OctreeKey::kZero; }

  Eigen::Isometry3d T_map_base_;
  geometry::FloorDivider by_leaf_;
};
}  // namespace

struct PointOctree::Tree
{
  explicit Tree(double resolution_m) : octomap(resolution_m) {}

  /** Inner nodes agree with their leaves, and eight equal leaves are one: what files need. It
   * depends on the set of leaves only, whenever it is done. */
  void tidy()
  {
    octomap.updateInnerOccupancy();
    octomap.prune();
  }

  octomap::OcTree octomap;
};

PointOctree::PointOctree() = default;

PointOctree::PointOctree(const OctomapParams& params) : params_(params)
{
  check(params, params.resolution_m);
  if (params.resolution_m > 0)
  {
    tree_ = std::make_unique<Tree>(params.resolution_m);
  }
}

PointOctree::PointOctree(const PointOctree& other) :
    params_(other.params_),
    counts_(other.counts_),
    tree_(other.tree_ ? std::make_unique<Tree>(*other.tree_) : nullptr)
{
}

PointOctree::PointOctree(PointOctree&&) noexcept = default;
PointOctree& PointOctree::operator=(PointOctree&&) noexcept = default;
PointOctree::~PointOctree() = default;

PointOctree& PointOctree::operator=(const PointOctree& other)
{
  if (this != &other)
  {
    *this = PointOctree(other);
  }
  return *this;
}

void PointOctree::adopt(const OctomapParams& params)
{
  if (params == params_)
  {
    return;
  }
  if (empty())
  {
    *this = PointOctree(params);
  }
  else if (params.resolution_m != params_.resolution_m)
  {
    throw std::invalid_argument("an octree with points keeps its resolution_m; clear it first");
  }
  params_ = params;
}

void PointOctree::insert(const points::Scan& scan, const Eigen::Isometry3d& T_map_base)
{
  if (!tree_)
  {
    return;
  }
  const KeyFinder key_of(T_map_base, params_.resolution_m);
  std::optional<OctreeKey> last;  // neighbours of a scan often share a leaf
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const auto key = key_of({scan.x[i], scan.y[i], scan.z[i]}, counts_);
    if (!key)
    {
      continue;
    }
    const bool is_in = key == last || take(*key);
    counts_.points += static_cast<uint64_t>(is_in);
    counts_.over_budget += static_cast<uint64_t>(!is_in);
    last = is_in ? key : last;
  }
}

bool PointOctree::take(const OctreeKey& key)
{
  octomap::OcTree& tree = tree_->octomap;
  if (tree.search(treeKey(key)) != nullptr)
  {
    return true;
  }
  if (tree.size() + kDepth > mostNodes(params_))
  {
    return false;
  }
  tree.setNodeValue(treeKey(key), tree.getClampingThresMaxLog(), true);
  return true;
}

bool PointOctree::empty() const
{
  return !tree_ || tree_->octomap.size() == 0;
}

std::string PointOctree::bt() const
{
  if (!tree_)
  {
    return {};
  }
  tree_->tidy();
  return binaryOctreeFile(tree_->octomap);
}

std::string PointOctree::ot() const
{
  if (!tree_)
  {
    return {};
  }
  tree_->tidy();
  return fullOctreeFile(tree_->octomap);
}

OctreeSummary PointOctree::checkOwn(std::string_view bytes) const
{
  const OctreeSummary summary = checkOctree(bytes);
  if (!tree_ || summary.resolution_m != params_.resolution_m || summary.free_leaves > 0 ||
      summary.nodes > mostNodes(params_))
  {
    throw FormatError(
        "octree: of another resolution than its options say, or with free leaves, or beyond "
        "max_memory_mb");
  }
  return summary;
}

PointOctree PointOctree::fromBt(std::string_view bytes, const OctomapParams& params)
{
  PointOctree octree(params);
  const OctreeSummary summary = octree.checkOwn(bytes);
  std::istringstream in{std::string(summary.tree)};
  if (summary.nodes > 0)
  {
    octree.tree_->octomap.readBinaryData(in);  // checked above: OctoMap may believe it
  }
  octree.counts_.points = summary.occupied_leaves;
  return octree;
}

void PointOctree::merge(std::string_view bt)
{
  checkOwn(bt);
  for (const OctreeKey& key : readOctree(bt).occupied)
  {
    if (!take(key))
    {
      throw std::length_error("the merged octree has no room in its max_memory_mb");
    }
    ++counts_.points;
  }
}

std::vector<layers::ExtraFile> PointOctree::files() const
{
  if (empty())
  {
    return {};
  }
  return {{".bt", bt()}, {".ot", ot()}};
}

std::vector<std::string> PointOctree::warnings() const
{
  std::vector<std::string> all;
  if (counts_.beyond > 0)
  {
    all.push_back(fmt::format(
        "octree: {} points lie further than {} m from map zero, where leaves of {} m end",
        counts_.beyond, OctreeKey::kZero * params_.resolution_m, params_.resolution_m));
  }
  if (counts_.over_budget > 0)
  {
    all.push_back(fmt::format(
        "octree: {} points found no room; raise max_memory_mb of its section octomapOpts",
        counts_.over_budget));
  }
  return all;
}
}  // namespace traverse::formats
