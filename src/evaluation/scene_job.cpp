// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/scene_job.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <filesystem>
#include <new>
#include <set>

#include "evaluation/true_boxes.hpp"
#include "io/file_access.hpp"
#include "io/png_file.hpp"
#include "objectness_segmentation/io/overlay.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"

namespace objectness::evaluation {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMaxFileBytes = 1u << 30;

std::string checksum(const std::string& bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return std::to_string(crc.checksum());
}

/// The most memory this process held so far.
double peakMemoryMib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// The true objects, drawn as a result is.
cv::Mat_<cv::Vec3b> drawTruth(const Frame& frame, const cv::Mat_<ushort>& truth) {
  Segmentation drawn;
  for (int i = 0; i < frame.size(); ++i) {
    const int label = truth(i / truth.cols, i % truth.cols);
    if (label < kFirstObjectLabel) continue;
    const auto rank = static_cast<std::size_t>(label - kFirstObjectLabel);
    if (rank >= drawn.segments.size()) drawn.segments.resize(rank + 1);
    drawn.segments[rank].pixels.push_back(i);
  }
  return drawOverlay(frame, drawn);
}

std::string sizeText(const cv::Size& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

int countObjects(const cv::Mat_<ushort>& annotation) {
  std::set<ushort> objects;
  for (const ushort label : truthAtLevel(annotation, Level::kObject)) {
    if (label >= kFirstObjectLabel) objects.insert(label);
  }
  return static_cast<int>(objects.size());
}

/// true_labels: empty where there are none.
Segmentation runGuarded(const Method& method, const Frame& frame, const cv::Mat_<ushort>& true_labels) {
  Segmentation result;
  try {
    result = method.run_knowing ? method.run_knowing(frame, true_labels) : method.run(frame);
    if (result.status.ok() && result.labels.size() != cv::Size(frame.width(), frame.height())) {
      result.status = Status::error(StatusCode::kInternalError, "returned labels of another size than the frame's");
    }
  } catch (const std::bad_alloc&) {
    result.status = Status::error(StatusCode::kInternalError, "needs more memory than there is");
  } catch (const std::exception& e) {
    result.status = Status::error(StatusCode::kInternalError, e.what());
  }
  return result;
}

/// One evaluation from files to files.
class Job {
 public:
  Job(const std::string& report, const Scene& scene, const Method& method, const std::string& made_from)
      : report_(report), scene_(scene), method_(method) {
    result_.scene = scene.name;
    result_.method = method.name;
    result_.made_from = made_from;
  }

  Status run() {
    if (!loadTruth()) return saveResult(report_, result_);
    const Result<Frame> frame = loadSceneFolder(scene_.folder, {}, method_.input);
    if (!frame.ok()) return fail(frame.status.message);
    const std::string misfit = misfitOfTruth(frame.value);
    if (!misfit.empty()) return refuse(misfit);
    const Segmentation found = runGuarded(afterFramesBefore(), frame.value, annotation_);
    result_.peak_mib = peakMemoryMib();
    result_.timings_ms = found.report.timings_ms;
    if (found.report.selection_gap) result_.gaps.emplace_back("selection_gap", *found.report.selection_gap);
    if (found.report.annealing_gap) result_.gaps.emplace_back("annealing_gap", *found.report.annealing_gap);
    if (!found.status.ok()) return fail(found.status.message);
    result_.segments = static_cast<int>(found.segments.size());
    result_.segment_boxes = segmentBoxes(frame.value, found);
    result_.up = found.table.T_table_camera.linear().row(2).transpose();
    score(found.labels);
    if (hasLabels()) result_.box_fits = measureBoxFits(frame.value, found, annotation_, true_boxes_);
    if (method_.proposes_boxes && hasLabels()) {
      const auto boxes = findTrueBoxes(scene_.folder, frame.value, found.table, annotation_);
      if (!boxes.ok()) return refuse(boxes.status.message);
      result_.proposals =
          toMetrics(measureProposals(frame.value, found, annotation_, boxes.value, FilterConfig{}.box_margin_m));
    }
    const Status pictures = savePictures(frame.value, found);
    return pictures.ok() ? saveResult(report_, result_) : pictures;
  }

  Status runNothing(const std::string& failure) { return loadTruth() ? fail(failure) : saveResult(report_, result_); }

 private:
  /// The method in the state that the frames before this one leave it in.
  Method afterFramesBefore() const {
    Method method = method_;
    if (scene_.before.empty() || !method.follow || method.fuse_frames < 1) return method;
    method.run = method.follow(method.fuse_frames);
    for (const std::string& folder : scene_.before) {
      const Result<Frame> frame = loadSceneFolder(folder, {}, method.input);
      if (frame.ok()) runGuarded(method, frame.value, {});
    }
    return method;
  }

  bool hasLabels() const { return !annotation_.empty(); }

  /// Otherwise the result says why.
  bool loadTruth() {
    std::error_code ignored;
    fs::remove_all(resultPath(report_, method_.name, scene_.name), ignored);  // the pictures of an earlier result
    result_.state = SceneResult::State::kUnusable;
    const Result<std::vector<PictureBox>> boxes = loadPictureBoxes(scene_.folder);
    if (!boxes.ok()) {
      result_.problem = boxes.status.message;
      return false;
    }
    picture_boxes_ = boxes.value;
    const fs::path labels = fs::path(scene_.folder) / "labels.png";
    const bool must_be_there = picture_boxes_.empty() && scene_.needs_truth;
    if (must_be_there || fs::exists(labels, ignored)) {
      const Result<cv::Mat> read = readPng(labels.string(), PngKind::kLabels);
      if (!read.ok()) {
        result_.problem = "labels.png: " + read.status.message;
        return false;
      }
      annotation_ = read.value;
    }
    if (hasLabels()) {
      const Result<std::vector<TrueBox>> true_boxes = loadVisibleTrueBoxes(scene_.folder, annotation_);
      if (!true_boxes.ok()) {
        result_.problem = true_boxes.status.message;
        return false;
      }
      true_boxes_ = true_boxes.value;
    }
    const bool told_nothing = method_.run_knowing && !hasLabels();
    result_.state = told_nothing ? SceneResult::State::kNotApplicable : SceneResult::State::kDone;
    return !told_nothing;
  }

  /// Why the truth cannot be compared with what is found in the frame; empty when it can.
  std::string misfitOfTruth(const Frame& frame) const {
    const cv::Size size(frame.width(), frame.height());
    const std::string file = hasLabels() ? "labels.png" : "objects.yaml";
    if (frame.rectified && (hasLabels() || !picture_boxes_.empty())) {
      return "its depth image is not rectified, and " + file + " of other pixels than the results: rectify both";
    }
    if (hasLabels() && annotation_.size() != size) {
      return "labels.png is " + sizeText(annotation_.size()) + ", depth.png is " + sizeText(size) +
             ": they must be of equal size";
    }
    const auto outside = [&](const PictureBox& object) { return !cv::Rect({0, 0}, size).contains(object.seed); };
    const bool any = std::any_of(picture_boxes_.begin(), picture_boxes_.end(), outside);
    return any ? "objects.yaml: a seed lies outside the picture of " + sizeText(size) : "";
  }

  Status refuse(const std::string& problem) {
    result_.state = SceneResult::State::kUnusable;
    result_.problem = problem;
    return saveResult(report_, result_);
  }

  Status fail(const std::string& problem) {
    result_.state = SceneResult::State::kFailed;
    result_.problem = problem;
    scoreNothing();
    if (method_.proposes_boxes && hasLabels()) {
      ProposalMetrics none;
      none.objects = countObjects(annotation_);
      result_.proposals = toMetrics(none);
    }
    return saveResult(report_, result_);
  }

  void score(const cv::Mat_<ushort>& labels) {
    if (!picture_boxes_.empty()) result_.picture_boxes = countPictureBoxes(labels, picture_boxes_);
    if (!hasLabels()) return;
    result_.object = scoreLabels(labels, truthAtLevel(annotation_, Level::kObject));
    result_.part = scoreLabels(labels, truthAtLevel(annotation_, Level::kPart));
  }

  void scoreNothing() {
    if (!picture_boxes_.empty()) {
      result_.picture_boxes = PictureBoxCounts{};
      result_.picture_boxes->objects = static_cast<int>(picture_boxes_.size());
    }
    for (const TrueBox& box : true_boxes_) {
      result_.box_fits.emplace_back();
      result_.box_fits.back().object = box.object;
      result_.box_fits.back().kind = box.kind;
    }
    if (!hasLabels()) return;
    const cv::Mat_<ushort> nothing(annotation_.size(), ushort{0});
    result_.object = scoreLabels(nothing, truthAtLevel(annotation_, Level::kObject));
    result_.part = scoreLabels(nothing, truthAtLevel(annotation_, Level::kPart));
  }

  Status savePictures(const Frame& frame, const Segmentation& found) const {
    const fs::path folder = resultPath(report_, method_.name, scene_.name), truth = fs::path(report_) / "truth";
    Status status = makeFolder(folder.string());
    if (status.ok()) status = makeFolder((truth / scene_.name).parent_path().string());
    if (status.ok()) status = writePng((folder / "labels.png").string(), found.labels);
    if (status.ok()) status = writePng((folder / "overlay.png").string(), drawOverlay(frame, found));
    if (!status.ok() || !hasLabels()) return status;
    // Every method draws it; the same picture, and writing is atomic only within one process: a name for each.
    const fs::path own = truth / (scene_.name + "." + method_.name + ".png"), shared = truth / (scene_.name + ".png");
    status = writePng(own.string(), drawTruth(frame, truthAtLevel(annotation_, Level::kObject)));
    if (!status.ok()) return status;
    std::error_code error;
    fs::rename(own, shared, error);
    return error ? Status::error(StatusCode::kBadInput, "cannot write " + shared.string() + ": " + error.message())
                 : Status{};
  }

  const std::string& report_;
  const Scene& scene_;
  const Method& method_;
  cv::Mat_<ushort> annotation_;            ///< empty where there is no labels.png
  std::vector<PictureBox> picture_boxes_;  ///< empty where there are none in objects.yaml
  std::vector<TrueBox> true_boxes_;        ///< of visible objects; empty where there are none in objects.yaml
  SceneResult result_;
};

}  // namespace

std::string madeFrom(const std::string& commit, const Method& method, const Scene& scene) {
  std::string files;
  for (const char* name : {"depth.png", "color.png", "camera.yaml", "labels.png", "objects.yaml"}) {
    const Result<std::string> bytes = readFile((fs::path(scene.folder) / name).string(), kMaxFileBytes);
    files += name + checksum(bytes.value);  // a missing file is the job's business
  }
  for (const std::string& folder : scene.before) {
    files += checksum(readFile((fs::path(folder) / "depth.png").string(), kMaxFileBytes).value);
  }
  return "commit " + commit + ", settings " + checksum(method.settings) + ", input " + checksum(files);
}

Status evaluateScene(const std::string& report, const Scene& scene, const Method& method,
                     const std::string& made_from) {
  return Job(report, scene, method, made_from).run();
}

Status recordFailure(const std::string& report, const Scene& scene, const Method& method, const std::string& made_from,
                     const std::string& failure) {
  return Job(report, scene, method, made_from).runNothing(failure);
}

}  // namespace objectness::evaluation
