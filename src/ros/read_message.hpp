// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <rosbag/view.h>

namespace objectness_segmentation {

/// Messages whose definition differs from the one this program was built with cannot be read.
template <class Message>
boost::shared_ptr<const Message> readMessage(const rosbag::MessageInstance& entry) {
  boost::shared_ptr<const Message> message = entry.instantiate<Message>();
  if (!message) {
    throw rosbag::BagFormatException(entry.getTopic() + " holds another version of " +
                                     ros::message_traits::datatype<Message>());
  }
  return message;
}

}  // namespace objectness_segmentation
