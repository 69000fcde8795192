#!/usr/bin/env bash
# Formats all sources as .clang-format says; with --check it only names the places that differ and ends with status 1 if there are any.
# Needs clang-format 14 (Debian package clang-format): other versions format differently.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
clang_format=${CLANG_FORMAT:-clang-format}
version=$("$clang_format" --version | sed 's/.*version \([0-9]*\).*/\1/')
if [[ $version != 14 ]]; then
  echo "format.sh: clang-format 14 is needed, this is version $version" >&2
  exit 2
fi
sources() { find core widgets app tests cmake -name '*.cpp' -o -name '*.h' | sort; }

if [[ ${1:-} == --check ]]; then
  sources | xargs "$clang_format" --dry-run --Werror
else
  sources | xargs "$clang_format" -i
fi
