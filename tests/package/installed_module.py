"""installed_module.py PREFIX INPUT: the module that was installed below PREFIX is found and works, hints included."""
import pathlib
import sys

import cover

package = pathlib.Path(cover.__file__).resolve().parent
assert pathlib.Path(sys.argv[1]).resolve() in package.parents, package
assert {'__init__.pyi', 'py.typed'} <= {path.name for path in package.iterdir()}, list(package.iterdir())
mesh = cover.mesh_file(sys.argv[2])
assert mesh.violations() == []
print(mesh)
