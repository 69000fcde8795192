#!/usr/bin/env bash
# Builds Handlens on Debian 12 and runs it, or all of its tests.
#   ./setup.sh run    open the demo (with no display: play a tour of it without a window and leave its pictures)
#   ./setup.sh test   run every test
# Packages that are missing are installed with apt-get. The build goes to build/, the programs to build/bin/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

packages=(
  g++ cmake ninja-build pkg-config
  libeigen3-dev libopencv-dev libtbb-dev libassimp-dev libmeshoptimizer-dev
  libavformat-dev libavcodec-dev libavutil-dev libswscale-dev
  nlohmann-json3-dev libvalijson-dev libtomlplusplus-dev libmatio-dev libhdf5-dev zlib1g-dev libcli11-dev libsqlitecpp-dev libsqlite3-dev
  qtbase5-dev libqt5svg5-dev qttools5-dev qttools5-dev-tools libvtk9-dev libvtk9-qt-dev
  qttranslations5-l10n breeze-icon-theme gnuplot-nox xvfb
  clang-format clang-tidy desktop-file-utils dpkg-dev
  googletest libgtest-dev libgmock-dev libbenchmark-dev libceres-dev ffmpeg
)

install_missing_packages() {
  local missing=() as_root=()
  for package in "${packages[@]}"; do
    dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  if [[ $(id -u) != 0 ]]; then
    command -v sudo >/dev/null || { echo "setup.sh: these packages are needed; install them as root: ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
  fi
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

configure() {
  local options=()
  [[ ${CI:-} == true ]] && options+=(-DHANDLENS_WARNINGS_AS_ERRORS=ON)
  cmake --preset release "${options[@]}"
}

run_tests() {
  cmake --build build
  ctest --test-dir build --parallel $(($(nproc) + 1)) --output-on-failure # some wait for windows and processes
}

tour_without_display() {
  local out=$1/tour
  echo "There is no display: playing the tour of the demo without a window."
  rm -rf "$out" && mkdir -p "$out"
  cp -r "$1/demo" "$out/dataset"
  build/bin/handlens "$out/dataset" --offscreen --script resources/tour.jsonl --out "$out"
  echo "The tour's pictures are in $out"
}

run_demo() {
  local cache=${XDG_CACHE_HOME:-$HOME/.cache}/handlens
  cmake --build build --target handlens handlens-batch
  [[ -f $cache/demo/dataset.json ]] || { mkdir -p "$cache" && build/bin/handlens-batch demo --out "$cache/demo"; }
  if [[ -z ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
    tour_without_display "$cache"
  else
    exec build/bin/handlens "$cache/demo"
  fi
}

case ${1:-} in
  run) install_missing_packages; configure; run_demo ;;
  test) install_missing_packages; configure; run_tests ;;
  *) echo "usage: ./setup.sh run|test" >&2; exit 2 ;;
esac
