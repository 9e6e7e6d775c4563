#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what the node finds while a bag is played to it: watch_objects.py FIRST_TIMEOUT_S IDLE_S.

A line for each frame, and a table of the last one's objects. Ends when no frame came for IDLE_S (the bag is over), or
one came with an earlier stamp (it begins anew). Exit status 1 when there was none at all within FIRST_TIMEOUT_S.
"""
import queue
import sys
import time

import rosgraph
import rospy
from objectness_segmentation.msg import SegmentedObjectArray

from print_objects import HEADER, row


def print_frame(result):
    found = f'{len(result.objects)} object(s), {1000 * result.processing_time:.0f} ms' \
        if result.status == result.OK else result.message
    print(f'frame of {result.header.stamp.to_sec():.3f} s: {found}, {result.dropped_frames} older frame(s) dropped',
          flush=True)


def print_table(result):
    print(HEADER)
    for item in result.objects:
        centre, size = item.pose.position, item.dimensions
        print(row(item.label, (centre.x, centre.y, centre.z), (size.x, size.y, size.z), item.objectness,
                  len(item.indices.indices)))
    sys.stdout.flush()


def main():
    first_timeout, idle = map(float, sys.argv[1:])
    end = time.monotonic() + first_timeout
    while not rosgraph.is_master_online():
        if time.monotonic() > end:
            return 1
        time.sleep(0.2)
    rospy.init_node('watch_objects', anonymous=True, disable_signals=True)
    results = queue.Queue()
    subscriber = rospy.Subscriber('/segment_objects/objects', SegmentedObjectArray, results.put)
    last = None
    try:
        while True:
            result = results.get(timeout=idle if last else first_timeout)
            if last and result.header.stamp <= last.header.stamp:
                break
            print_frame(result)
            last = result
    except queue.Empty:
        pass
    except KeyboardInterrupt:
        return 130
    subscriber.unregister()
    if last and last.objects:
        print_table(last)
    return 0 if last else 1


if __name__ == '__main__':
    sys.exit(main())
