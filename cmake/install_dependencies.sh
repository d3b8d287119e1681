#!/usr/bin/env bash
# Installs the Debian packages that cover builds and tests with; does nothing when all are there.
set -euo pipefail
packages=(git g++ cmake ninja-build ccache
          libcgal-dev libopenmesh-dev libvtk9-dev libboost-dev
          libdxflib-dev libgdal-dev
          libcli11-dev libfmt-dev libspdlog-dev nlohmann-json3-dev libtomlplusplus-dev
          libexpat1-dev zlib1g-dev liblzma-dev liblz4-dev libhdf5-dev
          libgtest-dev libbenchmark-dev clang-format clang-tidy dpkg-dev file
          libopenmpi-dev openmpi-bin
          pkg-config pybind11-dev python3-dev
          python3 python3-jsonschema python3-numpy python3-vtk9)
missing=()
for p in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'install ok installed' || missing+=("$p")
done
[ ${#missing[@]} -eq 0 ] && exit 0
sudo=""
[ "$(id -u)" -eq 0 ] || sudo=sudo
echo "Installing: ${missing[*]}"
$sudo apt-get update -qq
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
