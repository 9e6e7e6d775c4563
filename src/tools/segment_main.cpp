// SPDX-License-Identifier: BSD-3-Clause
// Segments scene folders and PCD files: see `segment --help`.
#include <unistd.h>

#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
#include <opencv2/core/utils/logger.hpp>
#include <sstream>

#include "common/frame_memory.hpp"
#include "objectness_segmentation/io/input_file.hpp"
#include "objectness_segmentation/io/result_writer.hpp"
#include "objectness_segmentation/pipeline.hpp"
#include "tools/segment_options.hpp"
#include "tools/tool_message.hpp"

namespace {

using namespace objectness;
namespace fs = std::filesystem;

enum ExitStatus { kAllDone = 0, kSomeFailed = 1, kUsageError = 2 };

/// What a terminal shows while many inputs are at work; the line is gone before anything else is printed.
class Progress {
 public:
  explicit Progress(std::size_t count) : count_(count), shown_(count > 1 && isatty(STDERR_FILENO)) {}

  void show(std::size_t index, const std::string& name) const {
    if (shown_) std::cerr << "\r\033[K[" << index + 1 << "/" << count_ << "] " << name << std::flush;
  }
  void clear() const {
    if (shown_) std::cerr << "\r\033[K" << std::flush;
  }

 private:
  std::size_t count_;
  bool shown_;
};

void printError(const std::string& message) { printToolMessage("segment", message); }

/// One input from file to results; a line of what was found in `summary`.
Status segmentInput(const std::string& input, const std::string& folder, const SegmentOptions& options,
                    std::string& summary, std::vector<std::string>& remarks) {
  const Result<Frame> frame = loadInput(input, options.camera, options.config.input);
  if (!frame.ok()) return frame.status;
  const Segmentation result =
      options.model ? segment(frame.value, options.config, *options.model) : segment(frame.value, options.config);
  remarks = result.report.remarks;
  if (!result.status.ok()) return result.status;
  const Status written = writeResult(folder, input, frame.value, result, options.pictures);
  std::ostringstream text;
  text << result.segments.size() << (result.segments.size() == 1 ? " object, " : " objects, ") << std::fixed
       << std::setprecision(0) << result.report.timings_ms.back().second << " ms";
  summary = text.str();
  return written;
}

/// Empty when `name` may be used for the results of `input`.
std::string nameProblem(const std::string& input, const std::string& name, std::map<std::string, std::string>& taken) {
  if (name.empty()) return "has no name to call its results by: give the folder of one scene";
  const auto [earlier, is_new] = taken.emplace(name, input);
  if (is_new) return "";
  return "its results would overwrite those of " + earlier->second + ", which has the name " + name +
         " too: run them apart with different --out";
}

int run(const SegmentOptions& options) {
  std::error_code error, ignored;
  fs::create_directories(options.out, error);
  if (!fs::is_directory(options.out, ignored) || access(options.out.c_str(), W_OK) != 0) {
    const std::string reason = error                                    ? error.message()
                               : fs::is_directory(options.out, ignored) ? "no permission to write"
                                                                        : "it is a file";
    printError("--out " + options.out + ": cannot write there: " + reason);
    return kSomeFailed;
  }
  const Progress progress(options.inputs.size());
  std::map<std::string, std::string> taken;
  ExitStatus exit_status = kAllDone;
  for (std::size_t i = 0; i < options.inputs.size(); ++i) {
    const std::string& input = options.inputs[i];
    const std::string name = inputName(input);
    progress.show(i, name);
    std::string problem = nameProblem(input, name, taken), summary;
    std::vector<std::string> remarks;
    if (problem.empty()) {
      const std::string folder = (fs::path(options.out) / name).string();
      try {
        problem = segmentInput(input, folder, options, summary, remarks).message;
      } catch (const std::bad_alloc&) {
        problem = "needs more memory than there is";
      } catch (const std::exception& e) {
        problem = e.what();
      }
      if (!problem.empty()) removeResult(folder);
    }
    progress.clear();
    for (const std::string& remark : remarks) printError(input + ": " + remark);
    if (problem.empty()) {
      std::cout << name << ": " << summary << std::endl;
    } else {
      printError(input + ": " + problem);
      exit_status = kSomeFailed;
    }
  }
  return exit_status;
}

}  // namespace

int main(int argc, char** argv) {
  // Every problem is reported once, in our words.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  const Result<SegmentOptions> options = parseSegmentOptions(argc, argv);
  if (!options.ok()) {
    printError(options.status.message + " (segment --help)");
    return kUsageError;
  }
  if (!options.value.print.empty()) {
    std::cout << options.value.print << std::flush;
    return std::cout ? kAllDone : kSomeFailed;
  }
  keepFrameMemory();
  return run(options.value);
}
