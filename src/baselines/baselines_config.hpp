// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "objectness_segmentation/common/range.hpp"

namespace objectness {

// The defaults are what served each baseline best on the 45 learn scenes of the modified Object Segmentation Database,
// by the sum of overlap F and F75 (see doc/evaluation.md), after some 30 (MPS), 370 (LCCP) and 170 (CPC) settings.

/// MPS, the paper's baseline: organized multi-plane segmentation, then connected components of the points off the
/// planes (Trevor, Gedikli, Rusu & Christensen, SPME 2013; pcl::OrganizedMultiPlaneSegmentation and
/// pcl::OrganizedConnectedComponentSegmentation).
///
/// In the sweep a distance of 5 to 15 mm made no difference, 3 mm broke objects up and 20 mm joined more of them;
/// without the faces of objects, which count as planes from 10000 (1000) pixels, R fell from 0.94 to 0.87 (0.54).
struct MpsConfig {
  double plane_angle_deg = 3.0;
  double plane_distance_m = 0.02;
  double plane_max_curvature = 0.001;
  int min_plane_pixels = 10000;
  bool object_planes = true;
  double cluster_distance_m = 0.008;
  bool depth_dependent = false;
  int min_pixels = 300;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("plane_angle_deg", self.plane_angle_deg, Range{0.1, 90}, "largest angle between the normals of neighbours");
    visit("plane_distance_m", self.plane_distance_m, Range{0.0001, 1},
          "largest difference of the plane's distance between neighbours, at 1 m; grows with the depth squared");
    visit("plane_max_curvature", self.plane_max_curvature, Range{0, 1}, "a region that is curved more is no plane");
    visit("min_plane_pixels", self.min_plane_pixels, Range{1, 10000000}, "a smaller region is no plane");
    visit("object_planes", self.object_planes,
          "points of planes that stand on the table (faces of objects) are clustered like all others");
    visit("cluster_distance_m", self.cluster_distance_m, Range{0.0001, 1},
          "tau: neighbouring pixels nearer than this are of one object");
    visit("depth_dependent", self.depth_dependent,
          "cluster_distance_m is that at 1 m; it grows with the depth squared");
    visit("min_pixels", self.min_pixels, Range{1, 1000000}, "smaller segments are dropped");
  }
};

/// LCCP: supervoxels of the points above the table, joined where their border is convex (Stein, Schoeler, Papon &
/// Woergoetter, CVPR 2014; pcl::SupervoxelClustering and pcl::LCCPSegmentation).
///
/// In the sweep the optimum was flat: voxels of 6 to 7.5 mm, seeds every 4 cm, 5 to 15 degrees and any smoothness
/// differ by 0.001. Without the sanity check P falls by up to 0.06. Voxels that grow with the depth, colour, and the
/// frame's own normals in place of PCL's never helped.
struct LccpConfig {
  double voxel_m = 0.0075;
  double seed_m = 0.04;
  double color_importance = 0.0;
  double spatial_importance = 1.0;
  double normal_importance = 4.0;
  bool single_camera_transform = false;
  bool own_normals = false;
  double concavity_deg = 10.0;
  bool smoothness_check = true;
  double smoothness = 0.1;
  bool sanity_check = true;
  int k_convexity = 0;
  int min_segment_supervoxels = 10;
  int min_pixels = 300;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("voxel_m", self.voxel_m, Range{0.001, 0.1}, "side of a voxel");
    visit("seed_m", self.seed_m, Range{0.002, 0.5}, "distance between the seeds of supervoxels");
    visit("color_importance", self.color_importance, Range{0, 100}, "weight of colour when supervoxels grow");
    visit("spatial_importance", self.spatial_importance, Range{0, 100}, "weight of distance");
    visit("normal_importance", self.normal_importance, Range{0, 100}, "weight of the normals' difference");
    visit("single_camera_transform", self.single_camera_transform, "voxels that grow with the depth");
    visit("own_normals", self.own_normals,
          "take the mean of the frame's normals in a voxel; off: PCL fits one to its voxels' neighbours");
    visit("concavity_deg", self.concavity_deg, Range{0, 180}, "a concave border counts as convex up to this angle");
    visit("smoothness_check", self.smoothness_check, "a step between two supervoxels is no convex border");
    visit("smoothness", self.smoothness, Range{0, 100}, "the step that is allowed, in voxels");
    visit("sanity_check", self.sanity_check, "supervoxels that touch in one point only have no convex border");
    visit("k_convexity", self.k_convexity, Range{0, 10}, "common neighbours with convex borders that a border needs");
    visit("min_segment_supervoxels", self.min_segment_supervoxels, Range{0, 1000},
          "segments of no more supervoxels join their largest neighbour");
    visit("min_pixels", self.min_pixels, Range{1, 1000000}, "smaller segments are dropped");
  }
};

