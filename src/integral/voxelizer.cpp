// SPDX-License-Identifier: BSD-3-Clause
#include "integral/voxelizer.hpp"

#include <algorithm>
#include <cmath>

#include "integral/occlusion_map.hpp"
#include "integral/voxel_kernel.hpp"

namespace objectness {
namespace {

/// The rectangle that all grids lie in.
TableRegion regionOf(const std::vector<Grid>& grids) {
  TableRegion region;
  region.low_m.setConstant(1e9), region.high_m.setConstant(-1e9);
  for (const Grid& grid : grids) {
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d q(corner % 2 * grid.nx, corner / 2 * grid.ny, 0);
      const Eigen::Vector2d p = grid.toTable(q).head<2>();
      region.low_m = region.low_m.cwiseMin(p);
      region.high_m = region.high_m.cwiseMax(p);
    }
  }
  return region;
}

TurnedGrid turned(const Grid& grid) {
  return {grid.cosine, grid.sine, grid.origin_m.x(), grid.origin_m.y(), grid.voxel_m, grid.nx, grid.ny};
}

/// Each bit of a byte eight times.
std::uint64_t spread(unsigned byte) {
  std::uint64_t word = 0;
  for (int bit = 0; bit < 8; ++bit) {
    if (byte >> bit & 1) word |= std::uint64_t{0xFF} << (8 * bit);
  }
  return word;
}

}  // namespace

Voxelizer::Voxelizer(const CuePoints& points, const VolumeConfig& config) : points_(points), config_(config) {
  all_x_.reserve(points.points.size());
  all_y_.reserve(points.points.size());
  for (const auto& p : points.points) {
    all_x_.push_back(p.x());
    all_y_.push_back(p.y());
  }
}

Voxelizer::~Voxelizer() = default;

Grid Voxelizer::gridAt(double angle_rad, int margin, int min_height, int max_height) const {
  if (points_.points.empty()) return makeGrid(points_, angle_rad, config_, margin, min_height, max_height);
  float bounds[4];
  turnedBounds(all_x_.data(), all_y_.data(), static_cast<int>(all_x_.size()), static_cast<float>(std::cos(angle_rad)),
               static_cast<float>(std::sin(angle_rad)), bounds);
  return makeGrid({bounds[0], bounds[2]}, {bounds[1], bounds[3]}, points_.top_m, angle_rad, config_, margin, min_height,
                  max_height);
}

void Voxelizer::Columns::add(const Eigen::Vector3f& p, double voxel_m, int nz) {
  const double height = std::floor(static_cast<double>(p.z()) / voxel_m);
  if (!(height >= 0 && height < nz)) return;
  x.push_back(p.x());
  y.push_back(p.y());
  z.push_back(static_cast<std::int32_t>(height));
}

