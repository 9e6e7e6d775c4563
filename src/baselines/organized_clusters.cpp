// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/organized_clusters.hpp"

#include <pcl/segmentation/euclidean_cluster_comparator.h>
#include <pcl/segmentation/organized_connected_component_segmentation.h>

#include "baselines/organized_cloud.hpp"

namespace objectness {

std::vector<int> labelOrganizedClusters(const Frame& frame, const cv::Mat_<uchar>& mask, double distance_m,
                                        bool depth_dependent) {
  // Points that are not to be clustered are taken out of the cloud. The comparator's own exclude labels mean opposite
  // things in different versions of PCL.
  using Comparator = pcl::EuclideanClusterComparator<pcl::PointXYZ, pcl::Label>;
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = organizedCloud(frame, mask);
  const Comparator::Ptr comparator(new Comparator());
  comparator->setInputCloud(cloud);
  comparator->setDistanceThreshold(static_cast<float>(distance_m), depth_dependent);
  pcl::OrganizedConnectedComponentSegmentation<pcl::PointXYZ, pcl::Label> components(comparator);
  components.setInputCloud(cloud);
  pcl::PointCloud<pcl::Label> found;
  std::vector<pcl::PointIndices> indices;
  components.segment(found, indices);

  std::vector<int> labels(frame.size(), 0);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    for (const int i : indices[k].indices) labels[i] = static_cast<int>(k) + 1;
  }
  return labels;
}

}  // namespace objectness
