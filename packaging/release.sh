#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# release.sh OUT [PRODUCT...]: builds all products, or the named ones, on Debian 12, from a clean clone of the last
# commit. The product debian comes first, because the other programs are compared with its program; linux takes the
# program that wheel builds. Each product is tested where nothing else of CSCD is installed. The products and their
# checksums go to OUT, the logs to OUT/work, and a table is printed. The exit status is 0 if all products were built and
# passed their tests.
# shellcheck disable=SC2317 # functions are called by name

set -euo pipefail

if (($# == 0)); then
  echo "Usage: release.sh OUT [debian] [wheel] [linux] [windows] [arm64] [npm] [integrations]" >&2
  exit 1
fi
out=$(realpath --canonicalize-missing "$1")
work=$out/work
rm -rf "$out"
mkdir -p "$work/meshes"
git clone --quiet "$(dirname "${BASH_SOURCE[0]}")/.." "$work/source"
cd "$work/source"

# shellcheck source=cmake/install_packages.sh
source cmake/install_packages.sh
install_packages "${library_packages[@]}" "${python_packages[@]}" python3-pip python3-venv python3-setuptools \
  python3-wheel file dpkg-dev lintian mmdebstrap g++-mingw-w64-x86-64-posix libz-mingw-w64-dev wine wine64 \
  g++-aarch64-linux-gnu qemu-user-static
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(number_of_jobs)}
version=$(sed -n 's/.* CSCD_VERSION "\(.*\)"/\1/p' include/CSCD/version.h)
tar --extract --file /usr/share/doc/libcgal-dev/data.tar.gz --directory "$work/meshes" --strip-components 2 data/meshes
elephant=$work/meshes/elephant.off
native=$work/source/build-debian/bin/cscd

# Used by each test of the Python module.
cat >"$work/use_module.py" <<'END'
import sys, cscd
shape = cscd.read(sys.argv[1])
skeleton = cscd.skeletonize(shape.vertices, shape.faces)
assert len(skeleton.edges) == len(skeleton.nodes) + 2, "elephant.off has genus 3"
END

debian()
{
  cmake -S . -B build-debian -G Ninja -DCSCD_BUILD_PYTHON=ON -DCSCD_BUILD_TESTS=OFF -DCSCD_BUILD_BENCHMARKS=OFF \
    -DPython_EXECUTABLE=/usr/bin/python3 -DCSCD_PYTHON_DESTINATION=lib/python3/dist-packages
  cmake --build build-debian --target cscd cscd_python
  (cd build-debian && cpack -G DEB -B "$work/debian")
  lintian --fail-on error "$work"/debian/*.deb
  cat >"$work/in_chroot.sh" <<'END'
set -eux
cd /root
apt-get install --yes --no-install-recommends ./*.deb
cscd elephant.off -o elephant.html -o elephant.swc
python3 use_module.py elephant.off
apt-get install --yes --no-install-recommends g++ cmake make
cat >CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.24)
project(example LANGUAGES CXX)
find_package(CSCD REQUIRED)
add_executable(example readme_example.cpp)
target_link_libraries(example PRIVATE CSCD::CSCD)
CMAKE
cmake -B build -DCMAKE_BUILD_TYPE=Release
cmake --build build
mkdir -p data/meshes
mv elephant.off data/meshes
CGAL_DATA_DIR=data build/example | grep -c .
END
  mmdebstrap --variant=apt --format=null \
    --customize-hook="cp $work/debian/*.deb $work/in_chroot.sh $work/use_module.py $elephant \
      $PWD/examples/readme_example.cpp \$1/root" \
    --customize-hook='chroot "$1" sh /root/in_chroot.sh' bookworm /dev/null http://deb.debian.org/debian
  mv "$work"/debian/*.deb "$out"
  echo "lintian; installed in a fresh chroot: program, module, README's example of C++"
}

wheel()
{
  CMAKE_ARGS="--preset portable" /usr/bin/python3 setup.py --quiet bdist_wheel \
    --plat-name manylinux_2_28_x86_64 --dist-dir "$work/wheel"
  packaging/check_symbols.sh build-pip/python/cscd/_core.*.so
  /usr/bin/python3 -m venv "$work/venv"
  # Debian's NumPy, since this works without PyPI.
  cp -r /usr/lib/python3/dist-packages/numpy* "$work"/venv/lib/python3*/site-packages
  cd "$work/venv"
  bin/pip install --no-index "$work"/wheel/*.whl
  env -i bin/python3 "$work/use_module.py" "$elephant"
  env -i bin/cscd "$elephant" -o elephant.html
  PATH=$work/venv/bin:/usr/bin bin/cscd-batch "$elephant" --output-dir batch
  # From the source: with what Debian has, which is outside of a virtual environment.
  cd "$work/source"
  /usr/bin/python3 -m venv --system-site-packages "$work/venv_source"
  CMAKE_ARGS="--preset portable" "$work/venv_source/bin/pip" install --no-index --no-build-isolation .
  (cd / && env -i "$work/venv_source/bin/python3" "$work/use_module.py" "$elephant")
  mv "$work"/wheel/*.whl "$out"
  echo "manylinux_2_28; virtual environment with NumPy alone: module, programs; pip install ."
}

linux()
{
  # Built for the wheel.
  cp build-pip/bin/cscd "$work/cscd"
  file "$work/cscd" | grep "statically linked"
  packaging/compare_programs.py "$work/meshes" "$native" "$work/cscd"
  mv "$work/cscd" "$out/cscd-$version-linux-x86_64"
}

# cross <preset> <program of the build> <emulator> <name of the product>
cross()
{
  cmake --preset "$1"
  cmake --build "build-$1" --target cscd
  packaging/compare_programs.py "$work/meshes" "$native" "$3 $PWD/build-$1/bin/$2"
  mv "build-$1/bin/$2" "$out/$4"
}

windows()
{
  WINEPREFIX=$work/wine WINEDEBUG=-all cross windows cscd.exe wine "cscd-$version-windows-x86_64.exe"
}

arm64()
{
  cross arm64 cscd qemu-aarch64-static "cscd-$version-linux-arm64"
}

npm()
{
  npm/build.sh "$out"
}

integrations()
{
  CSCD_PROGRAM=$native integrations/build.sh "$out"
}

rows=()
status=0
products=("${@:2}")
if ((${#products[@]} == 0)); then
  products=(debian wheel linux windows arm64 npm integrations)
fi
for product in "${products[@]}"; do
  echo "== $product"
  touch "$work/begin"
  begin=$SECONDS
  set +e
  (
    set -e
    "$product"
  ) >"$work/$product.log" 2>&1
  code=$?
  set -e
  result=$(tail --lines 1 "$work/$product.log")
  if ((code != 0)); then
    status=1
    result="FAILED: $work/$product.log"
  fi
  size=$(find "$out" -maxdepth 1 -type f -newer "$work/begin" -printf '%s\n' | awk '{ n += $1 } END { print n / 1e6 }')
  rows+=("$(printf '| %s | %.1f MB | %s | %d s |' "$product" "$size" "$result" $((SECONDS - begin)))")
done

cp packaging/release_notes.md "$out/release_notes.md"
(cd "$out" && find . -maxdepth 1 -type f ! -name release_notes.md -printf '%f\n' | sort | xargs sha256sum) |
  sed 's/^/    /' >>"$out/release_notes.md"
printf '%s\n' "| product | size | test | time |" "|---|--:|---|--:|" "${rows[@]}"
exit $status
