// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "evaluation/methods.hpp"
#include "evaluation/scene_result.hpp"
#include "evaluation/scenes.hpp"

namespace objectness::evaluation {

/// What a result is made from, in one text: the commit, the method's settings and the bytes of the scene's files.
std::string madeFrom(const std::string& commit, const Method& method, const Scene& scene);

/// Runs a method in a scene and leaves in the report folder results/\<method\>/\<scene\>.json, labels.png and
/// overlay.png in results/\<method\>/\<scene\>, and truth/\<scene\>.png, a picture of the true objects. Whatever goes
/// wrong is in the result. An error: the result could not be written.
Status evaluateScene(const std::string& report, const Scene& scene, const Method& method, const std::string& made_from);

/// The result of a method that did not live to leave one: as if it had found nothing.
Status recordFailure(const std::string& report, const Scene& scene, const Method& method, const std::string& made_from,
                     const std::string& failure);

}  // namespace objectness::evaluation
