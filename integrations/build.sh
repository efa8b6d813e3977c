#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: [CSCD_PROGRAM=FILE] build.sh [OUT]
# Installs missing packages (Debian, Ubuntu), packs the add-ons for Blender and ParaView and the script for Slicer and
# Neuroglancer into the folder OUT, build/integrations by default, and tests them with the program, build/bin/cscd by
# default, where nothing else of CSCD is. Prints product, bytes, test and seconds.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath --canonicalize-missing "${1:-$source_dir/build/integrations}")
program=${CSCD_PROGRAM:-$source_dir/build/bin/cscd}
if [[ ! -x $program ]]; then
  echo "$program: is not a program; build cscd, or name its file by CSCD_PROGRAM" >&2
  exit 1
fi
program=$(realpath "$program")
python=/usr/bin/python3 # the Python of the packages, even if another is first in PATH
# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
# VTK and ParaView have modules of the same names: the package python3-vtk9 is unpacked, not installed.
install_packages blender paraview python3-paraview libvtk9.1 libcgal-demo zip >&2

version=$(sed -n 's/^#define CSCD_VERSION "\(.*\)"/\1/p' "$source_dir/include/CSCD/version.h")
blender_zip=$out/cscd-blender-$version.zip
paraview_zip=$out/cscd-paraview-$version.zip
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out" "$work/bin" "$work/home" "$work/cscd_blender" "$work/cscd_paraview"
cp "$source_dir"/integrations/{blender/__init__.py,skeleton_files.py} "$source_dir/LICENSE" "$work/cscd_blender"
cp "$source_dir"/integrations/{paraview/cscd_skeleton.py,skeleton_files.py} "$source_dir/LICENSE" "$work/cscd_paraview"
cp "$source_dir/integrations/export_skeleton.py" "$out"
cd "$work"
rm -f "$blender_zip" "$paraview_zip"
zip --quiet -X --recurse-paths "$blender_zip" cscd_blender
zip --quiet -X --recurse-paths "$paraview_zip" cscd_paraview

cp "$program" bin/cscd
tar --extract --gzip --file /usr/share/doc/libcgal-dev/data.tar.gz data/meshes/elephant.off
export PATH=$work/bin:/usr/bin:/bin HOME=$work/home PYTHONDONTWRITEBYTECODE=1
unset PYTHONPATH

# run_test <product> <command>... runs the test of a product.
run_test()
{
  local product=$1
  local begin=$SECONDS
  shift
  "$@" >&2
  echo "$(basename "$product") $(stat --format=%s "$product") passed $((SECONDS - begin))"
}

test_paraview()
{
  pvpython "$source_dir/integrations/paraview/test.py" "$work/cscd_paraview/cscd_skeleton.py"
  # Without the folder of Debian's modules, where ParaView is.
  (cd "$work" && apt-get download --quiet --quiet python3-vtk9 && dpkg --extract python3-vtk9*.deb vtk)
  PYTHONPATH=$work/vtk/usr/lib/python3/dist-packages "$python" -S "$source_dir/integrations/paraview/test.py" \
    "$work/cscd_paraview/cscd_skeleton.py"
}

test_export()
{
  cscd data/meshes/elephant.off -o elephant.json --quiet
  "$python" "$source_dir/integrations/test_export.py" elephant.json "$work"
}

run_test "$blender_zip" blender --background --factory-startup --python-exit-code 1 \
  --python "$source_dir/integrations/blender/test.py" -- "$blender_zip" data/meshes/elephant.off
run_test "$paraview_zip" test_paraview
run_test "$out/export_skeleton.py" test_export
