// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace objectness::evaluation {

/// What counts as one object of the truth.
enum class Level {
  kObject,  ///< the parts of an object together
  kPart     ///< every annotated part by itself
};

/// "object", "part".
const char* toString(Level level);

/// Truth as scenes store it (common/true_labels.hpp) to 0 void, 1 table, 2 and above one label an object of this level.
cv::Mat_<ushort> truthAtLevel(const cv::Mat_<ushort>& annotation, Level level);

/// How well the segments of a scene fit its true objects. Pixels of void truth count nowhere; the table's pixels of a
/// segment do. "Its segment" is the one that shares most pixels with an object; shared, segment and object are pixel
/// counts; an object that shares no pixel with any segment has a precision and recall of 0.
struct Scores {
  double precision = 0;          ///< mean over objects of shared / segment (paper, Fig. 4); low: under-segmentation
  double recall = 0;             ///< mean over objects of shared / object; low: over-segmentation
  double overlap_precision = 1;  ///< shared pixels of one-to-one pairs of the largest summed Dice / pixels of segments
  double overlap_recall = 0;     ///< the same shared pixels / pixels of objects
  double overlap_f = 0;
  double boundary_precision = 1;  ///< outline pixels of paired segments near their object's outline / of all segments
  double boundary_recall = 0;     ///< outline pixels of paired objects near their segment's outline / of all objects
  double boundary_f = 0;
  double found_75 = 0;  ///< share of objects whose pair's Dice exceeds 0.75
  double extra = 0;     ///< segments that share no pixel with their partner, or have none
  /// Richtsfeld et al. (Learning of perceptual grouping for object segmentation on RGB-D data, 2014): 1 - correct / all
  /// pixels of an object; mean over objects. Correct: of its segment and of the object.
  double over_segmentation = 1;
  /// Same paper: false / all pixels of an object; false: of its segment but not of the object; mean over objects. May
  /// exceed 1.
  double under_segmentation = 0;
  /// Best intersection over union of any segment, objects weighted by their pixels (as Silberman et al. 2012).
  double weighted_overlap = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("P", self.precision);
    visit("R", self.recall);
    visit("OvP", self.overlap_precision);
    visit("OvR", self.overlap_recall);
    visit("OvF", self.overlap_f);
    visit("BdP", self.boundary_precision);
    visit("BdR", self.boundary_recall);
    visit("BdF", self.boundary_f);
    visit("F75", self.found_75);
    visit("extra", self.extra);
    visit("F_os", self.over_segmentation);
    visit("F_us", self.under_segmentation);
    visit("WO", self.weighted_overlap);
  }
};

/// An object is found when the Dice of its pair exceeds this.
constexpr double kFoundDice = 0.75;

/// A true object and its segment, by their labels in the images.
struct ObjectPair {
  int object, segment;
  double dice;  ///< of their pixels, those of void truth left out
};

/// The one-to-one pairs of the largest summed Dice that share pixels, by object: those that scoreLabels() makes.
std::vector<ObjectPair> pairObjects(const cv::Mat_<ushort>& labels, const cv::Mat_<ushort>& truth);

/// Scores labels (0 nothing, 1 table, 2 and above one segment each) against truth of one level, of equal size. The
/// boundary tolerance is ceil(0.003 * image diagonal) pixels. A Scores of defaults when there are no segments; nothing
/// when there are no objects.
std::optional<Scores> scoreLabels(const cv::Mat_<ushort>& labels, const cv::Mat_<ushort>& truth);

}  // namespace objectness::evaluation
