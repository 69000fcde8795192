#!/usr/bin/env bash
# Makes the guide's pictures anew, from the demo dataset and the scripts beside this file: make_pictures.sh [FOLDER OF THE PROGRAMS]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
programs=$(cd "${1:-$here/../../build/bin}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$programs/handlens-batch" demo --out "$work/demo"
"$programs/handlens-batch" demo --realistic --level casual --seed 1 --out "$work/realistic" # annotated, by a rig that moved
for script in "$here"/*.jsonl; do
  case $(basename "$script") in
    rig.jsonl) source=$work/realistic ;;
    *) source=$work/demo ;; # without annotations
  esac
  cp -r "$source" "$work/dataset" # every script starts anew
  "$programs/handlens" "$work/dataset" --language en --rater ann --offscreen --script "$script" --out "$here"
  rm -rf "$work/dataset"
done
