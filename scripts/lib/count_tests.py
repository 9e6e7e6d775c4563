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
    """Returns {(file, class, name): (outcome, message)}."""
    cases = {}
    for path in sorted(results_dir.rglob('*.xml')):
        try:
            root = ElementTree.parse(path).getroot()
        except ElementTree.ParseError as error:
            cases[path.stem, 'file', path.name] = FAILED, f'cannot be read: {error}'
            continue
        for case in root.iter('testcase'):
            result = outcome(case)
            # The cases of a rostest are in its rosunit file; its own file adds only what kept them from being run.
            if result[0] == FAILED or not path.stem.startswith('rostest-'):
                cases[path.stem, case.get('classname', ''), case.get('name', '')] = result
    return cases


def cases_of_ctest(log, failed_files):
    """Returns as cases the plain commands, and the tests that failed although no case of theirs did (a crash at the end)."""
    cases = {}
    for name, result in (match.groups() for match in map(CTEST_LINE.match, log.splitlines()) if match):
        result = result.strip('* ').lower()
        key = 'ctest', 'ctest', name
        if name.startswith('_ctest_'):
            if '_gtest_' in name:
                told = 'gtest-' + name.split('_gtest_', 1)[1] in failed_files
            else:
                told = any(not stem.startswith('gtest-') for stem in failed_files)
            if not result.startswith(('passed', 'skipped')) and not told:
                cases[key] = FAILED, result
        else:
            cases[key] = {'passed': PASSED, 'skipped': SKIPPED}.get(result.split()[0], FAILED), result
    return cases


def first_line(message):
    """The first line that says something: gtest puts the place in the source before it."""
    lines = [line.strip() for line in message.splitlines() if line.strip()]
    return next((line for line in lines if not re.fullmatch(r'\S+:\d+', line)), '')


def main():
    results_dir, log = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).read_text(errors='replace')
    cases = cases_of_files(results_dir)
    cases.update(cases_of_ctest(log, {stem for (stem, _, _), (result, _) in cases.items() if result == FAILED}))

    for title, wanted in (('skipped', SKIPPED), ('failed', FAILED)):
        for (_, group, name), (result, message) in sorted(cases.items()):
            if result == wanted:
                print(f'{title}: {group}.{name}: {first_line(message)}'.rstrip(': '))
    results = [result for result, _ in cases.values()]
    print(f'{results.count(PASSED)} passed, {results.count(FAILED)} failed, {results.count(SKIPPED)} skipped')
    return 1 if FAILED in results or not results else 0


if __name__ == '__main__':
    sys.exit(main())
