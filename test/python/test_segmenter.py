# SPDX-License-Identifier: BSD-3-Clause
import threading

import numpy

from module_test import ModuleTest, without_times
from objectness_segmentation import SegmentationError, Segmenter, segment


class SegmenterTest(ModuleTest):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        frames = cls.make_scene('frames', '--size', '320x240', '--frames', '4', '--still')
        cls.depths = [cls.read_scene(frame)[0] for frame in sorted(frames.glob('frame_*'))]

    def follow(self, segmenter, depths, **options):
        return [segmenter.segment(depth, self.camera_matrix, time_s=0.1 * k, **options)
                for k, depth in enumerate(depths)]

    @staticmethod
    def identities(found):
        return {item['identity']['id']: item for item in found['objects']}

    def test_first_frame_is_that_of_segment(self):
        found = Segmenter().segment(self.depths[0], self.camera_matrix, time_s=7)
        for item in found['objects']:
            self.assertEqual(item.pop('identity')['age_frames'], 1)
        self.assertEqual(without_times(found), without_times(segment(self.depths[0], self.camera_matrix)))

    def test_objects_keep_their_identity(self):
        found = self.follow(Segmenter(), self.depths)
        first, last = self.identities(found[0]), self.identities(found[-1])
        self.assertEqual(len(first), 6)
        self.assertEqual(first.keys(), last.keys())
        for key, item in last.items():
            self.assertLess(numpy.linalg.norm(item['position'] - first[key]['position']), 0.01)
            self.assertEqual(item['identity']['age_frames'], 4)
            self.assertAlmostEqual(item['identity']['age_s'], 0.3)
            self.assertEqual(item['identity']['label'], first[key]['identity']['label'])
            self.assertTrue(0 < item['identity']['confidence'] <= 1)

    def test_depth_is_fused(self):
        alone, fused = ([found['table']['d'] for found in self.follow(Segmenter(frames), self.depths)]
                        for frames in (1, 8))
        self.assertEqual(alone[0], fused[0])
        self.assertNotEqual(alone[-1], fused[-1])
        # One frame a frame is every frame for itself.
        self.assertEqual(alone[-1], segment(self.depths[-1], self.camera_matrix)['table']['d'])

    def test_known_poses_and_threads_change_nothing_in_a_still_scene(self):
        expected = [without_times(found) for found in self.follow(Segmenter(), self.depths)]
        posed = self.follow(Segmenter(runtime={'threads': 5}), self.depths, T_fixed_camera=numpy.eye(4))
        self.assertEqual([without_times(found) for found in posed], expected)

    def test_time_that_goes_back_forgets(self):
        segmenter = Segmenter()
        self.follow(segmenter, self.depths[:2])
        found = segmenter.segment(self.depths[2], self.camera_matrix, time_s=-5)
        self.assertEqual({item['identity']['age_frames'] for item in found['objects']}, {1})

    def test_without_tracking_there_are_no_identities(self):
        found = Segmenter(**{'tracking.enabled': False}).segment(self.depth, self.camera_matrix, time_s=0)
        self.assertEqual(len(found['objects']), 6)
        for item in found['objects']:
            self.assertNotIn('identity', item)

    def test_a_frame_that_fails_is_an_error_and_the_next_goes_on(self):
        segmenter = Segmenter()
        self.follow(segmenter, self.depths[:1])
        with self.assertRaises(SegmentationError) as raised:
            segmenter.segment(numpy.zeros_like(self.depth), self.camera_matrix, time_s=0.1)
        self.assertEqual(raised.exception.status, 'no_valid_points')
        found = segmenter.segment(self.depths[1], self.camera_matrix, time_s=0.2)
        self.assertEqual({item['identity']['age_frames'] for item in found['objects']}, {2})

    def test_threads_may_share_one(self):
        segmenter, ages = Segmenter(), []

        def follow():
            for _ in range(3):
                found = segmenter.segment(self.depths[0], self.camera_matrix, time_s=0)
                ages.append(found['objects'][0]['identity']['age_frames'])

        threads = [threading.Thread(target=follow) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(sorted(ages), list(range(1, 10)))

    def test_arguments_are_checked(self):
        for frames in (0, 101, 1.5, '8', None):
            with self.assertRaisesRegex(ValueError, 'fuse_frames is .*, must be 1 to 100'):
                Segmenter(frames)
        for time_s in (float('nan'), float('inf')):
            with self.assertRaisesRegex(ValueError, 'time_s is .*, must be finite'):
                Segmenter().segment(self.depth, self.camera_matrix, time_s=time_s)
        flipped, moved, infinite = numpy.diag([1, 1, -1, 1]), numpy.eye(4), numpy.eye(4)
        moved[3, 0] = 1
        infinite[0, 3] = numpy.inf
        for pose in (flipped, 2 * numpy.eye(4), moved, infinite, numpy.full((4, 4), numpy.nan)):
            with self.assertRaisesRegex(ValueError, 'T_fixed_camera is no rigid transform'):
                Segmenter().segment(self.depth, self.camera_matrix, time_s=0, T_fixed_camera=pose)
        with self.assertRaisesRegex(ValueError, 'T_fixed_camera is 3 x 4, must be 4 x 4'):
            Segmenter().segment(self.depth, self.camera_matrix, time_s=0, T_fixed_camera=numpy.eye(4)[:3])
