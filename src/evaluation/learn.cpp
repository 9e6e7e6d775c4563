// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/learn.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>

#include "common/parallel.hpp"
#include "io/png_file.hpp"
#include "objectness_segmentation/io/scene_folder.hpp"
#include "objectness_segmentation/pipeline.hpp"

namespace objectness::evaluation {
namespace {

struct Labelled {
  Status status;
  Frame frame;
  cv::Mat_<ushort> truth;
};

/// What a scene teaches.
struct Lesson {
  Samples contact = samplesOf<ContactCues>(), gap = samplesOf<GapCues>(), group = samplesOf<GroupCues>();
  int fold = 0, weight = 1;
  std::string problem;
};

Labelled load(const Scene& scene, const Config& config) {
  Labelled labelled;
  const Result<Frame> frame = loadSceneFolder(scene.folder, {}, config.input);
  const Result<cv::Mat> truth = readPng(scene.folder + "/labels.png", PngKind::kLabels);
  labelled.status = frame.ok() ? truth.status : frame.status;
  if (!labelled.status.ok()) return labelled;
  if (truth.value.size() != cv::Size(frame.value.width(), frame.value.height())) {
    labelled.status = Status::error(StatusCode::kSizeMismatch, "labels.png is not of the size of depth.png");
    return labelled;
  }
  if (frame.value.rectified) {
    labelled.status = Status::error(StatusCode::kBadCamera,
                                    "its depth image is not rectified, and labels.png of other pixels than the frame");
    return labelled;
  }
  labelled.frame = frame.value;
  labelled.truth = truth.value;
  return labelled;
}

void append(const Samples& from, Samples& to) {
  to.values.insert(to.values.end(), from.values.begin(), from.values.end());
  to.targets.insert(to.targets.end(), from.targets.begin(), from.targets.end());
}

/// The samples of one kind of all lessons but those of a fold (-1: of all).
Samples gather(const std::vector<Lesson>& lessons, Samples Lesson::*kind, int but_fold) {
  Samples all = lessons.front().*kind;
  all.values.clear();
  all.targets.clear();
  for (const Lesson& lesson : lessons) {
    for (int k = 0; k < lesson.weight && lesson.fold != but_fold; ++k) append(lesson.*kind, all);
  }
  return all;
}

class Learner {
 public:
  Learner(const std::vector<Scene>& scenes, const LearnSettings& settings) : scenes_(scenes), settings_(settings) {
    settings_.config.runtime.threads = 1;  // scenes are dealt to the threads
    lessons_.resize(scenes.size());
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < scenes.size(); ++i) lessons_[i].fold = seen[scenes[i].group]++ % settings.folds;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const auto weight = settings.weights.find(scenes[i].folder);
      if (weight != settings.weights.end()) lessons_[i].weight = weight->second;
    }
  }

  Result<LearnedModel> run() {
    forEachScene("pairs", [&](const Labelled& labelled, Lesson& lesson) {
      const TrainingScene scene = observe(labelled.frame, labelled.truth, settings_.config);
      if (!scene.status.ok()) lesson.problem = scene.status.message;
      addPairSamples(scene, settings_.training, lesson.contact, lesson.gap);
    });
    // A model for each fold, learned without it, and at the end the one of all scenes.
    std::vector<LearnedObjectness> folds(settings_.folds + 1);
    std::vector<Status> statuses(folds.size());
    forEachModel([&](int model, int but_fold) { statuses[model] = trainPairs(but_fold, folds[model]); });
    for (const Status& status : statuses) {
      if (!status.ok()) return Result<LearnedModel>::error(status);
    }
    forEachScene("groups", [&](const Labelled& labelled, Lesson& lesson) {
      if (!lesson.problem.empty()) return;
      const TrainingScene scene = observe(labelled.frame, labelled.truth, settings_.config);
      addGroupSamples(scene, folds[lesson.fold], settings_.config, settings_.training, lesson.group);
    });
    forEachModel([&](int model, int but_fold) {
      folds[model].group = trainForest(gather(lessons_, &Lesson::group, but_fold), settings_.training.group);
    });
    std::vector<std::optional<Scores>> scores(scenes_.size());
    forEachScene("held out", [&](const Labelled& labelled, Lesson& lesson) {
      // A scene whose table is not found counts as one where nothing was found, as it does in use.
      const Segmentation result = segment(labelled.frame, settings_.config, folds[lesson.fold]);
      scores[&lesson - lessons_.data()] = scoreLabels(result.labels, truthAtLevel(labelled.truth, Level::kObject));
    });

    Result<LearnedModel> learned;
    LearnedModel& result = learned.value;
    result.model = std::move(folds.back());
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      result.contacts += lessons_[i].contact.size();
      result.gaps += lessons_[i].gap.size();
      result.groups += lessons_[i].group.size();
      if (!lessons_[i].problem.empty()) result.notes.push_back(scenes_[i].folder + ": " + lessons_[i].problem);
      if (scores[i]) result.held_out.push_back({scenes_[i].name, scenes_[i].group, *scores[i]});
    }
    return learned;
  }

 private:
  template <class Work>
  void forEachScene(const char* stage, Work&& work) {
    std::mutex mutex;
    std::size_t done = 0;
    parallelFor(static_cast<int>(scenes_.size()), settings_.threads, [&](int i) {
      const Labelled labelled = load(scenes_[i], settings_.config);
      if (labelled.status.ok()) {
        work(labelled, lessons_[i]);
      } else {
        lessons_[i].problem = labelled.status.message;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      if (settings_.progress) settings_.progress(stage, ++done, scenes_.size());
    });
  }

  template <class Train>
  void forEachModel(Train&& train) {
    parallelFor(settings_.folds + 1, settings_.threads,
                [&](int model) { train(model, model < settings_.folds ? model : -1); });
  }

  Status trainPairs(int but_fold, LearnedObjectness& model) const {
    const Samples contact = gather(lessons_, &Lesson::contact, but_fold);
    const Samples gap = gather(lessons_, &Lesson::gap, but_fold);
    for (const Samples* samples : {&contact, &gap}) {
      if (samples == &gap && !settings_.config.links.gaps) continue;
      const auto same = std::count(samples->targets.begin(), samples->targets.end(), 1.f);
      if (same > 0 && same < static_cast<long>(samples->size())) continue;
      return Status::error(StatusCode::kBadInput, "the scenes hold no two pieces of one object, or none of two, that " +
                                                      std::string(samples == &contact ? "touch" : "do not touch") +
                                                      ": more and fuller scenes are needed");
    }
    model.contact = trainForest(contact, settings_.training.contact);
    // A model has all its parts: one that saw no gap takes the sides of every gap for two objects.
    model.gap =
        settings_.config.links.gaps ? trainForest(gap, settings_.training.gap) : Forest{gap.cues, {{Forest::Node{}}}};
    return {};
  }

  const std::vector<Scene>& scenes_;
  LearnSettings settings_;
  std::vector<Lesson> lessons_;
};

}  // namespace

Result<LearnedModel> learn(const std::vector<Scene>& scenes, const LearnSettings& settings) {
  if (settings.folds < 2) {
    return Result<LearnedModel>::error(StatusCode::kBadInput,
                                       std::to_string(settings.folds) + " folds: there must be at least 2");
  }
  if (scenes.size() < static_cast<std::size_t>(settings.folds)) {
    return Result<LearnedModel>::error(
        StatusCode::kBadInput,
        std::to_string(scenes.size()) + " scenes are too few for " + std::to_string(settings.folds) + " folds");
  }
  return Learner(scenes, settings).run();
}

}  // namespace objectness::evaluation
