#!/usr/bin/env bash
# Makes this page's datasets, tables and pictures anew (minutes): make_pictures.sh [FOLDER OF THE PROGRAMS] [FOLDER TO KEEP THE DATASETS IN]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
programs=$(cd "${1:-$here/../../build/bin}" && pwd)
work=${2:-$(mktemp -d)}
batch="$programs/handlens-batch"
"$batch" demo --realistic --level casual --seed 1 --out "$work/casual"
"$batch" rig "$work/casual" --sequences fingers-walking --refine --out "$work/refined.json"
cp -r "$work/casual" "$work/refined"
cp "$work/refined.json" "$work/refined/cameras-refined.json"
sed -i 's#"cameras": *"cameras.json"#"cameras": "cameras-refined.json"#' "$work/refined/dataset.json"
"$batch" subject "$work/refined" --sequence fingers-walking --out "$work/person"
for dataset in casual refined person; do
  "$batch" benchmark "$work/$dataset" --setup realistic --fraction 1 --differences 5,15 --seed 1 --methods ch,dch-thres,best --out "$work/benchmark-$dataset"
done
play() { "$programs/handlens" "$1" --language en --rater sim --offscreen --script "$here/$2" --out "$here"; }
play "$work/casual" before.jsonl
play "$work/refined" after.jsonl