void Voxelizer::prepare(const Frame& frame, const Table& table, const std::vector<Grid>& grids, int threads) {
  const int nz = grids.front().nz;
  T_table_camera_ = table.T_table_camera;
  for (const auto& p : points_.edges) edge_.add(p, config_.voxel_m, nz);

  // By label, so that a superpixel's points lie together.
  std::vector<int> next(points_.superpixels + 2, 0);
  for (const int label : points_.labels) ++next[label + 1];
  for (std::size_t s = 1; s < next.size(); ++s) next[s] += next[s - 1];
  const std::vector<int> first = next;
  std::vector<int> order(points_.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[next[points_.labels[i]]++] = static_cast<int>(i);
  for (int s = 0; s <= points_.superpixels; ++s) {
    first_of_.push_back(static_cast<int>(object_.z.size()));
    for (int k = first[s]; k < first[s + 1]; ++k) object_.add(points_.points[order[k]], config_.voxel_m, nz);
  }
  first_of_.push_back(static_cast<int>(object_.z.size()));

  occlusion_ = std::make_unique<OcclusionMap>(frame, table, config_, regionOf(grids), nz, threads);
}

void Voxelizer::mark(const Grid& grid, Scratch& scratch, CueVoxels& voxels) const {
  voxels.grid = grid;
  const std::size_t most = std::max(edge_.z.size(), object_.z.size());
  scratch.x.resize(most);
  scratch.y.resize(most);
  const auto scatter = [&](const Columns& points, VoxelBits& bits) {
    bits.reset(grid.nx, grid.ny, grid.nz);
    const int count = static_cast<int>(points.z.size());
    columnsOf(points.x.data(), points.y.data(), count, turned(grid), scratch.x.data(), scratch.y.data());
    for (int i = 0; i < count; ++i) {
      if (scratch.x[i] >= 0 && scratch.y[i] >= 0) bits.set(scratch.x[i], scratch.y[i], points.z[i]);
    }
  };
  scatter(edge_, voxels.edges);
  scatter(object_, voxels.occupied);
  markSuperpixels(scratch, grid.nz, voxels.superpixels);
  markHidden(grid, voxels.occupied, voxels.filled);
}

void Voxelizer::markSuperpixels(const Scratch& scratch, int nz, std::vector<SuperpixelVoxels>& superpixels) const {
  std::size_t found = 0;
  for (int s = 1; s <= points_.superpixels; ++s) {
    const int first = first_of_[s], count = first_of_[s + 1] - first;
    int x_low, x_high, y_low, y_high;
    indexRange(&scratch.x[first], count, x_low, x_high);
    indexRange(&scratch.y[first], count, y_low, y_high);
    if (count == 0 || x_high < x_low || y_high < y_low) continue;
    if (found == superpixels.size()) superpixels.emplace_back();
    SuperpixelVoxels& superpixel = superpixels[found++];
    superpixel.x0 = x_low, superpixel.y0 = y_low;
    superpixel.voxels.reset(x_high - x_low + 1, y_high - y_low + 1, nz);
    for (int i = first; i < first + count; ++i) {
      if (scratch.x[i] < 0 || scratch.y[i] < 0) continue;
      superpixel.voxels.set(scratch.x[i] - x_low, scratch.y[i] - y_low, object_.z[i]);
    }
  }
  superpixels.resize(found);
}

void Voxelizer::markHidden(const Grid& grid, const VoxelBits& occupied, VoxelBits& filled) const {
  const VoxelCentres centres(grid, T_table_camera_);
  const double step[3] = {centres.stepUp().x(), centres.stepUp().y(), centres.stepUp().z()};
  const int groups = (grid.nz + 7) / 8;
  const std::uint64_t in_grid = grid.nz % 64 ? (std::uint64_t{1} << grid.nz % 64) - 1 : ~std::uint64_t{0};
  filled.reset(grid.nx, grid.ny, grid.nz);
  for (int x = 0; x < grid.nx; ++x) {
    for (int y = 0; y < grid.ny; ++y) {
      const Eigen::Vector3d centre = grid.toTable({x + 0.5, y + 0.5, 0.5});
      const OcclusionMap::Groups known = occlusion_->at(centre.x(), centre.y());
      const Eigen::Vector3d lowest = centres.lowest(x, y);
      const double first[3] = {lowest.x(), lowest.y(), lowest.z()};
      std::uint64_t* column = filled.column(x, y);
      const std::uint64_t* points = occupied.column(x, y);
      for (int word = 0; word < filled.words(); ++word) {
        const bool classified = word < 8;
        const unsigned hidden = classified ? known.hidden >> (8 * word) & 0xFF : 0;
        const unsigned mixed = classified ? known.mixed >> (8 * word) & 0xFF : 0xFF;
        std::uint64_t bits = points[word] | spread(hidden);
        for (int group = 0; group < 8 && 8 * word + group < groups; ++group) {
          const std::uint64_t eight = std::uint64_t{0xFF} << (8 * group);
          if (!(mixed >> group & 1) || (points[word] & eight) == eight) continue;
          bits |= std::uint64_t{occludedOfEight(occlusion_->view(), first, step, 64 * word + 8 * group)} << (8 * group);
        }
        column[word] = word + 1 == filled.words() ? bits & in_grid : bits;
      }
    }
  }
}

}  // namespace objectness
