// SPDX-License-Identifier: BSD-3-Clause
#include "integral/occlusion_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/parallel.hpp"

namespace objectness {
namespace {

constexpr int kBlockPx = 4;      // of which the depth range is kept
constexpr int kGroup = 8;        // voxels of a cell's height
constexpr int kMostGroups = 64;  // a bit each
// What rounding could move a voxel's centre by: far more than it does.
constexpr double kSlackPx = 0.01, kSlackM = 1e-6;
constexpr double kNearestM = 0.01;  // nearer to the camera's plane than this nothing is projected

struct Vertex {
  double u = 0, v = 0, z = 0;
};

}  // namespace

OcclusionMap::OcclusionMap(const Frame& frame, const Table& table, const VolumeConfig& config,
                           const TableRegion& region, int nz, int threads)
    : region_(region), cell_m_(2 * config.voxel_m) {
  const PinholeCamera& camera = frame.camera;
  const Eigen::Vector2d size = region.high_m - region.low_m;
  cells_x_ = std::max(1, static_cast<int>(std::ceil(size.x() / cell_m_)));
  cells_y_ = std::max(1, static_cast<int>(std::ceil(size.y() / cell_m_)));
  copyDepth(frame, config.unknown_is_occluded, threads);
  view_ = {depth_.data(), camera.width, camera.height, camera.fx,
           camera.fy,     camera.cx,    camera.cy,     config.occlusion_tolerance_m};
  classify(table, config.voxel_m, nz, threads);
}

void OcclusionMap::copyDepth(const Frame& frame, bool unknown_is_occluded, int threads) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float missing = unknown_is_occluded ? -kInfinity : kInfinity;
  const int width = frame.width(), height = frame.height();
  const int blocks_u = (width + kBlockPx - 1) / kBlockPx;
  blocks_v_ = (height + kBlockPx - 1) / kBlockPx;
  depth_.resize(static_cast<std::size_t>(width) * height);
  block_low_.assign(static_cast<std::size_t>(blocks_u) * blocks_v_, kInfinity);
  block_high_.assign(block_low_.size(), -kInfinity);
  // By columns, which are what is written side by side: threads do not write to the same cache lines.
  constexpr int kColumns = 8 * kBlockPx;
  parallelFor((width + kColumns - 1) / kColumns, threads, [&](int band) {
    const int last_u = std::min(width, (band + 1) * kColumns);
    for (int v = 0; v < height; ++v) {
      for (int u = band * kColumns; u < last_u; ++u) {
        const float measured = frame.points[static_cast<std::size_t>(v) * width + u].z();
        const float depth = std::isnan(measured) ? missing : measured;
        depth_[static_cast<std::size_t>(u) * height + v] = depth;
        const std::size_t block = static_cast<std::size_t>(u / kBlockPx) * blocks_v_ + v / kBlockPx;
        block_low_[block] = std::min(block_low_[block], depth);
        block_high_[block] = std::max(block_high_[block], depth);
      }
    }
  });
}

std::pair<float, float> OcclusionMap::depthRange(int u0, int u1, int v0, int v1) const {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (int block_u = u0 / kBlockPx; block_u <= u1 / kBlockPx; ++block_u) {
    for (int block_v = v0 / kBlockPx; block_v <= v1 / kBlockPx; ++block_v) {
      const std::size_t block = static_cast<std::size_t>(block_u) * blocks_v_ + block_v;
      low = std::min(low, block_low_[block]);
      high = std::max(high, block_high_[block]);
    }
  }
  return {low, high};
}

void OcclusionMap::classify(const Table& table, double voxel_m, int nz, int threads) {
  const int groups = std::min((nz + kGroup - 1) / kGroup, kMostGroups);
  const Eigen::Isometry3d T_camera_table = table.T_table_camera.inverse();
  // The corners of all cells in the image.
  const int row = (cells_y_ + 1) * (groups + 1);
  std::vector<Vertex> vertices(static_cast<std::size_t>(cells_x_ + 1) * row);
  parallelFor(cells_x_ + 1, threads, [&](int i) {
    Vertex* vertex = &vertices[static_cast<std::size_t>(i) * row];
    for (int j = 0; j <= cells_y_; ++j) {
      for (int g = 0; g <= groups; ++g, ++vertex) {
        const Eigen::Vector3d corner(region_.low_m.x() + i * cell_m_, region_.low_m.y() + j * cell_m_,
                                     g * kGroup * voxel_m);
        const Eigen::Vector3d p = T_camera_table * corner;
        *vertex = {view_.fx * p.x() / p.z() + view_.cx, view_.fy * p.y() / p.z() + view_.cy, p.z()};
      }
    }
  });

  cells_.assign(static_cast<std::size_t>(cells_x_) * cells_y_, Groups());
  parallelFor(cells_x_, threads, [&](int i) {
    for (int j = 0; j < cells_y_; ++j) {
      Groups& cell = cells_[static_cast<std::size_t>(i) * cells_y_ + j];
      for (int g = 0; g < groups; ++g) {
        const Vertex* first = &vertices[static_cast<std::size_t>(i) * row + j * (groups + 1) + g];
        double u_low = first->u, u_high = u_low, v_low = first->v, v_high = v_low, z_low = first->z, z_high = z_low;
        for (const int corner : {1, groups + 1, groups + 2, row, row + 1, row + groups + 1, row + groups + 2}) {
          const Vertex& vertex = first[corner];
          u_low = std::min(u_low, vertex.u), u_high = std::max(u_high, vertex.u);
          v_low = std::min(v_low, vertex.v), v_high = std::max(v_high, vertex.v);
          z_low = std::min(z_low, vertex.z), z_high = std::max(z_high, vertex.z);
        }
        if (!(z_low > kNearestM)) continue;
        const std::uint64_t bit = std::uint64_t{1} << g;
        u_low += 0.5 - kSlackPx, u_high += 0.5 + kSlackPx, v_low += 0.5 - kSlackPx, v_high += 0.5 + kSlackPx;
        if (u_high < 0 || v_high < 0 || u_low >= view_.width || v_low >= view_.height) {
          cell.mixed &= ~bit;  // beyond the image: clear
          continue;
        }
        const bool inside = u_low >= 0 && v_low >= 0 && u_high < view_.width && v_high < view_.height;
        const auto [nearest, farthest] =
            depthRange(static_cast<int>(std::max(u_low, 0.0)), static_cast<int>(std::min(u_high, view_.width - 1.0)),
                       static_cast<int>(std::max(v_low, 0.0)), static_cast<int>(std::min(v_high, view_.height - 1.0)));
        const bool hidden = inside && z_low - kSlackM > farthest + view_.tolerance_m;
        if (hidden) cell.hidden |= bit;
        if (hidden || z_high + kSlackM <= nearest + view_.tolerance_m) cell.mixed &= ~bit;
      }
    }
  });
}

OcclusionMap::Groups OcclusionMap::at(double x_m, double y_m) const {
  const double i = (x_m - region_.low_m.x()) / cell_m_, j = (y_m - region_.low_m.y()) / cell_m_;
  if (!(i >= 0 && j >= 0 && i < cells_x_ && j < cells_y_)) return {};
  return cells_[static_cast<std::size_t>(i) * cells_y_ + static_cast<std::size_t>(j)];
}

}  // namespace objectness
