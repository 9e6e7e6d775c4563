// SPDX-License-Identifier: BSD-3-Clause
#include "ros/segment_objects_nodelet.hpp"

#include <chrono>
#include <functional>
#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "objectness_segmentation/io/config_yaml.hpp"
#include "objectness_segmentation/ros/output_conversions.hpp"
#include "objectness_segmentation/ros/params.hpp"
#include "ros/diagnostics.hpp"
#include "ros/guarded.hpp"
#include "ros/public_names.hpp"

namespace objectness_segmentation {
namespace {

using objectness::Status;
using objectness::StatusCode;

std::string join(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

/// What the objects were chosen among, whichever method it was.
std::int64_t boxesScored(const objectness::Report& report) {
  return report.boxes_scored.value_or(report.hypotheses.value_or(0));
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
  ReadSettings read = readSettings(private_nh);
  settings_ = std::move(read.settings);
  ReadParameters parameters = readParameters(private_nh, settingNames());
  config_ = parameters.config;
  for (const std::string& problem : read.problems) NODELET_WARN("%s", problem.c_str());
  for (const std::string& problem : parameters.problems) NODELET_WARN("%s", problem.c_str());
  NODELET_DEBUG("configuration:\n%s", objectness::toYaml(config_).c_str());
  if (!settings_.model.empty()) loadModel(settings_.model);

  processor_ = std::make_unique<FrameProcessor>(settings_, getNodeHandle());
  worker_ = std::make_unique<LatestOnlyWorker<Job>>([this](const Job& job) { process(job); },
                                                    [this](const std::string& what) { noteException(what); });
  const auto on_jump = [this] {
    worker_->discardWaiting();
    processor_->forgetTransforms();
    if (problems_.isDue("jump")) NODELET_INFO("time went back: what was of the time before is forgotten");
  };
  inputs_ = std::make_unique<SynchronizedInputs>(
      publicHandle(private_nh, getRemappingArgs()), private_nh, settings_.input,
      SynchronizedInputs::Callbacks{[this](const InputMessages& messages) { handOver(messages); }, on_jump,
                                    [this](const std::string& sentence) { NODELET_WARN("%s", sentence.c_str()); },
                                    [this](const std::string& what) { noteException(what); }});
  startReconfigure();
  startDiagnostics();
  {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    publishers_.advertise(private_nh, settings_.latch,
                          [this](const ros::SingleSubscriberPublisher&) { updateSubscriptions(); });
  }
  const auto missing = [this] {
    const InputState state = inputState();
    return state.frames > 0 ? std::string("frames come, but is the time-out longer than one takes?")
                            : missingInput(state);
  };
  service_ = std::make_unique<SegmentService>(
      private_nh, requests_, settings_.service_timeout_s, [this] { updateSubscriptions(); }, missing);
  updateSubscriptions();
}

/// Not by the built-in one in its place: results of another model than the one asked for would look as good.
void SegmentObjectsNodelet::loadModel(const std::string& path) {
  auto loaded = objectness::loadModel(path);
  if (loaded.ok()) {
    model_ = std::move(loaded.value);
    return;
  }
  model_status_ = Status::error(StatusCode::kBadConfig, "~model " + path + ": " + loaded.status.message);
  NODELET_ERROR("no frame will be segmented: %s", model_status_.message.c_str());
}

void SegmentObjectsNodelet::startReconfigure() {
  writeReconfigurable(config_, getPrivateNodeHandle());
  reconfigure_server_ = std::make_unique<ReconfigureServer>(reconfigure_mutex_, getPrivateNodeHandle());
  reconfigure_server_->getConfigDefault(accepted_);
  reconfigure_server_->setCallback([this](ObjectnessSegmentationConfig& requested, std::uint32_t) {
    guarded([&] { reconfigure(requested); }, [this](const std::string& what) { noteException(what); });
  });
}

void SegmentObjectsNodelet::startDiagnostics() {
  diagnostics_ = std::make_unique<diagnostic_updater::Updater>(getNodeHandle(), getPrivateNodeHandle(), getName());
  diagnostics_->setHardwareID("none");
  diagnostics_->add("segmentation", this, &SegmentObjectsNodelet::diagnose);
  // Wall time: simulated time jumps back when a bag loops, and ROS timers then stand still.
  diagnostics_timer_ = getNodeHandle().createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) {
    guarded([this] { diagnostics_->force_update(); }, [this](const std::string& what) { noteException(what); });
  });
}

SegmentObjectsNodelet::~SegmentObjectsNodelet() {
  // Shutdown order: service, inputs, reconfigure, worker, then the publishers it writes to.
  diagnostics_timer_.stop();
  if (service_) service_->stop();
  {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    inputs_.reset();
  }
  if (reconfigure_server_) reconfigure_server_->clearCallback();
  if (worker_) worker_->stop();
}

void SegmentObjectsNodelet::noteException(const std::string& what) {
  statistics_.noteException(what);
  if (problems_.isDue("exception")) NODELET_ERROR("exception: %s", what.c_str());
}

void SegmentObjectsNodelet::updateSubscriptions() {
  const auto update = [this] {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    if (!inputs_) return;
    const bool wanted = !settings_.lazy || requests_.pending() || publishers_.haveSubscribers();
    if (wanted && !inputs_->subscribed()) {
      statistics_.resetInputAge();
      inputs_->subscribe();
    } else if (!wanted && inputs_->subscribed()) {
      inputs_->unsubscribe();
    }
  };
  guarded(update, [this](const std::string& what) {  // a topic of another type, for one
    statistics_.noteException(what);
    if (problems_.isDue("subscribing")) NODELET_ERROR("subscribing to the inputs failed: %s", what.c_str());
  });
}

void SegmentObjectsNodelet::handOver(const InputMessages& messages) {
  statistics_.countInput();
  worker_->submit({messages, requests_.newestAnsweredBy(messages.header().stamp.toSec(), ros::Time::now().toSec())});
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

InputState SegmentObjectsNodelet::inputState() {
  std::lock_guard<std::mutex> lock(connect_mutex_);
  InputState state = inputs_ ? inputs_->state() : InputState();
  state.dropped_frames = worker_->dropped();
  return state;
}

void SegmentObjectsNodelet::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const FrameStatistics::Snapshot snapshot = statistics_.take();
  const InputState inputs = inputState();
  describe(snapshot, inputs, status);
  const auto awaited = awaitedInput(snapshot, inputs);
  // Once: the diagnostics go on saying it.
  if (awaited && !std::exchange(input_was_missing_, true)) NODELET_WARN("%s", awaited->c_str());
  if (!awaited && inputs.frames > 0) input_was_missing_ = false;
  if (!model_status_.ok()) status.summary(diagnostic_msgs::DiagnosticStatus::ERROR, model_status_.message);
  std::string yaml;
  {
    std::lock_guard<std::mutex> lock(config_mutex_);
    yaml = objectness::toYaml(config_);
  }
  status.addf("configuration", "%016zx", std::hash<std::string>()(yaml));
}

void SegmentObjectsNodelet::process(const Job& job) {
  const auto start = std::chrono::steady_clock::now();
  objectness::Config config;
  {
    std::lock_guard<std::mutex> lock(config_mutex_);
    config = config_;
  }
  const std_msgs::Header& header = job.messages.header();
  try {
    ProcessedFrame frame;
    frame.result = failedFrame(model_status_);
    if (model_status_.ok()) frame = processor_->process(job.messages, config, model_, worker_->stopFlag());
    if (worker_->stopFlag()) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    report(frame.result, 1e3 * elapsed.count());
    const SegmentedObjectArrayConstPtr objects =
        publishers_.publish(frame, header, settings_.target_frame, config, {elapsed.count(), worker_->dropped()},
                            requests_.wants(job.request_id));
    if (objects) requests_.answer(job.request_id, objects);
  } catch (const std::exception& e) {
    if (requests_.wants(job.request_id)) {
      const SegmentedFrame failure = failedFrame(Status::error(StatusCode::kInternalError, e.what()));
      requests_.answer(job.request_id, boost::make_shared<SegmentedObjectArray>(toObjectsMessage(failure, header)));
    }
    throw;
  }
}

/// What becomes of a frame, for the diagnostics and the log.
void SegmentObjectsNodelet::report(const SegmentedFrame& result, double milliseconds) {
  const objectness::Segmentation& segmentation = result.segmentation;
  const Status& status = segmentation.status;
  if (status.code == StatusCode::kInternalError) statistics_.noteException(status.message);
  statistics_.noteStages(segmentation.report.timings_ms, boxesScored(segmentation.report));
  statistics_.noteRemark(join(result.remarks));
  statistics_.countOutput(status, segmentation.segments.size(), milliseconds);
  if (!status.ok() && problems_.isDue(objectness::toString(status.code))) {
    NODELET_WARN("frame not segmented (%s): %s", objectness::toString(status.code), status.message.c_str());
  }
  for (const std::string& remark : result.remarks) {
    if (problems_.isTextDue("remark", remark)) NODELET_WARN("%s", remark.c_str());
  }
}

}  // namespace objectness_segmentation

PLUGINLIB_EXPORT_CLASS(objectness_segmentation::SegmentObjectsNodelet, nodelet::Nodelet)
