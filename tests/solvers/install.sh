#!/bin/sh
# Installs the programs that tests/solvers runs, from Debian 12: about 2.3 GB in all, most of it
# deal.II. Packages that are not installed make their tests be skipped.
# Never together with libvtk9-dev: python3-paraview (the packages conflict).
set -e
packages="python3-meshio python3-vtk9 freefem++ libfreefem++ python3-dolfinx python3-gmsh
          python3-sfepy python3-getfem getdp calculix-ccx libdeal.ii-dev"
if apt-get install -s --no-install-recommends $packages | grep '^Remv'; then
  echo "the packages above would be removed: nothing was installed" >&2
  exit 1
fi
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages
