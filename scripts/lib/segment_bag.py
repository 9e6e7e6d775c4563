#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the objects that the node finds in every cloud of a bag: segment_bag.py BAG NODE_EXECUTABLE LOG_DIR [POINTS [INFO]].

Starts a master on a port of its own and the node, and sends one cloud after the other: played by rosbag, a newer cloud
would replace one that still waits. Without topics, the organized clouds with the most messages are taken, and the
camera_info whose name is nearest to theirs.
"""
import contextlib
import os
import pathlib
import queue
import socket
import subprocess
import sys
import time

import rosbag
import rosgraph
import rospy
from objectness_segmentation.msg import SegmentedObjectArray
from sensor_msgs.msg import CameraInfo, PointCloud2

from bag_topics import BagError, choose_topics
from print_objects import HEADER, row

CONNECTION_TIMEOUT_S = 60
FRAME_TIMEOUT_S = 300
END_TIMEOUT_S = 10


def frames(bag, points, camera_info):
    """Yields (cloud, camera_info with the cloud's header): the latest before the cloud, for the first ones the first."""
    camera = next(bag.read_messages(topics=[camera_info])).message
    for topic, message, _ in bag.read_messages(topics=[points, camera_info]):
        if topic == camera_info:
            camera = message
        else:
            camera.header = message.header
            yield message, camera


@contextlib.contextmanager
def running(command, log):
    """Runs a command with its output in a file, and ends it."""
    with open(log, 'wb') as output:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT)
        try:
            yield process
        finally:
            process.terminate()
            try:
                process.wait(END_TIMEOUT_S)
            except subprocess.TimeoutExpired:
                process.kill()


def free_port():
    with socket.socket() as any_socket:
        any_socket.bind(('localhost', 0))
        return any_socket.getsockname()[1]


def wait_for(answer, process, timeout_s, what):
    """Returns answer() as soon as it is something; fails when the process ends or the time is over."""
    name = os.path.basename(process.args[0])
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        value = answer()
        if value:
            return value
        if process.poll() is not None:
            raise BagError(f'{name} ended with exit status {process.returncode} before it {what}')
    raise BagError(f'{name} has not {what} within {timeout_s} s')


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


def master_online():
    time.sleep(0.1)
    return rosgraph.is_master_online()


def segment_frames(pairs, node, process):
    """Sends (cloud, camera_info) pairs and prints what comes back; returns how many."""
    results = queue.Queue()
    subscriber = rospy.Subscriber(f'{node}/objects', SegmentedObjectArray, results.put)
    clouds = rospy.Publisher('points', PointCloud2, queue_size=1)
    cameras = rospy.Publisher('camera_info', CameraInfo, queue_size=1)

    def connected():
        time.sleep(0.1)
        return all(topic.get_num_connections() for topic in (subscriber, clouds, cameras))

    def result():
        with contextlib.suppress(queue.Empty):
            return results.get(timeout=0.5)

    # The node listens only once somebody wants its objects.
    wait_for(connected, process, CONNECTION_TIMEOUT_S, 'subscribed to points and camera_info')
    number = 0
    for number, (cloud, camera) in enumerate(pairs, 1):
        cameras.publish(camera)
        clouds.publish(cloud)
        describe(number, wait_for(result, process, FRAME_TIMEOUT_S, f'answered to frame {number}'))
    return number


def segment_bag(bag, executable, log_dir, points, camera_info):
    points, camera_info = choose_topics(bag, points, camera_info)
    print(f'clouds {points}, camera {camera_info}', flush=True)
    port = free_port()
    os.environ['ROS_MASTER_URI'] = f'http://localhost:{port}'
    node_log = log_dir / 'segment_objects_node.log'
    with running(['roscore', '-p', str(port)], log_dir / 'roscore.log') as master, \
            running([executable, '__name:=segment_objects'], node_log) as process:
        wait_for(master_online, master, CONNECTION_TIMEOUT_S, 'opened its port')
        rospy.init_node('segment_bag', anonymous=True, disable_signals=True)
        try:
            number = segment_frames(frames(bag, points, camera_info), '/segment_objects', process)
        except BagError as error:
            raise BagError(f'{error}; its output: {node_log}') from None
        rospy.signal_shutdown('done')
    print(f'{number} frame(s) done')


def main():
    path, executable, log_dir, *topics = sys.argv[1:]
    points, camera_info = ([topic or None for topic in topics] + [None, None])[:2]
    try:
        with rosbag.Bag(path) as bag:
            segment_bag(bag, executable, pathlib.Path(log_dir), points, camera_info)
    except (OSError, BagError, rosbag.ROSBagException, rospy.ROSException) as error:
        print(f'{path}: {error}', file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == '__main__':
    sys.exit(main())
