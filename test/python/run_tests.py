#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests beside it: run_tests.py RESULTS.xml MODULE_DIR TOOL_DIR [PATTERN].

MODULE_DIR is the folder that holds the package objectness_segmentation, TOOL_DIR that of the tools. The cases go to
RESULTS.xml as those of GoogleTest do. Exit status 1 for a failure or for no tests at all. Without MODULE_DIR nothing
was built that could be tested: that is one case, skipped.
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
        self.elements.append(element(test.id(), time.monotonic() - self.start_s, kind, message))

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


def element(full_name, seconds, kind, message):
    group, _, name = full_name.rpartition('.')
    case = ElementTree.Element('testcase', classname=group, name=name, time=f'{seconds:.3f}')
    if kind:
        ElementTree.SubElement(case, kind, message=message)
    return case


def write_results(path, cases):
    def count(kind):
        return str(sum(case.find(kind) is not None for case in cases))

    suite = ElementTree.Element('testsuite', name='python', tests=str(len(cases)), failures=count('failure'),
                                errors=count('error'), skipped=count('skipped'))
    suite.extend(cases)
    path.parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(path, encoding='utf-8', xml_declaration=True)


def main():
    results = pathlib.Path(sys.argv[1])
    if len(sys.argv) == 2:
        reason = 'not built: pybind11 was not found, or WITH_PYTHON is off'
        print(f'Python module: {reason}')
        write_results(results, [element('Python.module', 0, 'skipped', reason)])
        return 0
    module_dir, tool_dir, pattern = (sys.argv[2:] + ['test_*.py'])[:3]
    sys.path.insert(0, module_dir)
    os.environ['PYTHONPATH'] = os.pathsep.join(filter(None, [module_dir, os.environ.get('PYTHONPATH')]))  # of scripts
    os.environ['OBJECTNESS_TOOL_DIR'] = tool_dir
    tests = unittest.defaultTestLoader.discover(str(pathlib.Path(__file__).parent), pattern)
    result = unittest.TextTestRunner(verbosity=2, resultclass=Cases).run(tests)
    write_results(results, result.elements)
    return 0 if result.wasSuccessful() and result.elements else 1


if __name__ == '__main__':
    sys.exit(main())
