# SPDX-License-Identifier: BSD-3-Clause
import pickle

import numpy
import PIL.Image
import yaml

from module_test import ModuleTest
from objectness_segmentation import SegmentationError, Segmenter, segment


class Parameters(ModuleTest):

    WRONG = [
        {'search': {'angle_step': 10}},
        {'objectness': {'wieght_edges': 1}},
        {'runtime': {'threads': 65}},
        {'runtime': {'threads': 1.5}},
        {'runtime': {'threads': 'many'}},
        {'runtime': {'threads': True}},
        {'grouping': {'enabled': 1}},
        {'input': {'min_depth_m': float('nan')}},
        {'input': {'min_depth_m': float('inf')}},
        {'input': {'min_depth_m': '0.5 m'}},
        {'input': {'min_depth_m': 3, 'max_depth_m': 2}},
        {'search': {'corner_step_m': 0.015}},
        {'segments': {'min_pixels': 0}, 'runtime': {'seed': -1}},
    ]

    def error_of(self, call, *arguments, **parameters):
        with self.assertRaises(SegmentationError) as raised:
            call(*arguments, **parameters)
        return raised.exception

    def test_errors_are_the_sentences_of_presets_and_of_the_command_line(self):
        preset = self.folder / 'preset.yaml'
        for parameters in self.WRONG:
            with self.subTest(parameters):
                error = self.error_of(segment, self.depth, self.camera_matrix, **parameters)
                self.assertEqual(error.status, 'bad_config')
                preset.write_text(yaml.dump(parameters))
                said = self.run_tool('segment', '--config', preset, '--out', self.folder, self.scene, ok=False)
                self.assertEqual(said, f'segment: --config {preset}: {error} (segment --help)\n')

    def test_full_names_say_the_same(self):
        for parameters in self.WRONG:
            with self.subTest(parameters):
                flat = {f'{group}.{name}': value for group, fields in parameters.items()
                        for name, value in fields.items()}
                by_group = self.error_of(segment, self.depth, self.camera_matrix, **parameters)
                by_name = self.error_of(segment, self.depth, self.camera_matrix, **flat)
                self.assertEqual(str(by_name), str(by_group))
                self.assertEqual(str(self.error_of(Segmenter, **flat)), str(by_group))

    def test_a_name_without_its_group_is_found(self):
        error = self.error_of(segment, self.depth, self.camera_matrix, threads=2)
        self.assertEqual(str(error), 'there is no parameter threads (did you mean runtime.threads?)')

    def test_what_is_no_single_value_is_named(self):
        for value in ([1, 2], None, {'a': 1}):
            error = self.error_of(segment, self.depth, self.camera_matrix, runtime={'threads': value})
            self.assertEqual(str(error), f"runtime.threads is '{value}', must be a whole number")

    def test_errors_can_be_pickled(self):
        error = self.error_of(segment, self.depth, self.camera_matrix, threads=2)
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.status), (str(error), error.status))


class Frames(ModuleTest):

    def expect_error(self, kind, sentence, *arguments, **parameters):
        with self.assertRaises(kind) as raised:
            segment(*arguments, **parameters)
        self.assertIn(sentence, str(raised.exception))
        return raised.exception

    def test_what_cannot_be_segmented_is_told_as_by_the_tool(self):
        wall = numpy.full_like(self.depth, 1000)  # square to the camera
        for name, depth, status, parameters in (
                ('nothing', numpy.zeros_like(self.depth), 'no_valid_points', {}),
                ('wall', wall, 'no_table', {'table': {'up_known': True, 'max_tilt_deg': 20}}),
                ('torn', numpy.where(numpy.indices(self.depth.shape).sum(0) % 8 == 0, self.depth, 0), 'bad_input', {}),
                ('far', self.depth, 'no_valid_points', {'input': {'min_depth_m': 4}})):
            with self.subTest(name):
                scene = self.folder / name
                scene.mkdir()
                PIL.Image.fromarray(depth.astype(numpy.uint16)).save(scene / 'depth.png')
                (scene / 'camera.yaml').write_text((self.scene / 'camera.yaml').read_text())
                settings = [f'{group}.{field}={str(value).lower()}' for group, fields in parameters.items()
                            for field, value in fields.items()]
                said = self.run_tool('segment', *(f'--set={setting}' for setting in settings), '--out',
                                     self.folder / 'out', scene, ok=False)
                error = self.expect_error(SegmentationError, '', depth.astype(numpy.uint16), self.camera_matrix,
                                          **parameters)
                self.assertIn(f'segment: {scene}: {error}\n', said)
                self.assertEqual(error.status, status)

    def test_types_of_depth(self):
        for dtype in (numpy.uint8, numpy.int16, numpy.int32, numpy.int64, numpy.uint32, bool, complex, object):
            with self.subTest(dtype):
                self.expect_error(TypeError, f'depth is of {numpy.dtype(dtype)}, must be of float (metres) or uint16',
                                  self.depth.astype(dtype), self.camera_matrix)
        self.expect_error(TypeError, 'depth is of object', None, self.camera_matrix)
        self.expect_error(TypeError, 'depth is of <U4', 'file', self.camera_matrix)

    def test_shapes_of_depth(self):
        for shape, text in (((76800,), '76800'), ((240, 320, 1), '240 x 320 x 1'), ((1, 240, 320), '1 x 240 x 320')):
            self.expect_error(ValueError, f'depth is {text}, must be H x W', self.depth.reshape(shape),
                              self.camera_matrix)
        self.expect_error(ValueError, 'depth is a single value, must be H x W', 1.0, self.camera_matrix)
        for shape in ((0, 0), (0, 320), (240, 0)):
            error = self.expect_error(SegmentationError, 'depth image is empty', numpy.zeros(shape, numpy.float32),
                                      self.camera_matrix)
            self.assertEqual(error.status, 'bad_input')

    def test_color(self):
        self.expect_error(TypeError, 'color is of float64, must be of uint8', self.depth, self.camera_matrix,
                          self.color / 255)
        self.expect_error(ValueError, 'color is 240 x 320, must be H x W x 3 (RGB)', self.depth, self.camera_matrix,
                          self.color[..., 0])
        self.expect_error(ValueError, 'color is 240 x 320 x 4, must be', self.depth, self.camera_matrix,
                          numpy.zeros((240, 320, 4), numpy.uint8))
        self.expect_error(ValueError, 'it has no pixels', self.depth, self.camera_matrix, self.color[:0])
        error = self.expect_error(SegmentationError, 'colour image is 320 x 239 but the depth image is 320 x 240',
                                  self.depth, self.camera_matrix, self.color[1:])
        self.assertEqual(error.status, 'size_mismatch')

    def test_camera_matrix(self):
        k = self.camera_matrix
        for wrong in (k.T, k * 2, numpy.eye(3) + numpy.eye(3)[::-1], numpy.where(k == 1, numpy.nan, k)):
            self.expect_error(ValueError, 'must be [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]', self.depth, wrong)
        self.expect_error(ValueError, 'camera_matrix is 3 x 4, must be 3 x 3', self.depth, numpy.ones((3, 4)))
        self.expect_error(ValueError, 'camera_matrix is 9, must be 3 x 3', self.depth, k.ravel())
        self.expect_error(TypeError, 'camera_matrix is of object, must be of float', self.depth, None)
        for row, column, value in ((0, 0, 0), (1, 1, -500), (0, 2, numpy.nan), (1, 1, numpy.inf)):
            wrong = k.copy()
            wrong[row, column] = value
            error = self.expect_error(SegmentationError, '', self.depth, wrong)
            self.assertEqual(error.status, 'bad_camera')
