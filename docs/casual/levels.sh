#!/usr/bin/env bash
# Measures the levels of realism (simulated in memory) on a dataset with recorded motion: levels.sh DATASET OUT [FOLDER OF THE PROGRAMS]
# A tenth of the frames, seed 1; every level after `rig --refine` and `subject` from five annotated frames. Stopped, it goes on where it ended.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
programs=${3:-$here/../../build/bin}
"$programs/handlens-batch" benchmark "$1" --sweep realism --settings noise-adapted,forearm-adapted,other-hand-adapted,casual-adapted \
  --fraction 0.07 --differences 1,5,10,15 --seed 1 --methods ch,dch-thres,best --out "$2"
