#!/usr/bin/env bash
# Makes the guide's pictures anew, from the demo dataset and the scripts beside this file: make_pictures.sh [FOLDER OF THE PROGRAMS]
# That of the first pass needs the hand detector: HANDLENS_DETECTOR_PACKAGE names the file that "npm pack @mediapipe/hands" wrote.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
programs=$(cd "${1:-$here/../../build/bin}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$programs/handlens-batch" demo --out "$work/demo"
"$programs/handlens-batch" demo --realistic --level casual --seed 1 --out "$work/realistic" # annotated, by a rig that moved
"$programs/handlens-batch" benchmark "$work/demo" --setup synthetic --fraction 0.03 --differences 1,5,10,15 --seed 7 \
  --methods ch,dch-thres,dch-dt3 --out "$work/pictures/results"
if [[ -n ${HANDLENS_DETECTOR_PACKAGE:-} ]]; then
  export XDG_DATA_HOME=$work/data
  "$programs/handlens-batch" detector install "$HANDLENS_DETECTOR_PACKAGE"
fi
for script in "$here"/*.jsonl; do
  [[ $(basename "$script") != first-pass.jsonl || -n ${HANDLENS_DETECTOR_PACKAGE:-} ]] || continue
  case $(basename "$script") in
    rig.jsonl) source=$work/realistic ;;
    *) source=$work/demo ;; # without annotations
  esac
  cp -r "$source" "$work/dataset" # every script starts anew
  "$programs/handlens" "$work/dataset" --language en --rater ann --offscreen --script "$script" --out "$work/pictures"
  rm -rf "$work/dataset"
done
cp "$work/pictures"/*.png "$here"
