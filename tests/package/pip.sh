# pip.sh PYTHON PACKAGE BUILD SCRIPT INPUT: the module installs into a virtual environment and works there. Skipped with 77
# where Python has no venv, pip or setuptools.
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" -c 'import venv, ensurepip, setuptools, wheel' || exit 77
"$1" -m venv --system-site-packages "$folder/env"
cp -r "$2" "$folder/python"                       # pip leaves a build folder where it builds
COVER_BUILD_DIR=$3 COVER_SOURCE_DIR=$2/../.. "$folder/env/bin/pip" install -q --no-build-isolation --no-index --no-deps "$folder/python"
cd "$folder"
"$folder/env/bin/python" "$4" "$folder/env" "$5"
