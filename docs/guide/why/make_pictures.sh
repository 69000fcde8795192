#!/usr/bin/env bash
# Makes the pictures of why-methods-fail.md anew: make_pictures.sh HANDS [FOLDER OF THE PROGRAMS]
# HANDS is the dataset of the method authors' sequences 01 to 04 (handlens-batch import tzionas, see ../../results.md), of which
# only the window's pictures stay here. The casual recording is simulated on the way.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
hands=${1:?"usage: make_pictures.sh HANDS [FOLDER OF THE PROGRAMS]"}
programs=$(cd "${2:-$here/../../../build/bin}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
play() { "$programs/handlens" "$1" --language en --rater sim --offscreen --script "$here/$2.jsonl" --out "$work/pictures"; }
cp -r "$hands" "$work/hands" # a copy: the window keeps its annotations there
"$programs/handlens-batch" demo --realistic --level casual --seed 1 --out "$work/casual"
for script in hole-between-fingers halfway-between-fingers hidden-fingers; do
  play "$work/hands" "$script"
done
play "$work/casual" gap-between-wrists
cp "$work/pictures"/*.png "$here"
