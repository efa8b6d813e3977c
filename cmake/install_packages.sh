# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For scripts of bash, to be read by `source`.
# shellcheck shell=bash disable=SC2034

# install_packages <package>... installs missing Debian packages by apt-get, and names them.
install_packages()
{
  local package
  local -a missing=()
  for package in "$@"; do
    if [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
      missing+=("$package")
    fi
  done
  if ((${#missing[@]} == 0)); then
    return
  fi

  local -a as_root=()
  if ((EUID != 0)); then
    as_root=(sudo)
  fi
  echo "Installing Debian packages: ${missing[*]}"
  "${as_root[@]}" apt-get update --quiet --quiet
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --quiet --no-install-recommends "${missing[@]}"
}

# number_of_jobs prints the number of compilers to run at once: one a core, but not more than memory allows.
number_of_jobs()
{
  local cores memory
  cores=$(nproc)
  # A compiler takes up to 3 GB.
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1024 / 1024 / 3) }' /proc/meminfo)
  echo $((memory < 1 ? 1 : memory < cores ? memory : cores))
}

# Packages for the library, its examples and the program cscd; libcgal-demo has the meshes of the examples.
library_packages=(
  g++ cmake ninja-build libcgal-dev libcgal-demo libeigen3-dev libboost-dev libtbb-dev
  libcli11-dev nlohmann-json3-dev libjs-three zlib1g-dev libtiff-dev
)

# Packages for the Python module and its tests.
python_packages=(python3-dev pybind11-dev python3-numpy python3-networkx python3-pytest python3-mypy)
