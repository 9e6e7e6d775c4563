// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace objectness {

/// Accepted values of a configuration field, both ends included; in the unit its name ends with.
///
/// Every configuration struct declares its defaults as member initializers and describes its fields once in
///     template <class Self, class Visit> static void fields(Self& self, Visit&& visit)
/// which calls visit(name, member, Range, description) for each; bool and enumerated fields take visit(name, member,
/// description).
/// validate(), the YAML reader, `--set`, rosparam and dynamic_reconfigure all read that one list.
struct Range {
  double min;
  double max;
};

}  // namespace objectness
