// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <nodelet/nodelet.h>
#include <objectness_segmentation/ObjectnessSegmentationConfig.h>

#include <boost/thread/recursive_mutex.hpp>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "objectness_segmentation/ros/frame_statistics.hpp"
#include "objectness_segmentation/ros/latest_only_worker.hpp"
#include "objectness_segmentation/ros/segment_messages.hpp"
#include "objectness_segmentation/ros/synchronized_inputs.hpp"

namespace objectness_segmentation {

/// Segments the newest cloud. ROS callbacks, all on the nodelet's single-threaded queue, only hand frames over; one
/// worker thread converts, segments and publishes. Topics and parameters are described in the README.
class SegmentObjectsNodelet : public nodelet::Nodelet {
 public:
  ~SegmentObjectsNodelet() override;

 private:
  using ReconfigureServer = dynamic_reconfigure::Server<ObjectnessSegmentationConfig>;

  void onInit() override;
  void initialize();
  void loadModel(const std::string& path);
  void startReconfigure();
  void advertise();

  // On the callback queue.
  void updateSubscriptions();
  void handOver(const sensor_msgs::PointCloud2ConstPtr& cloud, const sensor_msgs::CameraInfoConstPtr& camera_info);
  void reconfigure(ObjectnessSegmentationConfig& requested);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  // In the worker's thread.
  void process(const InputMessages& messages);
  void publish(const SegmentedFrame& result, const std_msgs::Header& header, double seconds);
  void warnThrottled(const objectness::Status& status);

  bool lazy_ = true;
  std::optional<objectness::LearnedObjectness> model_;  // of ~model, none: the built-in one; from the start the same
  objectness::Status model_status_;                     // not ok: no frame is segmented, each is answered with it

  std::mutex config_mutex_;
  objectness::Config config_;              // guarded by config_mutex_
  ObjectnessSegmentationConfig accepted_;  // the same values, for the reconfigure server; its callback only

  FrameStatistics statistics_;
  std::map<objectness::StatusCode, std::chrono::steady_clock::time_point> last_warnings_;  // worker only

  std::mutex connect_mutex_;  // held while publishers and inputs_ come, go or are looked at by updateSubscriptions()
  ros::Publisher objects_, segments_, markers_;
  std::unique_ptr<LatestOnlyWorker<InputMessages>> worker_;
  std::unique_ptr<SynchronizedInputs> inputs_;
  boost::recursive_mutex reconfigure_mutex_;
  std::unique_ptr<ReconfigureServer> reconfigure_server_;
  std::unique_ptr<diagnostic_updater::Updater> diagnostics_;
  ros::WallTimer diagnostics_timer_;
};

}  // namespace objectness_segmentation