/// CPC: the segments of LCCP, cut along planes through their concave borders (Schoeler, Papon & Woergoetter, CVPR 2015;
/// pcl::CPCSegmentation).
///
/// In the sweep no cut ever helped on top of the best LCCP, and LCCP settings that join more, with cuts, stayed behind.
/// So: the lowest score and the smallest segments for which cutting costs nothing. PCL seeds its RANSAC with a
/// constant.
struct CpcConfig {
  LccpConfig lccp;
  int max_cuts = 25;
  int min_borders_for_cutting = 100;
  double min_cut_score = 0.25;
  bool local_constraints = true;
  bool directed_weights = true;
  bool clean_cuts = false;
  int ransac_iterations = 2000;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    LccpConfig::fields(self.lccp, visit);
    visit("max_cuts", self.max_cuts, Range{0, 1000}, "rounds of cutting");
    visit("min_borders_for_cutting", self.min_borders_for_cutting, Range{0, 1000000},
          "segments with fewer borders between their supervoxels are not cut");
    visit("min_cut_score", self.min_cut_score, Range{0, 10}, "least share of concave borders along a cut");
    visit("local_constraints", self.local_constraints, "a cut reaches only as far as connected borders support it");
    visit("directed_weights", self.directed_weights, "borders weigh more the more they cross the cutting plane");
    visit("clean_cuts", self.clean_cuts, "cut only borders whose supervoxels lie on both sides of the plane");
    visit("ransac_iterations", self.ransac_iterations, Range{1, 1000000}, "planes that are tried for a cut");
  }
};

/// What a user of PCL writes without this package to be rid of the table: points between two depths, and of these the
/// plane that most of them lie on (pcl::PassThrough; pcl::SACSegmentation).
///
/// In the sweep 5 and 7.5 mm to the plane did the same, 10 mm lost a little (0.005), 15 mm more (0.02): the foot of
/// every object. How far points may be made no difference there: nothing but the table is in these pictures.
struct RansacPlaneConfig {
  double min_depth_m = 0.3;
  double max_depth_m = 1.5;
  double plane_distance_m = 0.005;
  int max_iterations = 1000;
  bool above_only = true;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("min_depth_m", self.min_depth_m, Range{0, 100}, "points nearer than this (z) are left out");
    visit("max_depth_m", self.max_depth_m, Range{0.01, 100}, "points farther than this (z) are left out");
    visit("plane_distance_m", self.plane_distance_m, Range{0.0001, 1}, "points within this distance are of the plane");
    visit("max_iterations", self.max_iterations, Range{1, 1000000}, "planes that are tried");
    visit("above_only", self.above_only, "points beyond the plane are left out");
  }
};

/// The points off that plane, clustered in space (Rusu, PhD thesis, TU Muenchen 2009; pcl::EuclideanClusterExtraction).
///
/// In the sweep (27 settings) voxels of 3 to 10 mm and distances of 10 to 15 mm did the same (0.005); 20 mm joined
/// objects (0.05).
struct EuclideanConfig {
  RansacPlaneConfig plane;
  double voxel_m = 0.01;
  double cluster_distance_m = 0.015;
  int min_pixels = 300;
  int max_pixels = 100000;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    RansacPlaneConfig::fields(self.plane, visit);
    visit("voxel_m", self.voxel_m, Range{0, 0.1},
          "side of the voxels that points are averaged in before (pcl::VoxelGrid); 0: every point counts, which takes "
          "seconds");
    visit("cluster_distance_m", self.cluster_distance_m, Range{0.0001, 1},
          "points nearer than this are of one cluster");
    visit("min_pixels", self.min_pixels, Range{1, 1000000}, "smaller clusters are dropped");
    visit("max_pixels", self.max_pixels, Range{1, 100000000}, "larger clusters are dropped: walls, floors");
  }
};

/// The points off that plane, clustered in the image (pcl::OrganizedConnectedComponentSegmentation by a
/// pcl::EuclideanClusterComparator).
///
/// In the sweep (20 settings) distances of 5 to 15 mm did the same (0.002), and one that grows with the depth was not
/// better.
struct OrganizedConfig {
  RansacPlaneConfig plane;
  double cluster_distance_m = 0.01;
  bool depth_dependent = false;
  int min_pixels = 300;
  int max_pixels = 100000;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    RansacPlaneConfig::fields(self.plane, visit);
    visit("cluster_distance_m", self.cluster_distance_m, Range{0.0001, 1},
          "neighbouring pixels nearer than this are of one cluster");
    visit("depth_dependent", self.depth_dependent,
          "cluster_distance_m is that at 1 m; it grows with the depth squared");
    visit("min_pixels", self.min_pixels, Range{1, 1000000}, "smaller clusters are dropped");
    visit("max_pixels", self.max_pixels, Range{1, 100000000}, "larger clusters are dropped: walls, floors");
  }
};

struct BaselinesConfig {
  MpsConfig mps;
  LccpConfig lccp;
  CpcConfig cpc;
  EuclideanConfig euclidean;
  OrganizedConfig organized;
};

}  // namespace objectness
