"""Builds the compiled part with CMake. COVER_BUILD_DIR: a build tree to be used, else one in build/; COVER_CMAKE_ARGS:
further arguments for a new one; COVER_SOURCE_DIR: cover's own folder, where this one is a copy."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
ROOT = pathlib.Path(os.environ.get('COVER_SOURCE_DIR', HERE.parent.parent)).resolve()


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        build = pathlib.Path(os.environ.get('COVER_BUILD_DIR', pathlib.Path(self.build_temp, 'cmake'))).resolve()
        if not (build / 'CMakeCache.txt').exists():
            subprocess.check_call(['cmake', '-S', ROOT, '-B', build, '-DCMAKE_BUILD_TYPE=Release', '-DCOVER_BUILD_PYTHON=ON',
                                   '-DCOVER_BUILD_TESTS=OFF', '-DCOVER_BUILD_SAMPLES=OFF',
                                   f'-DPython3_EXECUTABLE={sys.executable}',
                                   *shlex.split(os.environ.get('COVER_CMAKE_ARGS', ''))])
        subprocess.check_call(['cmake', '--build', build, '--target', 'cover_python', 'cover_python_png',
                               '--parallel', str(os.cpu_count() or 1)])
        built, = (build / 'apps/python/cover').glob('_cover*.so')
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, target)
        # Beside it, loaded for pictures only.
        picture, = (build / 'apps/python/cover').glob('_png*.so')
        shutil.copy(picture, target.parent / picture.name)


version = re.search(r'project\(cover VERSION ([\d.]+)', (ROOT / 'CMakeLists.txt').read_text()).group(1)
setup(version=version, ext_modules=[Extension('cover._cover', [])], cmdclass={'build_ext': CMakeBuild})
