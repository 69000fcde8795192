#!/usr/bin/env bash
# Runs the checks of .clang-tidy on the files that are named, else on a few of the core that include little and so take seconds.
# Ends with status 1 if anything is found in the project's own code.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
files=("$@")
if ((${#files[@]} == 0)); then
  mapfile -t files < <(find core/numeric core/processor core/text -name '*.cpp' 2>/dev/null | sort)
fi
exec "${CLANG_TIDY:-clang-tidy}" --quiet --warnings-as-errors='*' "${files[@]}" -- \
  -std=c++20 -I. -isystem /usr/include/eigen3 -isystem /usr/include/opencv4
