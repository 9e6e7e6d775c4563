# SPDX-License-Identifier: BSD-3-Clause
import threading
import time

import numpy
import yaml

from module_test import REPOSITORY, ModuleTest, without_times
from objectness_segmentation import segment


class Segment(ModuleTest):

    def expect_same(self, one, other):
        self.assertEqual(without_times(one), without_times(other))

    def test_finds_what_the_tool_finds(self):
        found = segment(self.depth, self.camera_matrix, self.color)
        self.assertEqual(len(found['objects']), 6)
        self.expect_same(found, self.segment_by_tool())

    def test_finds_what_the_tool_finds_with_a_preset(self):
        preset = REPOSITORY / 'cfg' / 'strict.yaml'
        found = segment(self.depth, self.camera_matrix, self.color, **yaml.safe_load(preset.read_text()))
        self.assertIn('boxes_sampled', found['report'])
        self.expect_same(found, self.segment_by_tool('--config', preset))

    def test_parameters_by_full_name_and_by_group_are_the_same(self):
        by_name = segment(self.depth, self.camera_matrix, **{'input.max_depth_m': 0.95, 'segments.min_pixels': 900})
        by_group = segment(self.depth, self.camera_matrix, input={'max_depth_m': 0.95}, segments={'min_pixels': 900})
        self.expect_same(by_name, by_group)
        self.expect_same(by_name, self.segment_by_tool('--set', 'input.max_depth_m=0.95', 'segments.min_pixels=900'))
        self.assertLess(len(by_name['objects']), 6)

    def test_numbers_of_numpy_are_parameters(self):
        parameters = {'input.max_depth_m': numpy.float64(0.95), 'segments.min_pixels': numpy.int32(900),
                      'grouping.learned': numpy.True_}
        self.expect_same(segment(self.depth, self.camera_matrix, **parameters),
                         self.segment_by_tool('--set', 'input.max_depth_m=0.95', 'segments.min_pixels=900'))

    def test_names_of_earlier_versions_count_with_a_warning(self):
        with self.assertWarnsRegex(FutureWarning, 'grouping.enabled is replaced by pipeline.method: paper'):
            former = segment(self.depth, self.camera_matrix, grouping={'enabled': False})
        self.expect_same(former, segment(self.depth, self.camera_matrix, pipeline={'method': 'paper'}))

    def test_result_does_not_depend_on_threads(self):
        for method in ('objectness', 'paper'):
            results = [without_times(segment(self.depth, self.camera_matrix, runtime={'threads': threads},
                                             pipeline={'method': method})) for threads in (1, 2, 5)]
            self.assertEqual(results[0], results[1])
            self.assertEqual(results[0], results[2])

    def test_colour_changes_nothing(self):
        self.expect_same(segment(self.depth, self.camera_matrix), segment(self.depth, self.camera_matrix, self.color))

    def test_float_metres_are_the_same_as_millimetres(self):
        metres = self.depth * numpy.float32(0.001)
        expected = segment(self.depth, self.camera_matrix)
        self.expect_same(segment(metres, self.camera_matrix), expected)
        self.expect_same(segment(metres.astype(numpy.float64), self.camera_matrix), expected)
        for missing in (numpy.nan, numpy.inf, -1):
            self.expect_same(segment(numpy.where(self.depth == 0, missing, metres), self.camera_matrix), expected)

    def test_unit_of_integers_is_a_parameter(self):
        tenths = self.depth * numpy.uint16(10)
        self.assertLess(self.depth.max(), 6553)
        found = segment(tenths, self.camera_matrix, **{'input.depth_unit_m': 0.0001})
        self.assertEqual(len(found['objects']), 6)

    def test_memory_layout_of_arrays_does_not_matter(self):
        expected = segment(self.depth, self.camera_matrix, self.color)
        every_other = numpy.zeros((480, 640), numpy.uint16)
        every_other[::2, 1::2] = self.depth
        depths = {
            'Fortran': numpy.asfortranarray(self.depth),
            'every other pixel': every_other[::2, 1::2],
            'backwards': self.depth[::-1, ::-1].copy()[::-1, ::-1],
            'big-endian': self.depth.astype('>u2'),
        }
        bgr = self.color[..., ::-1].copy()
        for name, depth in depths.items():
            with self.subTest(name):
                self.expect_same(segment(depth, numpy.asfortranarray(self.camera_matrix), bgr[..., ::-1]), expected)
        self.expect_same(segment(self.depth, self.camera_matrix.tolist(), self.color), expected)

    def test_input_is_left_as_it_is(self):
        depth, color = self.depth.copy(), self.color.copy()
        metres = self.depth * numpy.float32(0.001)
        before = metres.copy()
        for array in (depth, color, metres):
            array.flags.writeable = False
        segment(depth, self.camera_matrix, color)
        segment(metres, self.camera_matrix, color)
        self.assertTrue((depth == self.depth).all() and (color == self.color).all() and (metres == before).all())

    def test_arrays_have_the_types_and_shapes_that_are_documented(self):
        found = segment(self.depth, self.camera_matrix)
        labels, table = found['labels'], found['table']
        self.assertEqual((labels.dtype, labels.shape), (numpy.uint16, self.depth.shape))
        self.assertTrue(labels.flags.owndata and labels.flags.writeable)
        corners = len(table['hull'])
        self.assertEqual((table['hull'].shape, table['hull_measured'].shape), ((corners, 2), (corners,)))
        self.assertEqual(table['hull_measured'].dtype, bool)
        self.assertEqual((table['normal'].shape, table['frame']['orientation'].shape), ((3,), (4,)))
        for item in found['objects']:
            for box in (item, item['visible_box']):
                shapes = [box[name].shape for name in ('position', 'orientation', 'size')]
                self.assertEqual(shapes, [(3,), (4,), (3,)])
            self.assertEqual((labels == item['label']).sum(), item['points'])
            self.assertIs(type(item['supports']), list)
        for name in ('normals', 'total'):
            self.assertGreater(found['report']['timings_ms'][name], 0)

    def test_labels_outlive_the_result(self):
        labels = segment(self.depth, self.camera_matrix)['labels']
        copy = labels.copy()
        for _ in range(3):
            segment(self.depth, self.camera_matrix)
        self.assertTrue((labels == copy).all())

    def test_nothing_on_the_table_is_a_result(self):
        found = segment(self.depth, self.camera_matrix, segments={'min_pixels': 100000})
        self.assertEqual(found['objects'], [])
        self.assertLessEqual(found['labels'].max(), 1)

    def test_other_threads_run_while_it_computes(self):
        stamps, done = [], threading.Event()

        def tick():
            while not done.wait(0.001):
                stamps.append(time.monotonic())

        depth, _, camera_matrix = self.read_scene(self.make_scene('large'))
        ticker = threading.Thread(target=tick)
        ticker.start()
        try:
            start = time.monotonic()
            found = segment(depth, camera_matrix, **{'pipeline.method': 'paper', 'runtime.threads': 1})
            end = time.monotonic()
        finally:
            done.set()
            ticker.join()
        within = [start, *(stamp for stamp in stamps if start < stamp < end), end]
        longest_silence_ms = 1000 * max(after - before for before, after in zip(within, within[1:]))
        # Otherwise there is not one tick in all that time.
        self.assertLess(longest_silence_ms, found['report']['timings_ms']['total'])

    def test_threads_may_segment_at_the_same_time(self):
        expected = without_times(segment(self.depth, self.camera_matrix))
        results = []
        threads = [threading.Thread(target=lambda: results.append(segment(self.depth, self.camera_matrix)))
                   for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([without_times(result) for result in results], [expected] * 4)
