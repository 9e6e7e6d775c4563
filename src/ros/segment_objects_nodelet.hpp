// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <nodelet/nodelet.h>
#include <objectness_segmentation/ObjectnessSegmentationConfig.h>
#include <objectness_segmentation/SegmentOnce.h>

#include <boost/thread/recursive_mutex.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "objectness_segmentation/ros/latest_only_worker.hpp"
#include "ros/frame_processor.hpp"
#include "ros/frame_statistics.hpp"
#include "ros/node_settings.hpp"
#include "ros/pending_requests.hpp"
#include "ros/result_publishers.hpp"
#include "ros/segment_service.hpp"
#include "ros/synchronized_inputs.hpp"
#include "ros/throttled_problems.hpp"

namespace objectness_segmentation {

/// Segments the newest frame. ROS callbacks, all on the nodelet's single-threaded queue, only hand frames over; one
/// worker thread converts, segments and publishes; the service waits in a thread of its own. Topics and parameters are
/// described in doc/ros.md.
class SegmentObjectsNodelet : public nodelet::Nodelet {
 public:
  ~SegmentObjectsNodelet() override;

 private:
  using ReconfigureServer = dynamic_reconfigure::Server<ObjectnessSegmentationConfig>;

  struct Job {
    InputMessages messages;
    SegmentService::RequestId request_id = 0;  ///< requests that it answers
  };

  void onInit() override;
  void initialize();
  void loadModel(const std::string& path);
  void startReconfigure();
  void startDiagnostics();

  // On the callback queue, the first one also from the service's thread.
  void updateSubscriptions();
  void handOver(const InputMessages& messages);
  void reconfigure(ObjectnessSegmentationConfig& requested);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  // In the worker's thread.
  void process(const Job& job);
  void report(const SegmentedFrame& result, double milliseconds);

  void noteException(const std::string& what);
  InputState inputState();

  NodeSettings settings_;
  std::optional<objectness::LearnedObjectness> model_;  // of ~model, none: the built-in one; from the start the same
  objectness::Status model_status_;                     // not ok: no frame is segmented, each is answered with it

  std::mutex config_mutex_;
  objectness::Config config_;              // guarded by config_mutex_
  ObjectnessSegmentationConfig accepted_;  // the same values, for the reconfigure server; its callback only

  FrameStatistics statistics_;
  ThrottledProblems problems_;
  bool input_was_missing_ = false;  // the log says so; of diagnose() only

  SegmentService::Requests requests_;  // requests of the service

  std::mutex connect_mutex_;  // held while publishers_ and inputs_ come, go or are looked at by updateSubscriptions()
  ResultPublishers publishers_;
  std::unique_ptr<FrameProcessor> processor_;
  std::unique_ptr<LatestOnlyWorker<Job>> worker_;
  std::unique_ptr<SynchronizedInputs> inputs_;
  std::unique_ptr<SegmentService> service_;
  boost::recursive_mutex reconfigure_mutex_;
  std::unique_ptr<ReconfigureServer> reconfigure_server_;
  std::unique_ptr<diagnostic_updater::Updater> diagnostics_;
  ros::WallTimer diagnostics_timer_;
};

}  // namespace objectness_segmentation
