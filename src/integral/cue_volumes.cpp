// SPDX-License-Identifier: BSD-3-Clause
#include "integral/cue_volumes.hpp"

namespace objectness {

void integrate(const CueVoxels& voxels, const Table& table, int ring_z, CueVolumes& volumes) {
  volumes.grid = voxels.grid;
  volumes.viewpoint = voxels.grid.toGrid(table.T_table_camera.translation());
  volumes.edges.assign(voxels.edges, ring_z);
  volumes.occupied.assign(voxels.occupied);
  volumes.filled.assign(voxels.filled);
  volumes.superpixels.resize(voxels.superpixels.size());
  for (std::size_t s = 0; s < voxels.superpixels.size(); ++s) volumes.superpixels[s].assign(voxels.superpixels[s]);
}

}  // namespace objectness
