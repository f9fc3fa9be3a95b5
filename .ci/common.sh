# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by every script here: strict mode, the root of the tree, and what they share.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# VTK's own wheel lives here; CMakePresets.json knows the folder.
venv="$PWD/build-venv-9.5"

if command -v ccache > /dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

# install_packages PURPOSE...: the packages of these purposes that are missing.
install_packages() {
  local purposes package missing=()
  purposes=$(IFS="|"; echo "$*")
  for package in $(awk -v purposes="^($purposes)$" '$1 ~ purposes { print $2 }' \
    .ci/packages-debian.txt); do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null)" != installed ]; then
      missing+=("$package")
    fi
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return
  fi
  echo "Installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -q
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# build_preset PRESET [NINJA ARGUMENT...]: configure and build build-PRESET.
build_preset() {
  local preset=$1
  shift
  cmake --preset "$preset"
  cmake --build "build-$preset" -- "$@"
}

# run_tests PRESET [CTEST ARGUMENT...]: with one virtual display for all of them.
run_tests() {
  local preset=$1
  shift
  Testing/with-display ctest --test-dir "build-$preset" --parallel 2 --output-on-failure \
    --no-tests=error "$@"
}
