#!/usr/bin/env python3
"""schema_test.py READS SCHEMA: input.schema.json and the reader agree. Documents with every construct are read and valid;
whatever the schema refuses among thousands of documents made from them by small changes, the reader refuses too."""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

READS, SCHEMA = sys.argv[1], pathlib.Path(sys.argv[2])

GOOD = [
    {'points': [[0, 0], [1, 0], [1.5, 1e-3]], 'segments': [[0, 1], [1, 2], [2, 0]]},
    {'$schema': 'x', 'name': 'n', 'source': 's', 'license': None, 'notes': ['a'], 'field': {}, 'unit': 'um',
     'points': [[0, 0], [4, 0], [4, 4], [0, 4], [9, 9]],
     'segments': [[0, 1], {'points': [1, 2], 'name': 'gate', 'marker': -7}, [2, 3], {'points': [3, 0], 'name': 5}],
     'holes': [[1, 1]], 'regions': [{'x': 2, 'y': 3, 'material': 'Si', 'region': 'bulk', 'size': 0.5}, {'x': 3, 'y': 3}]},
    {'points': [[1, 0], [-1, 0]], 'chord_error': 0.1,
     'segments': [{'points': [0, 1], 'arc': {'centre': [0, 0]}},
                  {'points': [0, 1], 'arc': {'centre': [0, 0], 'clockwise': True, 'chords': 4}, 'name': 'rim'},
                  {'points': [1, 0], 'arc': {'centre': [0, 0], 'chord_error': 0.01}},
                  {'arc': {'centre': [0, 0], 'radius': 1, 'from': 180, 'to': 360}, 'marker': 3},
                  {'circle': {'centre': [0, 0], 'radius': 3}, 'name': 'hull'},
                  {'circle': {'centre': [0, 0], 'radius': 4, 'chords': 12}},
                  {'circle': {'centre': [0, 0], 'radius': 5, 'chord_error': 0.2}}]},
    {'polygons': [{'material': 'Si', 'rings': [[[0, 0], [4, 0], [4, 4]], [[2, 1], [3, 1], [3, 2]]]},
                  {'material': 4, 'region': 'cap', 'priority': -2.5, 'size': 0.25, 'rings': [[[0, 0], [1, 0], [1, 1]]]},
                  {'material': 'Cu', 'rings': [[{'circle': {'centre': [9, 9], 'radius': 1, 'chords': 8}}]]},
                  {'material': 'Fe', 'rings': [[[0, 0], {'arc': {'centre': [0, 0], 'radius': 2, 'from': 90, 'to': 0,
                                                                 'chord_error': 0.1}}], []]}],
     'lines': [{'name': 'drain', 'points': [[0, 0], [1, 0]]}, {'points': [[0, 0], [1, 0], [1, 1]], 'closed': True},
               {'points': [{'arc': {'centre': [0, 0], 'radius': 2, 'from': 0, 'to': 90, 'chords': 3}}], 'closed': False}],
     'regions': [{'x': 9, 'y': 9, 'size': 1}], 'holes': []},
    {'lines': [{'points': [[0, 0], [1, 0], [1, 1]], 'closed': True}]},
    {'points': [[0, 0], [1, 0], [1, 1], [0, 1]],
     'segments': [[0, 1], {'points': [1, 2], 'name': 'a'}, [2, 3], {'points': [3, 0], 'name': 2}],
     'periodic': [['a', 2], {'from': 'a', 'to': 'b', 'mirror': True}, {'from': 3, 'to': 'c', 'mirror': False},
                  {'from': 'd', 'to': 'e', 'rotation': {'centre': [0, 1], 'angle': -45.5}}]},
    {'segments': [{'circle': {'centre': [0, 0], 'radius': 3, 'chords': 8}}]},
    {'points': [[0, 0], [1, 0], [1, 1], [0, 1]],
     'segments': [{'points': [0, 1], 'name': 'a', 'layers': {'first': 0.01, 'growth': 1.5}}, [1, 2], [2, 3], [3, 0]],
     'layers': [{'line': 'a', 'first': 0.1, 'growth': 1, 'count': 2}, {'line': 'b', 'region': 'c', 'first': 2, 'growth': 1.25}]},
]

VALUES = [None, True, False, 0, 1, -1, 2.5, -0.5, 1e300, 10**12, 10**30, '', 'um', 'x', [], {}, [1], [0, 0], [0, 1, 2],
          {'x': 1}, {'circle': {'centre': [0, 0], 'radius': 1, 'chords': 5}}]
KEYS = {'circle': {'centre': [0, 0], 'radius': 1, 'chords': 5}, 'chords': 5, 'chord_error': 0.1, 'name': 'a', 'points': [0, 1],
        'arc': {'centre': [0, 0], 'radius': 1, 'from': 0, 'to': 90, 'chords': 3}, 'unknown': 1, 'clockwise': True, 'mirror': True}


def places(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in items:
        yield from places(child, path + (key,))


def changed(document):
    """Copies of a document with one value replaced, left out, doubled, or a key added."""
    for path in places(document):
        def made(change, path=path):
            result = {'': copy.deepcopy(document)}
            holder, key = result, ''
            for step in path:
                holder, key = holder[key], step
            change(holder, key)
            return result['']
        for value in VALUES:
            yield made(lambda holder, key, value=value: holder.__setitem__(key, copy.deepcopy(value)))
        if path:
            yield made(lambda holder, key: holder.pop(key))
        value = document
        for step in path:
            value = value[step]
        if isinstance(value, list) and value:
            yield made(lambda holder, key: holder[key].append(copy.deepcopy(holder[key][0])))
        if isinstance(value, dict):
            for name, added in KEYS.items():
                yield made(lambda holder, key, name=name, added=added: holder[key].setdefault(name, copy.deepcopy(added)))


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        schema = json.loads(SCHEMA.read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        cls.validator = jsonschema.Draft202012Validator(schema)

    def read(self, documents):
        """What the reader says of each document; nothing where it takes it."""
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for k, document in enumerate(documents):
                paths.append(f'{folder}/{k}.json')
                pathlib.Path(paths[-1]).write_text(json.dumps(document))
            done = subprocess.run([READS], input='\n'.join(paths) + '\n', text=True, check=True, stdout=subprocess.PIPE)
        answers = done.stdout.split('\n')[:-1]
        self.assertEqual(len(answers), len(documents))
        return answers

    def test_every_construct_is_read_and_valid(self):
        for document, answer in zip(GOOD, self.read(GOOD)):
            self.assertEqual(answer, '')
            self.validator.validate(document)

    def test_samples_are_valid(self):
        samples = list((SCHEMA.parents[2] / 'samples/data').glob('*.json'))
        self.assertGreater(len(samples), 0)
        for sample in samples:
            self.validator.validate(json.loads(sample.read_text()))

    def test_every_key_of_the_schema_is_tried(self):
        used = {step for document in GOOD for path in places(document) for step in path if isinstance(step, str)}
        known = set()
        for path in places(json.loads(SCHEMA.read_text())):
            if len(path) > 1 and path[-2] == 'properties':
                known.add(path[-1])
        self.assertEqual(known - used, set())

    def test_what_the_schema_refuses_the_reader_refuses(self):
        documents = [c for document in GOOD for c in changed(document)]
        refused = 0
        for document, answer in zip(documents, self.read(documents)):
            valid = self.validator.is_valid(document)
            refused += not valid
            if answer == '':
                self.assertTrue(valid, f'{document}\n{next(self.validator.iter_errors(document), None)}')
        self.assertGreater(refused, 1000)
        self.assertGreater(len(documents) - refused, 1000)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0]], verbosity=1)
