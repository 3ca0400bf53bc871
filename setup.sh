#!/usr/bin/env bash
# Sets up Debian 12 or 13 for this project and goes on to a first result.
#   ./setup.sh packages   installs the packages that build and charts need
#   ./setup.sh picture    packages, release build, Cornell Box rendered to cornell.png
#   ./setup.sh test       packages, a browser for the report page's test, clang for .ci/fuzz,
#                         release build, all tests
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

packages() {
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends \
    g++ cmake make libembree-dev libopenexr-dev libpng-dev libopenimageio-dev libglm-dev \
    libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev libgtest-dev libbenchmark-dev \
    gnuplot-nox "$@"
}

build() {
  cmake --preset release
  cmake --build --preset release --parallel "$(nproc)" "$@"
}

case "${1:-}" in
  packages) packages ;;
  picture)
    packages
    build --target Raytracing
    ./build/Raytracing --scene scenes/cornell.toml --spp 16
    ;;
  test)
    packages chromium chromium-driver python3-selenium clang libclang-rt-dev
    build
    ctest --preset release
    ;;
  *)
    sed -n 's/^#   //p' "$0" >&2
    exit 2
    ;;
esac
