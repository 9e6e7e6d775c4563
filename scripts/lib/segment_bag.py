#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sends every cloud of a bag to a running node, one after the other, and prints the objects it finds in each.

segment_bag.py BAG NODE [POINTS_TOPIC [CAMERA_INFO_TOPIC]]; without topics the bag's organized clouds with the most
messages are taken, and the camera_info whose name is nearest to theirs.
"""
import os
import queue
import sys

import rosbag
import rospy
from objectness_segmentation.msg import SegmentedObjectArray
from sensor_msgs.msg import CameraInfo, PointCloud2

from print_objects import HEADER, row

CONNECTION_TIMEOUT_S = 60
FRAME_TIMEOUT_S = 120


class BagError(Exception):
    pass


def choose_topics(bag, points, camera_info):
    """Returns the topics of the clouds and of their camera, chosen where they are None."""
    topics = bag.get_type_and_topic_info().topics
    by_type = {kind: [name for name, info in topics.items() if info.msg_type == kind]
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


def frames(bag, points, camera_info):
    """Yields (cloud, camera_info with the cloud's header): the latest before the cloud, for the first ones the first."""
    camera = next(bag.read_messages(topics=[camera_info])).message
    for topic, message, _ in bag.read_messages(topics=[points, camera_info]):
        if topic == camera_info:
            camera = message
        else:
            camera.header = message.header
            yield message, camera


def wait_until(condition, what):
    for _ in range(10 * CONNECTION_TIMEOUT_S):
        if condition():
            return
        if rospy.is_shutdown():
            break
        rospy.rostime.wallsleep(0.1)
    raise BagError(f'the node {what}')


def describe(number, result):
    status = f'{len(result.objects)} object(s), {1000 * result.processing_time:.0f} ms' if result.status == result.OK \
        else result.message
    print(f'frame {number} (stamp {result.header.stamp.to_sec():.3f}, {result.header.frame_id}): {status}')
    if result.objects:
        print(HEADER)
    for item in result.objects:
        centre, size = item.pose.position, item.dimensions
        print(row(item.label, (centre.x, centre.y, centre.z), (size.x, size.y, size.z), item.objectness,
                  len(item.indices.indices)))
    sys.stdout.flush()


def segment_bag(bag, node, points, camera_info):
    points, camera_info = choose_topics(bag, points, camera_info)
    print(f'clouds {points}, camera {camera_info}')
    rospy.init_node('segment_bag', anonymous=True, disable_signals=True)
    results = queue.Queue()
    subscriber = rospy.Subscriber(f'{node}/objects', SegmentedObjectArray, results.put)
    clouds = rospy.Publisher('points', PointCloud2, queue_size=1)
    cameras = rospy.Publisher('camera_info', CameraInfo, queue_size=1)
    # The node may listen only once somebody wants its objects.
    wait_until(lambda: subscriber.get_num_connections() and clouds.get_num_connections() and
               cameras.get_num_connections(), 'does not listen to points and camera_info')
    number = 0
    for number, (cloud, camera) in enumerate(frames(bag, points, camera_info), 1):
        cameras.publish(camera)
        clouds.publish(cloud)
        while True:
            try:
                result = results.get(timeout=FRAME_TIMEOUT_S)
            except queue.Empty:
                raise BagError(f'the node sent nothing for frame {number} within {FRAME_TIMEOUT_S} s') from None
            if result.header.stamp == cloud.header.stamp:
                break
        describe(number, result)
    print(f'{number} frame(s) done')


def main():
    path, node, *topics = sys.argv[1:]
    points, camera_info = ([topic or None for topic in topics] + [None, None])[:2]
    try:
        with rosbag.Bag(path) as bag:
            segment_bag(bag, node, points, camera_info)
    except (OSError, BagError, rosbag.ROSBagException, rospy.ROSException) as error:
        print(f'{path}: {error}', file=sys.stderr)
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
