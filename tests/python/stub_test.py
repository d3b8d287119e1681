"""The type hints agree with the module; run by ctest with the built package in PYTHONPATH."""
import ast
import importlib.util
import inspect
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cover

STUB = ast.parse((pathlib.Path(cover.__file__).parent / '__init__.pyi').read_text())
CLASSES = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in STUB.body if isinstance(node, ast.FunctionDef)}

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
RING = [(0, 1), (1, 2), (2, 3), (3, 0)]


# Keywords beside those of the table.
MORE = {'sizes', 'sizes_at', 'input_sizes'}
WRITE_OPTIONS = dict(order=2, inner_lines=False, no_inner_lines=True, lines=False, msh='4.1', xdmf='hdf5', ids='region',
                     inp_element='CPS', parts=1)


def keys(name):
    return {item.target.id for item in CLASSES[name].body if isinstance(item, ast.AnnAssign)}


class Stub(unittest.TestCase):
    def test_names(self):
        self.assertEqual(set(cover.__all__), set(FUNCTIONS) | {n for n in CLASSES if not n.startswith('_')})

    def test_arguments(self):
        for name, node in FUNCTIONS.items():
            parameters = inspect.signature(getattr(cover, name)).parameters.values()
            self.assertEqual([p.name for p in parameters if p.kind == p.POSITIONAL_OR_KEYWORD],
                             [a.arg for a in node.args.args], name)
            self.assertEqual([p.name for p in parameters if p.kind == p.KEYWORD_ONLY],
                             [a.arg for a in node.args.kwonlyargs], name)
            defaults = [ast.literal_eval(d) for d in node.args.defaults + node.args.kw_defaults]
            self.assertEqual([p.default for p in parameters if p.default is not p.empty], defaults, name)
            self.assertEqual([p.name for p in parameters if p.kind == p.VAR_KEYWORD], [node.args.kwarg.arg] if node.args.kwarg else [], name)

    def test_members(self):
        hinted = {node.name for node in CLASSES['Mesh'].body}
        self.assertEqual(hinted, {name for name in vars(cover.Mesh) if not name.startswith('_')})
        for node in CLASSES['Mesh'].body:
            self.assertEqual(isinstance(vars(cover.Mesh)[node.name], property), bool(node.decorator_list), node.name)
        for node in CLASSES['Error'].body:
            self.assertTrue(hasattr(cover.Error, node.target.id))

    def test_options(self):
        self.assertEqual(keys('_Options'), MORE | {row['name'].replace('-', '_') for row in cover.options()})
        cover.mesh(SQUARE, RING, sizes={'': 1}, sizes_at={}, input_sizes=False)
        with self.assertRaises(TypeError):
            cover.mesh(SQUARE, RING, order=2)

    def test_options_of_reading(self):
        self.assertEqual(keys('_ReadOptions'), {row['name'].replace('-', '_') for row in cover.read_options()})
        self.assertFalse(keys('_ReadOptions') & keys('_Options'))

    def test_options_of_files(self):
        self.assertEqual(keys('_WriteOptions'), set(WRITE_OPTIONS))
        self.assertEqual(keys('_WriteOptions'), {'inner_lines'} | {row['name'].replace('-', '_') for row in cover.write_options()})
        mesh = cover.mesh(SQUARE, RING)
        with tempfile.TemporaryDirectory() as folder:
            for name, value in WRITE_OPTIONS.items():
                mesh.save(f'{folder}/a.msh', **{name: value})
            with self.assertRaises(TypeError):
                mesh.save(f'{folder}/a.msh', method='almond')

    def test_types(self):
        mesh = cover.mesh(SQUARE, RING)
        for node in CLASSES['Mesh'].body:
            hint = ast.unparse(node.returns)
            if hint.startswith('npt.NDArray'):
                self.assertEqual(f'npt.NDArray[np.{getattr(mesh, node.name).dtype}]', hint, node.name)
            elif node.decorator_list:
                self.assertEqual(type(getattr(mesh, node.name)).__name__, hint.split('[')[0], node.name)

    @unittest.skipUnless(importlib.util.find_spec('mypy'), 'mypy is not installed')
    def test_mypy(self):
        with tempfile.TemporaryDirectory() as folder:
            config = pathlib.Path(folder, 'mypy.ini')
            config.write_text('[mypy]\nenable_incomplete_feature = Unpack\n')  # for mypy before 1.4
            allowed = pathlib.Path(folder, 'allowed')
            allowed.write_text('cover.Mesh\ncover.Mesh.__init__\ncover.Mesh.__new__\n')  # pybind11's metaclass; no constructor
            done = subprocess.run([sys.executable, '-m', 'mypy.stubtest', 'cover', '--mypy-config-file', config,
                                   '--allowlist', allowed], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == '__main__':
    unittest.main()
