// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/random_volumes.hpp"
#include "integral/cue_volumes.hpp"

using namespace objectness;
using objectness_test::Dice;

TEST(IntegralVolume, CountsEveryBoxAsALoopDoes) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Dice dice(seed);
    const int nx = dice.between(1, 6), ny = dice.between(1, 6), nz = dice.between(1, 5), padding = dice.below(3);
    VoxelBits bits(nx, ny, nz);
    std::vector<int> voxels(nx * ny * nz, 0);
    for (int i = dice.below(nx * ny * nz + 1); i > 0; --i) {
      const int x = dice.below(nx), y = dice.below(ny), z = dice.below(nz);
      bits.set(x, y, z);
      EXPECT_TRUE(bits.isSet(x, y, z));
      voxels[(x * ny + y) * nz + z] = 1;
    }
    const IntegralVolume volume(bits, padding);
    const auto loop = [&](int x0, int x1, int y0, int y1, int z0, int z1) {
      int sum = 0;
      for (int x = x0; x < x1; ++x) {
        for (int y = y0; y < y1; ++y) {
          for (int z = z0; z < std::min(z1, nz); ++z) sum += voxels[(x * ny + y) * nz + z];
        }
      }
      return sum;
    };
    EXPECT_EQ(volume.total(), loop(0, nx, 0, ny, 0, nz));
    for (int x0 = 0; x0 <= nx; ++x0) {
      for (int x1 = x0; x1 <= nx; ++x1) {
        for (int y0 = 0; y0 <= ny; ++y0) {
          for (int y1 = y0; y1 <= ny; ++y1) {
            for (int z1 = 0; z1 <= nz + padding; ++z1) {
              for (int z0 = 0; z0 <= z1; ++z0) {
                ASSERT_EQ(volume.count(x0, x1, y0, y1, z0, z1), loop(x0, x1, y0, y1, z0, z1)) << "seed " << seed;
              }
              ASSERT_EQ(volume.count(x0, x1, y0, y1, z1), loop(x0, x1, y0, y1, 0, z1)) << "seed " << seed;
            }
          }
        }
      }
    }
  }
}

TEST(IntegralVolume, SettingAVoxelTwiceCountsOnce) {
  VoxelBits bits(2, 2, 2);
  bits.set(1, 1, 1);
  bits.set(1, 1, 1);
  EXPECT_EQ(IntegralVolume(bits).total(), 1);
}

TEST(IntegralVolume, BoxesOfMoreVoxelsThanASumHolds) {
  // 60 x 50 x 70 = 210,000 set voxels: sums modulo 2^16 wrap three times.
  VoxelBits bits(60, 50, 70);
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 50; ++y) {
      for (int z = 0; z < 70; ++z) bits.set(x, y, z);
    }
  }
  const IntegralVolume volume(bits, 3);
  EXPECT_EQ(volume.total(), 210000);
  EXPECT_EQ(volume.count(0, 60, 0, 50, 70), 210000);
  EXPECT_EQ(volume.count(0, 60, 0, 50, 73), 210000);
  EXPECT_EQ(volume.count(1, 59, 2, 49, 5, 68), 58 * 47 * 63);
  EXPECT_EQ(volume.count(17, 18, 0, 50, 70), 3500);
}

TEST(IntegralVolume, MemoryIsUsedAgainForSmallerVolumes) {
  VoxelBits large(9, 9, 9), small(3, 4, 5);
  for (int i = 0; i < 9; ++i) large.set(i, i, i);
  small.set(2, 3, 4);
  IntegralVolume volume(large);
  volume.assign(small, 2);
  EXPECT_EQ(volume.total(), 1);
  EXPECT_EQ(volume.count(0, 3, 0, 4, 7), 1);
  EXPECT_EQ(volume.count(0, 3, 0, 4, 4), 0);
}

TEST(IntegralVolume, AnEmptyOneHoldsNothing) { EXPECT_EQ(IntegralVolume().total(), 0); }

TEST(SuperpixelVolume, CountsInAnyBoxOfTheGrid) {
  Dice dice(3);
  std::vector<Eigen::Vector3i> voxels;
  for (int i = 0; i < 12; ++i) voxels.emplace_back(dice.between(2, 5), dice.between(1, 4), dice.between(1, 3));
  const SuperpixelVolume superpixel(superpixelVoxels(voxels, 6));
  std::sort(voxels.begin(), voxels.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
  });
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  EXPECT_EQ(superpixel.total(), static_cast<int>(voxels.size()));
  for (int x0 = 0; x0 < 8; ++x0) {
    for (int x1 = x0 + 1; x1 <= 8; ++x1) {
      for (int y0 = 0; y0 < 8; ++y0) {
        for (int y1 = y0 + 1; y1 <= 8; ++y1) {
          for (int height = 1; height <= 6; ++height) {
            const auto inside = [&](const Eigen::Vector3i& v) {
              return v.x() >= x0 && v.x() < x1 && v.y() >= y0 && v.y() < y1 && v.z() < height;
            };
            ASSERT_EQ(superpixel.count(x0, x1, y0, y1, height), std::count_if(voxels.begin(), voxels.end(), inside));
          }
        }
      }
    }
  }
}
