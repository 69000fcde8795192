#!/usr/bin/env bash
# Makes the guide's pictures anew, from the demo dataset and the scripts beside this file: make_pictures.sh [FOLDER OF THE PROGRAMS]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
programs=$(cd "${1:-$here/../../build/bin}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$programs/handlens-batch" demo --out "$work/demo"
for script in "$here"/*.jsonl; do
  cp -r "$work/demo" "$work/dataset" # every script starts without annotations
  "$programs/handlens" "$work/dataset" --language en --rater ann --offscreen --script "$script" --out "$here"
  rm -rf "$work/dataset"
done
