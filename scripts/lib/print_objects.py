#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the found objects as a short table: print_objects.py OBJECTS_JSON... (as the tool `segment` writes them)."""
import json
import sys

HEADER = 'label  centre x, y, z in m (camera)  size in m              objectness  pixels'


def row(label, position, size, objectness, pixels):
    centre = '  '.join(f'{value:7.3f}' for value in position)
    extent = ' x '.join(f'{value:5.3f}' for value in size)
    return f'{label:5d}  {centre:>28}   {extent:21}  {objectness:10.3f}  {pixels:6d}'


def main():
    for path in sys.argv[1:]:
        with open(path, encoding='utf-8') as file:
            found = json.load(file)
        objects = found['objects']
        total_ms = found.get('report', {}).get('timings_ms', {}).get('total')
        print(f'{len(objects)} object(s) on the table' + (f', found in {total_ms:.0f} ms' if total_ms is not None else ''))
        if objects:
            print(HEADER)
        for item in objects:
            print(row(item['label'], item['position'], item['size'], item['objectness'], item['points']))


if __name__ == '__main__':
    main()
