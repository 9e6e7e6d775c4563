// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "grouping/pieces.hpp"
#include "objectness_segmentation/config.hpp"
#include "objectness_segmentation/learning/learned_objectness.hpp"
#include "objectness_segmentation/result.hpp"
#include "objectness_segmentation/scene/frame.hpp"

namespace objectness::evaluation {

// Other choices among the pieces that segment() finds, to compare its choice with. Nothing of a package's user needs
// them. Errors and threads are as with segment(); boxes rest as its boxes do.

/// For each piece the trueObject() that most of its pixels are of, the first of equals; -1 where more of them are of
/// none (table or void). true_labels: of the frame's size, as in labels.png.
std::vector<int> pieceOwners(const Pieces& pieces, const cv::Mat_<ushort>& true_labels);

/// The best that any choice among the pieces could do: every piece is given to its owner. A segment's objectness is its
/// overlap (intersection over union) with its object; of equals the first object comes first.
Segmentation segmentByOracle(const Frame& frame, const cv::Mat_<ushort>& true_labels, const Config& config);

/// Correlation clustering of the links that the choice among groups weighs (contractEdges() of their log odds, those
/// over gaps times grouping.weight_gaps): no groups are proposed, and nothing is left out but what is smaller than
/// segments.min_pixels. Objectness as that of groups. model: nullptr for the one that comes with the package.
Segmentation segmentByClustering(const Frame& frame, const Config& config, const LearnedObjectness* model = nullptr);

}  // namespace objectness::evaluation
