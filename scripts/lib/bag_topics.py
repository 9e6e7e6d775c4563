#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the arguments of demo.launch that fit a bag: bag_topics.py BAG [POINTS_TOPIC [CAMERA_INFO_TOPIC]].

Without topics, the organized clouds with the most messages are taken, and the camera_info whose name is nearest to theirs.
"""
import os
import sys

import rosbag


class BagError(Exception):
    pass


def choose_topics(bag, points, camera_info):
    """Returns the topics of the clouds and of their camera, chosen where they are None."""
    topics = bag.get_type_and_topic_info().topics
    by_type = {kind: [name for name, info in topics.items() if info.msg_type == kind and info.message_count]
               for kind in ('sensor_msgs/PointCloud2', 'sensor_msgs/CameraInfo')}
    for kind, wanted in zip(by_type, (points, camera_info)):
        if not by_type[kind] or wanted not in [None] + by_type[kind]:
            raise BagError(f'no {kind} on {wanted or "any topic"}; the bag has: ' +
                           (', '.join(f'{name} ({info.msg_type})' for name, info in topics.items()) or 'nothing'))
    if points is None:
        organized = [name for name in by_type['sensor_msgs/PointCloud2']
                     if next(bag.read_messages(topics=[name])).message.height > 1]
        if not organized:
            raise BagError('its clouds are not organized (height 1); record the cloud of the camera driver as it is')
        points = max(organized, key=lambda name: topics[name].message_count)
    if camera_info is None:
        camera_info = max(by_type['sensor_msgs/CameraInfo'], key=lambda name: len(os.path.commonprefix([name, points])))
    return points, camera_info


def launch_arguments(bag, points, camera_info):
    points, camera_info = choose_topics(bag, points, camera_info)
    header = next(bag.read_messages(topics=[points])).message.header
    stamps = (message.message.header.stamp for message in bag.read_messages(topics=[camera_info]))
    return {'points': points, 'camera_info': camera_info, 'frame': header.frame_id,
            'approximate_sync': 'false' if header.stamp in stamps else 'true'}


def main():
    path, *topics = sys.argv[1:]
    points, camera_info = ([topic or None for topic in topics] + [None, None])[:2]
    try:
        with rosbag.Bag(path) as bag:
            for name, value in launch_arguments(bag, points, camera_info).items():
                print(f'{name}:={value}')
    except (OSError, BagError, rosbag.ROSBagException) as error:
        print(f'{path}: {error}', file=sys.stderr)
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
