// SPDX-License-Identifier: BSD-3-Clause
#include "grouping/pieces.hpp"

#include "scene/connected_components_3d.hpp"
#include "segments/geodesic_assignment.hpp"

namespace objectness {
namespace {

double pixelArea(const Frame& frame, int pixel) {
  const double z = frame.points[pixel].z();
  return z * z / (frame.camera.fx * frame.camera.fy);
}

/// Connected points that no superpixel reaches become pieces when they show enough surface.
void addRoughParts(const Frame& frame, const ObjectPoints& object_points, const PiecesConfig& config, int threads,
                   Pieces& pieces) {
  cv::Mat_<uchar> rest = (pieces.label < 0) & object_points.mask;
  int count = 0;
  const Gap gap{static_cast<float>(config.max_step_m), 0, 0, {}};
  const cv::Mat_<int> parts = connectPoints(frame.points, rest, gap, count, threads);
  const int* part = parts[0];
  std::vector<int> pixels(count + 1, 0), piece_of(count + 1, -1);
  std::vector<double> area(count + 1, 0);
  for (int i = 0; i < frame.size(); ++i) {
    if (part[i] == 0) continue;
    ++pixels[part[i]];
    area[part[i]] += pixelArea(frame, i);
  }
  int next = pieces.count();
  for (int k = 1; k <= count; ++k) {
    if (pixels[k] >= config.min_pixels && area[k] >= config.min_area_m2) piece_of[k] = next++;
  }
  pieces.pieces.resize(next);
  for (int i = 0; i < frame.size(); ++i) {
    if (part[i] > 0) pieces.label(i) = piece_of[part[i]];
  }
}

}  // namespace

Pieces labelPieces(const Frame& frame, const ObjectPoints& object_points, const Superpixels& superpixels,
                   const PiecesConfig& config, int threads) {
  Pieces pieces;
  pieces.label = superpixels.label - 1;
  pieces.pieces.resize(superpixels.count);
  assignGeodesic(frame, object_points.mask, {config.max_step_m, config.max_reach_m}, pieces.label, threads);
  addRoughParts(frame, object_points, config, threads, pieces);
  return pieces;
}

void describePieces(const Frame& frame, const Normals& normals, const Superpixels& superpixels, Pieces& pieces) {
  const int* label = pieces.label[0];
  for (int i = 0; i < frame.size(); ++i) {
    if (label[i] < 0) continue;
    Piece& piece = pieces.pieces[label[i]];
    piece.pixels.push_back(i);
    piece.smooth_pixels += superpixels.label(i) > 0;
    piece.area_m2 += static_cast<float>(pixelArea(frame, i));
    piece.centroid += frame.points[i];
    if (normals.radius_px[i] > 0) piece.mean_normal += normals.normal[i];
  }
  for (Piece& piece : pieces.pieces) {
    piece.centroid /= static_cast<float>(std::max<std::size_t>(1, piece.pixels.size()));
    piece.mean_normal /= static_cast<float>(std::max<std::size_t>(1, piece.pixels.size()));
  }
}

Pieces findPieces(const Frame& frame, const Normals& normals, const ObjectPoints& object_points,
                  const Superpixels& superpixels, const PiecesConfig& config, int threads) {
  Pieces pieces = labelPieces(frame, object_points, superpixels, config, threads);
  describePieces(frame, normals, superpixels, pieces);
  return pieces;
}

}  // namespace objectness
