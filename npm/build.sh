#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: build.sh [OUT]
# Installs missing packages (Debian, Ubuntu), builds the npm package into the folder OUT, build/npm by default, and
# tests it in a fresh folder: in Node and in headless Chromium. Prints product, bytes, test and seconds. The WebAssembly
# module is that of the page: its build takes minutes.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath --canonicalize-missing "${1:-$source_dir/build/npm}")
max_size=1500000 # bytes
"$source_dir/examples/web/build.sh" >&2
# shellcheck source=cmake/install_packages.sh
source "$source_dir/cmake/install_packages.sh"
tools=(chromium libcgal-demo)
command -v npm >/dev/null || tools+=(npm)
install_packages "${tools[@]}" >&2

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
package=$work/package
mkdir -p "$package" "$work/test" "$out"
cp -r "$source_dir"/npm/{*.js,index.d.ts,package.json,README.md,examples} "$source_dir/LICENSE" "$package"
cp "$source_dir/build/web/cscd.wasm" "$package"
cat "$source_dir"/build/web/cscd.js "$source_dir"/examples/web/worker.js >"$package/worker.js"
tarball=$out/$(cd "$package" && npm pack --silent --pack-destination "$out")
size=$(stat --format=%s "$tarball")
if ((size > max_size)); then
  echo "$tarball: has $size bytes; at most $max_size are allowed" >&2
  exit 1
fi

# Nothing else of CSCD is there. The three.js of Debian is too old for the example.
cd "$work/test"
begin=$SECONDS
npm install --silent --no-audit --no-fund "$tarball" three@0.160 typescript@5 >&2
tar --extract --gzip --file /usr/share/doc/libcgal-dev/data.tar.gz data/meshes/elephant.off
cp "$source_dir"/npm/{test.mjs,types.mts} .
npx tsc --noEmit --strict --module nodenext --target esnext types.mts >&2
ELEPHANT=data/meshes/elephant.off node --test test.mjs >&2
python3 "$source_dir/npm/test_in_chromium.py" "$work/test" >&2
echo "$(basename "$tarball") $size passed $((SECONDS - begin))"
