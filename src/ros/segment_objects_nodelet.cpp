// SPDX-License-Identifier: BSD-3-Clause
#include "segment_objects_nodelet.hpp"

#include <algorithm>
#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "objectness_segmentation/io/config_yaml.hpp"
#include "objectness_segmentation/ros/diagnostics.hpp"
#include "objectness_segmentation/ros/output_messages.hpp"
#include "objectness_segmentation/ros/params.hpp"
#include "objectness_segmentation/ros/topics.hpp"

namespace objectness_segmentation {
namespace {

/// The same kind of problem is said again after this time.
constexpr std::chrono::seconds kWarningPeriod{10};

/// Parameters in ~ that are no configuration fields: the nodelet's own, and those of what it is built from.
const std::vector<std::string> kOwnParameters = {"queue_size",        "approximate_sync",   "lazy",
                                                 "diagnostic_period", "num_worker_threads", "model"};

std::string join(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

}  // namespace

void SegmentObjectsNodelet::onInit() {
  try {
    initialize();
  } catch (const std::exception& e) {  // the manager and its other nodelets live on
    NODELET_FATAL("%s could not be started and stays idle: %s", getName().c_str(), e.what());
  }
}

/// Callbacks may come before this returns: everything they use exists before the publishers and subscribers do.
void SegmentObjectsNodelet::initialize() {
  ros::NodeHandle& private_nh = getPrivateNodeHandle();
  lazy_ = private_nh.param("lazy", true);
  const int queue_size = std::max(1, private_nh.param("queue_size", kSynchronizerQueueSize));
  const bool approximate = private_nh.param("approximate_sync", false);

  ReadParameters parameters = readParameters(private_nh, kOwnParameters);
  for (const std::string& problem : parameters.problems) NODELET_WARN("%s", problem.c_str());
  config_ = parameters.config;
  NODELET_DEBUG("configuration:\n%s", objectness::toYaml(config_).c_str());

  std::string model;
  if (private_nh.hasParam("model") && !private_nh.getParam("model", model)) {
    NODELET_WARN("parameter %s must be the path of a file: it is not used", private_nh.resolveName("model").c_str());
  }
  if (!model.empty()) loadModel(model);

  const auto on_exception = [this](const std::string& what) {
    statistics_.noteException(what);
    NODELET_ERROR("exception while publishing: %s", what.c_str());
  };
  worker_ = std::make_unique<LatestOnlyWorker<InputMessages>>(
      [this](const InputMessages& messages) { process(messages); }, on_exception);
  inputs_ = std::make_unique<SynchronizedInputs>(
      getNodeHandle(), queue_size, approximate,
      [this](const auto& cloud, const auto& camera_info) { handOver(cloud, camera_info); });
  startReconfigure();

  diagnostics_ = std::make_unique<diagnostic_updater::Updater>(getNodeHandle(), private_nh, getName());
  diagnostics_->setHardwareID("none");
  diagnostics_->add("segmentation", this, &SegmentObjectsNodelet::diagnose);
  // Wall time: simulated time jumps back when a bag loops, and ROS timers then stand still.
  diagnostics_timer_ = getNodeHandle().createWallTimer(
      ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { diagnostics_->force_update(); });

  advertise();
  updateSubscriptions();
}

/// Not by the built-in one in its place: results of another model than the one asked for would look as good.
void SegmentObjectsNodelet::loadModel(const std::string& path) {
  auto loaded = objectness::loadModel(path);
  if (loaded.ok()) {
    model_ = std::move(loaded.value);
    return;
  }
  model_status_ =
      objectness::Status::error(objectness::StatusCode::kBadConfig, "~model " + path + ": " + loaded.status.message);
  NODELET_ERROR("no frame will be segmented: %s", model_status_.message.c_str());
}

void SegmentObjectsNodelet::startReconfigure() {
  writeReconfigurable(config_, getPrivateNodeHandle());
  reconfigure_server_ = std::make_unique<ReconfigureServer>(reconfigure_mutex_, getPrivateNodeHandle());
  reconfigure_server_->getConfigDefault(accepted_);
  reconfigure_server_->setCallback(
      [this](ObjectnessSegmentationConfig& requested, std::uint32_t) { reconfigure(requested); });
}

void SegmentObjectsNodelet::advertise() {
  std::lock_guard<std::mutex> lock(connect_mutex_);
  const ros::SubscriberStatusCallback changed = [this](const ros::SingleSubscriberPublisher&) {
    updateSubscriptions();
  };
  ros::NodeHandle& nh = getPrivateNodeHandle();
  objects_ = nh.advertise<SegmentedObjectArray>(topics::kObjects, kPublisherQueueSize, changed, changed);
  segments_ = nh.advertise<sensor_msgs::PointCloud2>(topics::kSegments, kPublisherQueueSize, changed, changed);
  markers_ = nh.advertise<visualization_msgs::MarkerArray>(topics::kMarkers, kPublisherQueueSize, changed, changed);
}

SegmentObjectsNodelet::~SegmentObjectsNodelet() {
  // No more input, then no more changes, then no more work; what the worker publishes to dies last.
  diagnostics_timer_.stop();
  {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    inputs_.reset();
  }
  if (reconfigure_server_) reconfigure_server_->clearCallback();
  if (worker_) worker_->stop();
}

void SegmentObjectsNodelet::updateSubscriptions() {
  try {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    if (!inputs_) return;
    const bool wanted =
        !lazy_ || objects_.getNumSubscribers() + segments_.getNumSubscribers() + markers_.getNumSubscribers() > 0;
    if (wanted && !inputs_->subscribed()) {
      statistics_.resetInputAge();
      inputs_->subscribe();
    } else if (!wanted && inputs_->subscribed()) {
      inputs_->unsubscribe();
    }
  } catch (const std::exception& e) {  // a topic of another type, for one
    statistics_.noteException(e.what());
    NODELET_ERROR("subscribing to the inputs failed: %s", e.what());
  }
}

void SegmentObjectsNodelet::handOver(const sensor_msgs::PointCloud2ConstPtr& cloud,
                                     const sensor_msgs::CameraInfoConstPtr& camera_info) {
  statistics_.countInput();
  worker_->submit({cloud, camera_info});
}

void SegmentObjectsNodelet::reconfigure(ObjectnessSegmentationConfig& requested) {
  dynamic_reconfigure::Config message;
  requested.__toMessage__(message);
  std::lock_guard<std::mutex> lock(config_mutex_);
  const objectness::Config candidate = fromReconfigureMessage(message, config_);
  const std::vector<std::string> problems = objectness::validate(candidate);
  if (!problems.empty()) {
    NODELET_WARN("change of parameters rejected, the old ones stay: %s", join(problems).c_str());
    requested = accepted_;
    return;
  }
  config_ = candidate;
  accepted_ = requested;
}

void SegmentObjectsNodelet::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  InputState state;
  {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    if (!inputs_) return;
    state = {inputs_->subscribed(), inputs_->cloudsSeen(), inputs_->cameraInfosSeen(), worker_->dropped()};
  }
  describe(statistics_.take(), state, status);
  if (!model_status_.ok()) status.summary(diagnostic_msgs::DiagnosticStatus::ERROR, model_status_.message);
}

void SegmentObjectsNodelet::process(const InputMessages& messages) {
  const auto start = std::chrono::steady_clock::now();
  objectness::Config config;
  {
    std::lock_guard<std::mutex> lock(config_mutex_);
    config = config_;
  }
  SegmentedFrame result;
  result.segmentation.status = model_status_;
  if (model_status_.ok()) result = segmentMessages(messages, config, model_, &worker_->stopFlag());
  if (worker_->stopFlag()) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

  const objectness::Status& status = result.segmentation.status;
  if (status.code == objectness::StatusCode::kInternalError) statistics_.noteException(status.message);
  statistics_.countOutput(status, result.segmentation.segments.size(), 1e3 * elapsed.count());
  warnThrottled(status);
  publish(result, messages.cloud->header, elapsed.count());
}

void SegmentObjectsNodelet::publish(const SegmentedFrame& result, const std_msgs::Header& header, double seconds) {
  const OutputMessages outputs(result, header, {seconds, worker_->dropped()});
  if (objects_.getNumSubscribers() > 0) objects_.publish(outputs.objects());
  if (segments_.getNumSubscribers() > 0) segments_.publish(outputs.segments());
  if (markers_.getNumSubscribers() > 0) markers_.publish(outputs.markers());
}

/// Not NODELET_WARN_THROTTLE: that one counts for all nodelets of a manager together, and in ROS time.
void SegmentObjectsNodelet::warnThrottled(const objectness::Status& status) {
  if (status.ok()) return;
  const auto now = std::chrono::steady_clock::now();
  const auto [last, first_time] = last_warnings_.emplace(status.code, now);
  if (!first_time && now - last->second < kWarningPeriod) return;
  last->second = now;
  NODELET_WARN("frame not segmented (%s): %s", objectness::toString(status.code), status.message.c_str());
}

}  // namespace objectness_segmentation

PLUGINLIB_EXPORT_CLASS(objectness_segmentation::SegmentObjectsNodelet, nodelet::Nodelet)
