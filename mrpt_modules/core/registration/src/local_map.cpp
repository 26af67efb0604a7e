// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/registration/local_map.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <stdexcept>

namespace traverse::registration
{
namespace
{
constexpr double kFurthest = 1e9;  // voxels from the origin: within int32
constexpr int kFewestNeighbours = 6;

/** The 27 voxels about one, in a fixed order: ties go to the first. */
constexpr std::array<std::array<int, 3>, 27> neighbourhood()
{
  std::array<std::array<int, 3>, 27> all{};
  for (int i = 0; i < 27; ++i)
  {
    all[static_cast<size_t>(i)] = {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
  }
  return all;
}

constexpr std::array<std::array<int, 3>, 27> kNeighbourhood = neighbourhood();

/** Sums over points near a place. */
struct Moments
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  int n = 0;

  void add(const Eigen::Vector3d& d)
  {
    sum += d;
    squares += d * d.transpose();
    ++n;
  }
};

/** The plane through points with these moments about `p`. Its weight is the square of how flat they
 * lie, (s1 - s0) / s2 with s0 <= s1 <= s2 their standard deviations along their own axes. */
Surface planeOf(const Moments& moments, const Eigen::Vector3d& p)
{
  Surface surface;
  if (moments.n < kFewestNeighbours)
  {
    return surface;
  }
  const Eigen::Vector3d mean = moments.sum / moments.n;
  const Eigen::Matrix3d covariance = moments.squares / moments.n - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  const Eigen::Vector3d deviation = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  surface.mean = p + mean;
  surface.normal = axes.eigenvectors().col(0);
  const double flatness = deviation[2] > 0 ? (deviation[1] - deviation[0]) / deviation[2] : 0;
  surface.weight = flatness * flatness;
  surface.looseness = (1 - flatness) * (1 - flatness);
  return surface;
}
}  // namespace

LocalMap::LocalMap(double voxel_m) :
    voxel_m_(voxel_m),
    spacing_m_(voxel_m / std::sqrt(static_cast<double>(kMostPoints))),
    slots_(1024, 0)
{
  if (!std::isfinite(voxel_m) || voxel_m <= 0)
  {
    throw std::invalid_argument("LocalMap: the edge of a voxel must be positive");
  }
}

LocalMap::Index LocalMap::indexOf(const Eigen::Vector3d& p) const
{
  return (p / voxel_m_).array().floor().matrix().cast<int>();
}

Eigen::Vector3d LocalMap::cornerOf(const Index& index) const
{
  return index.cast<double>() * voxel_m_;
}

size_t LocalMap::slotOf(const Index& index) const
{
  uint64_t h = static_cast<uint32_t>(index.x()) * uint64_t{0x9e3779b97f4a7c15};
  h = (h ^ static_cast<uint32_t>(index.y())) * uint64_t{0xbf58476d1ce4e5b9};
  h = (h ^ static_cast<uint32_t>(index.z())) * uint64_t{0x94d049bb133111eb};
  size_t slot = (h >> 29U) & (slots_.size() - 1);
  while (slots_[slot] != 0 && voxels_[slots_[slot] - 1].index != index)
  {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  return slot;
}

LocalMap::Voxel& LocalMap::findOrMake(const Index& index)
{
  if (2 * (voxels_.size() + 1) > slots_.size())
  {
    rehash(2 * slots_.size());
  }
  uint32_t& at = slots_[slotOf(index)];
  if (at == 0)
  {
    voxels_.emplace_back().index = index;
    at = static_cast<uint32_t>(voxels_.size());
  }
  return voxels_[at - 1];
}

void LocalMap::rehash(size_t slots)
{
  slots_.assign(slots, 0);
  for (size_t i = 0; i < voxels_.size(); ++i)
  {
    slots_[slotOf(voxels_[i].index)] = static_cast<uint32_t>(i + 1);
  }
}

void LocalMap::add(std::span<const Eigen::Vector3d> points)
{
  surfaces_.clear();
  ++age_;
  for (const Eigen::Vector3d& p : points)
  {
    const bool usable = p.cwiseAbs().maxCoeff() < kFurthest * voxel_m_ && p.allFinite();
    if (!usable)
    {
      continue;
    }
    const Index index = indexOf(p);
    if (voxels_.size() >= kMostVoxels && slots_[slotOf(index)] == 0)
    {
      continue;
    }
    Voxel& voxel = findOrMake(index);
    const Eigen::Vector3f at = (p - cornerOf(index)).cast<float>();
    bool wanted = voxel.size < kMostPoints;
    for (uint32_t i = 0; i < voxel.size && wanted; ++i)
    {
      wanted =
          (voxel.entries[i].p - at).squaredNorm() >= static_cast<float>(spacing_m_ * spacing_m_);
    }
    if (wanted)
    {
      voxel.entries[voxel.size++].p = at;
    }
  }
}

void LocalMap::forgetBeyond(const Eigen::Vector3d& centre, double reach_m)
{
  const double half = voxel_m_ / 2;
  const size_t before = voxels_.size();
  std::erase_if(
      voxels_,
      [&](const Voxel& voxel)
      {
        const Eigen::Vector3d middle = cornerOf(voxel.index).array() + half;
        return (middle - centre).squaredNorm() > reach_m * reach_m;
      });
  if (voxels_.size() != before)
  {
    rehash(slots_.size());
    surfaces_.clear();
    ++age_;
  }
}

size_t LocalMap::points() const
{
  size_t sum = 0;
  for (const Voxel& voxel : voxels_)
  {
    sum += voxel.size;
  }
  return sum;
}

const Surface* LocalMap::nearest(const Eigen::Vector3d& p, double reach_m)
{
  const bool usable = p.cwiseAbs().maxCoeff() < kFurthest * voxel_m_ && p.allFinite();
  if (!usable)
  {
    return nullptr;
  }
  const Index home = indexOf(p);
  auto best = static_cast<float>(reach_m * reach_m);
  Voxel* voxel = nullptr;
  uint32_t entry = 0;
  for (const auto& [dx, dy, dz] : kNeighbourhood)
  {
    const Index index = home + Index(dx, dy, dz);
    const uint32_t at = slots_[slotOf(index)];
    if (at == 0)
    {
      continue;
    }
    Voxel& other = voxels_[at - 1];
    const Eigen::Vector3f from = (p - cornerOf(index)).cast<float>();
    for (uint32_t i = 0; i < other.size; ++i)
    {
      const float d2 = (other.entries[i].p - from).squaredNorm();
      if (d2 < best)
      {
        best = d2;
        voxel = &other;
        entry = i;
      }
    }
  }
  return voxel == nullptr ? nullptr : &surfaceOf(*voxel, voxel->entries[entry]);
}

const Surface& LocalMap::surfaceOf(const Voxel& voxel, Entry& entry)
{
  if (entry.age != age_)
  {
    const Eigen::Vector3d p = cornerOf(voxel.index) + entry.p.cast<double>();
    entry.age = age_;
    entry.surface = static_cast<uint32_t>(surfaces_.size());
    surfaces_.push_back(surfaceAround(voxel.index, p));
  }
  return surfaces_[entry.surface];
}

Surface LocalMap::surfaceAround(const Index& home, const Eigen::Vector3d& p) const
{
  Moments moments;
  for (const auto& [dx, dy, dz] : kNeighbourhood)
  {
    const Index index = home + Index(dx, dy, dz);
    const uint32_t at = slots_[slotOf(index)];
    if (at == 0)
    {
      continue;
    }
    const Voxel& voxel = voxels_[at - 1];
    const Eigen::Vector3d corner = cornerOf(index) - p;
    for (uint32_t i = 0; i < voxel.size; ++i)
    {
      const Eigen::Vector3d d = corner + voxel.entries[i].p.cast<double>();
      if (d.squaredNorm() < voxel_m_ * voxel_m_)
      {
        moments.add(d);
      }
    }
  }
  return planeOf(moments, p);
}
}  // namespace traverse::registration
