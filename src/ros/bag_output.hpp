// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>

#include <exception>
#include <memory>
#include <string>

#include "objectness_segmentation/common/status.hpp"

namespace objectness_segmentation {

/// A bag to be written: what goes wrong is kept as a status, and everything after it is left out. The same messages
/// give the same bytes.
class BagOutput {
 public:
  /// Replaces a file of that name.
  explicit BagOutput(const std::string& path);
  ~BagOutput() { static_cast<void>(close()); }

  const objectness::Status& status() const { return status_; }

  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    guard([&] { bag_->write(topic, time, message); });
  }

  /// As a latching publisher's: rosbag play hands it to subscribers that come later, too.
  template <class Message>
  void writeLatched(const std::string& topic, const ros::Time& time, const Message& message) {
    namespace traits = ros::message_traits;
    auto header = boost::make_shared<ros::M_string>();
    *header = {{"type", traits::datatype(message)},
               {"md5sum", traits::md5sum(message)},
               {"message_definition", traits::definition(message)},
               {"latching", "1"}};
    guard([&] { bag_->write(topic, time, message, header); });
  }

  /// Writes the index, without which a bag cannot be read. Messages written before a failure stay readable.
  objectness::Status close();

 private:
  template <class Action>
  void guard(const Action& action) {
    if (!status_.ok()) return;
    try {
      action();
    } catch (const std::exception& e) {
      status_ =
          objectness::Status::error(objectness::StatusCode::kBadInput, std::string("cannot be written: ") + e.what());
    }
  }

  std::unique_ptr<rosbag::Bag> bag_;
  objectness::Status status_;
};

}  // namespace objectness_segmentation
