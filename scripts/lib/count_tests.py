#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts test cases, each once: count_tests.py RESULTS_DIR CTEST_LOG. Exit status 1 for a failure or for no tests at all.

gtest and rostest leave an XML file of cases, and a rostest a second file that repeats them; a test that is a plain command
leaves only its line in ctest's output, as does one that died before it could write.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

PASSED, SKIPPED, FAILED = range(3)
CTEST_LINE = re.compile(r'^\s*\d+/\d+ Test\s+#\d+: (\S+) \.*\s*(\**[A-Za-z ]+)')


def outcome(case):
    """Returns (what became of a <testcase>, its message)."""
    for failure in case.iter():
        if failure.tag in ('failure', 'error'):
            return FAILED, failure.get('message') or (failure.text or '').strip()
    skipped = case.find('skipped')
    if skipped is not None or case.get('result') in ('skipped', 'suppressed') or case.get('status') == 'notrun':
        return SKIPPED, '' if skipped is None else skipped.get('message') or (skipped.text or '').strip()
    return PASSED, ''


def cases_of_files(results_dir):
    """Returns {(class, name): (outcome, message)}; of a case that is told twice the worse."""
    cases = {}
    for path in sorted(results_dir.rglob('*.xml')):
        try:
            root = ElementTree.parse(path).getroot()
        except ElementTree.ParseError as error:
            cases[path.stem, 'result file'] = FAILED, f'{path} cannot be read: {error}'
            continue
        for case in root.iter('testcase'):
            key = case.get('classname', '').split('.')[-1], case.get('name', '')
            cases[key] = max(cases.get(key, (PASSED, '')), outcome(case))
    return cases


def cases_of_ctest(log, failures_in_files):
    """Returns the plain commands as cases, and one failure for tests that failed without any failed case in a file."""
    cases = {}
    for name, result in (match.groups() for match in map(CTEST_LINE.match, log.splitlines()) if match):
        result = result.strip('* ').lower()
        if result.startswith('passed'):
            if not name.startswith('_ctest_'):
                cases['ctest', name] = PASSED, ''
        elif result.startswith('skipped'):
            cases['ctest', name] = SKIPPED, ''
        elif not name.startswith('_ctest_') or not failures_in_files:
            cases['ctest', name] = FAILED, result
    return cases


def main():
    results_dir, log = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).read_text(errors='replace')
    cases = cases_of_files(results_dir)
    cases.update(cases_of_ctest(log, any(result == FAILED for result, _ in cases.values())))

    for title, wanted in (('skipped', SKIPPED), ('failed', FAILED)):
        for (group, name), (result, message) in sorted(cases.items()):
            if result == wanted:
                print(f'{title}: {group}.{name}' + (f': {message.splitlines()[0]}' if message else ''))
    results = [result for result, _ in cases.values()]
    print(f'{results.count(PASSED)} passed, {results.count(FAILED)} failed, {results.count(SKIPPED)} skipped')
    return 1 if FAILED in results or not results else 0


if __name__ == '__main__':
    sys.exit(main())
