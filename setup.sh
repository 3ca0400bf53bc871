#!/bin/sh
# Sets up Debian 12 or 13 for this project and goes on to a first result.
#   ./setup.sh picture    installs what the program needs, builds it, renders the Cornell Box to
#                         cornell.png
#   ./setup.sh package    installs that and makes a Debian package in build-package, which runs on every
#                         processor of the architecture
#   ./setup.sh packages   installs what the program and its tests are built from
#   ./setup.sh test       installs that, a browser for the test of the report page, and clang's tools
#                         for .ci; builds everything and runs all tests
# Only missing packages are installed. When there are none, no network and no root is needed.
set -eu
cd "$(dirname "$0")"

program_packages="g++ cmake make libembree-dev libopenimageio-dev liblcms2-dev zlib1g-dev
  libglm-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev gnuplot-nox
  fonts-dejavu-core"
test_packages="libgtest-dev libbenchmark-dev"
package_packages="dpkg-dev file"
# Without these the tests that need them are skipped.
tool_packages="chromium chromium-driver python3-selenium clang libclang-rt-dev clang-format
  clang-tidy"

installed() {
  for package in "$@"; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || return 1
    [ "$status" = installed ] || return 1
  done
}

missing_of() {
  for package in "$@"; do
    installed "$package" || printf ' %s' "$package"
  done
}

# The command that makes the next one run as root; fails when there is none.
find_root() {
  as_root=
  [ "$(id -u)" -eq 0 ] && return
  command -v sudo >/dev/null && sudo -v && as_root=sudo
}

install_packages() {
  missing=$(missing_of "$@")
  [ -n "$missing" ] || return 0
  if ! command -v apt-get >/dev/null; then
    echo "setup.sh: going on without the packages that Debian calls$missing" >&2
    return 0
  fi
  if ! find_root; then
    echo "setup.sh: going on without packages that only root can install:" >&2
    echo "  apt-get install --no-install-recommends$missing" >&2
    return 0
  fi
  $as_root apt-get update -q
  offered=
  for package in $missing; do
    if LC_ALL=C apt-cache policy "$package" | grep -q 'Candidate: [^(]'; then
      offered="$offered $package"
    else # Ubuntu, for example, offers no package chromium
      echo "setup.sh: going on without $package, which this system does not offer" >&2
    fi
  done
  [ -n "$offered" ] || return 0
  echo "Packages to install:$offered"
  # shellcheck disable=SC2086 # words of a list
  LC_ALL=C apt-get install --no-install-recommends --assume-no $offered 2>/dev/null |
    grep -E '^(Need to get|After this operation)' || true
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qqy --no-install-recommends $offered
}

need_cmake() {
  command -v cmake >/dev/null && return
  echo "setup.sh: cmake is missing; nothing can be built" >&2
  exit 1
}

# shellcheck disable=SC2086 # words of lists
case "${1:-}" in
  picture)
    install_packages $program_packages
    need_cmake
    tests=ON
    installed $test_packages || tests=OFF
    echo "Building the program: about three minutes on two idle cores"
    cmake --preset release -DRAYTRACING_TESTS=$tests
    cmake --build --preset release --parallel "$(nproc)" --target Raytracing
    ./build/Raytracing --scene scenes/cornell.toml --spp 16 --output cornell.png
    ;;
  package)
    install_packages $program_packages $package_packages
    need_cmake
    echo "Building the program: about three minutes on two idle cores"
    cmake --preset package
    cmake --build --preset package --parallel "$(nproc)"
    cpack --preset package
    ;;
  packages)
    install_packages $program_packages $test_packages
    ;;
  test)
    install_packages $program_packages $test_packages $tool_packages
    need_cmake
    cmake --preset release
    cmake --build --preset release --parallel "$(nproc)"
    ctest --preset release
    ;;
  *)
    sed -n 's/^#   //p' "$0" >&2
    exit 2
    ;;
esac
