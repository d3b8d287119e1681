#!/usr/bin/env bash
# Installs what is missing, builds cover, meshes a sample device and draws it; the files go to out/.
set -euo pipefail
cd "$(dirname "$0")/.."
bash cmake/install_dependencies.sh
# A first build compiles whole folders at once; a build folder that is there stays as it was set up.
[ -f build/release/CMakeCache.txt ] || whole=-DCOVER_UNITY_BUILD=ON
cmake --preset release ${whole:-}
cmake --build --preset release --target cover_cli
cover=build/release/apps/cover/cover
mkdir -p out
"$cover" mesh samples/data/mosfet.poly -o out/mosfet.vtu -o out/mosfet.png -o out/mosfet.vtm \
  --method quality --report out/mosfet.html
"$cover" check samples/data/mosfet.poly out/mosfet.vtu
"$cover" render out/mosfet.vtu -o out/mosfet_gate.png --window=-60,-25,60,25 --color max_angle -q
cat <<END

The mesh is in            $PWD/out/mosfet.vtu   (open it with ParaView)
its picture in            $PWD/out/mosfet.png
the gate, by angles, in   $PWD/out/mosfet_gate.png
what was reached in       $PWD/out/mosfet.html  (open it with a browser)
END
