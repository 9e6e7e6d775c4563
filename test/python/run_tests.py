#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests beside it: run_tests.py MODULE_DIR TOOL_DIR RESULTS.xml [PATTERN].

MODULE_DIR is the folder that holds the package objectness_segmentation, TOOL_DIR that of the tools. The cases go to
RESULTS.xml as those of GoogleTest do. Exit status 1 for a failure or for no tests at all.
"""
import os
import pathlib
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree


class Cases(unittest.TextTestResult):
    """Keeps every case as an element <testcase>."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.elements = []
        self.start_s = time.monotonic()

    def startTest(self, test):
        self.start_s = time.monotonic()
        super().startTest(test)

    def add(self, test, kind=None, message=''):
        group, _, name = test.id().rpartition('.')
        seconds = time.monotonic() - self.start_s
        case = ElementTree.Element('testcase', classname=group, name=name, time=f'{seconds:.3f}')
        if kind:
            ElementTree.SubElement(case, kind, message=message)
        self.elements.append(case)

    def addSuccess(self, test):
        super().addSuccess(test)
        self.add(test)

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self.add(test, 'skipped', reason)

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self.add(test, 'failure', str(err[1]))

    def addError(self, test, err):
        super().addError(test, err)
        self.add(test, 'error', repr(err[1]))

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err is not None:
            self.add(test, 'failure', f'{subtest.id()}: {err[1]}')

    def write(self, path):
        def count(kind):
            return str(sum(case.find(kind) is not None for case in self.elements))

        suite = ElementTree.Element('testsuite', name='python', tests=str(len(self.elements)), failures=count('failure'),
                                    errors=count('error'), skipped=count('skipped'))
        suite.extend(self.elements)
        path.parent.mkdir(parents=True, exist_ok=True)
        ElementTree.ElementTree(suite).write(path, encoding='utf-8', xml_declaration=True)


def main():
    module_dir, tool_dir, results = sys.argv[1:4]
    pattern = sys.argv[4] if len(sys.argv) > 4 else 'test_*.py'
    sys.path.insert(0, module_dir)
    os.environ['PYTHONPATH'] = os.pathsep.join(filter(None, [module_dir, os.environ.get('PYTHONPATH')]))  # of scripts
    os.environ['OBJECTNESS_TOOL_DIR'] = tool_dir
    tests = unittest.defaultTestLoader.discover(str(pathlib.Path(__file__).parent), pattern)
    result = unittest.TextTestRunner(verbosity=2, resultclass=Cases).run(tests)
    result.write(pathlib.Path(results))
    return 0 if result.wasSuccessful() and result.elements else 1


if __name__ == '__main__':
    sys.exit(main())
