// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace objectness {

struct Rgb {
  std::uint8_t r, g, b;
};

/// The colour of the object of this rank (0: largest objectness) in every picture, cloud and marker. Twenty colours
/// that are easy to tell from each other (the "category 20" set: ten hues, then their light versions), then again from
/// the first.
inline Rgb objectColor(std::size_t rank) {
  static constexpr std::array<Rgb, 20> kColors{{{31, 119, 180},  {255, 127, 14},  {44, 160, 44},   {214, 39, 40},
                                                {148, 103, 189}, {140, 86, 75},   {227, 119, 194}, {188, 189, 34},
                                                {23, 190, 207},  {127, 127, 127}, {174, 199, 232}, {255, 187, 120},
                                                {152, 223, 138}, {255, 152, 150}, {197, 176, 213}, {196, 156, 148},
                                                {247, 182, 210}, {219, 219, 141}, {158, 218, 229}, {199, 199, 199}}};
  return kColors[rank % kColors.size()];
}

}  // namespace objectness
