# SPDX-License-Identifier: BSD-3-Clause
import importlib.util
import inspect
import subprocess
import sys
import textwrap
import unittest

from module_test import REPOSITORY, ModuleTest
import objectness_segmentation


HAS_MESSAGES = importlib.util.find_spec('objectness_segmentation.msg') is not None


class Package(ModuleTest):

    def run_python(self, *arguments):
        done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False,
                              cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    @unittest.skipUnless(HAS_MESSAGES, 'the build is one without ROS')
    def test_messages_are_next_to_the_module(self):
        text = self.run_python('-c', textwrap.dedent('''
            from objectness_segmentation import segment
            from objectness_segmentation.msg import SegmentedObject, SegmentedObjectArray, SegmentedTable, StageTimes
            from objectness_segmentation.srv import SegmentOnce
            from objectness_segmentation.cfg import ObjectnessSegmentationConfig
            print(SegmentedObject.LABEL_FIRST_OBJECT, callable(segment))
            '''))
        self.assertEqual(text, '2 True\n')

    @unittest.skipUnless(HAS_MESSAGES, 'the build is one without ROS')
    def test_whoever_imports_messages_does_not_load_the_library(self):
        text = self.run_python('-c', textwrap.dedent('''
            import sys
            from objectness_segmentation.msg import SegmentedObject
            print('objectness_segmentation._core' in sys.modules, 'opencv' in open('/proc/self/maps').read())
            '''))
        self.assertEqual(text, 'False False\n')

    def test_everything_public_is_documented(self):
        self.assertEqual(objectness_segmentation.__all__, ['SegmentationError', 'Segmenter', 'segment'])
        for name in objectness_segmentation.__all__:
            self.assertIn(name, dir(objectness_segmentation))
            self.assertTrue(inspect.getdoc(getattr(objectness_segmentation, name)))
        self.assertTrue(inspect.getdoc(objectness_segmentation.Segmenter.segment))
        with self.assertRaises(AttributeError):
            objectness_segmentation.nothing  # pylint: disable=pointless-statement

    def test_every_key_of_a_result_is_documented(self):
        text = inspect.getdoc(objectness_segmentation.segment)

        def expect_words(fields):
            for name, value in fields.items():
                self.assertRegex(text, rf'\b{name}\b')
                for item in value if isinstance(value, list) else [value]:
                    if isinstance(item, dict) and name != 'report':
                        expect_words(item)

        expect_words(objectness_segmentation.segment(self.depth, self.camera_matrix))

    def test_example_of_the_readme(self):
        blocks = (REPOSITORY / 'README.md').read_text().split('```python\n')
        self.assertEqual(len(blocks), 2)
        code = blocks[1].split('```')[0]
        self.assertLessEqual(len(code.splitlines()), 10)
        self.make_scene('full').rename(self.folder / 'DIR')
        self.assertEqual(len(self.run_python('-c', code, self.folder / 'DIR').splitlines()), 6)

    def test_script_in_examples(self):
        script = REPOSITORY / 'examples' / 'segment_arrays.py'
        text = self.run_python(script, self.scene)
        self.assertIn('6 objects', text)
        self.assertTrue((self.folder / 'segments.png').stat().st_size > 1000)
