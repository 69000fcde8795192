#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a benchmark as a Slurm array job, one task per shard, then brings the shards together.
#
#   submit.sh SHARDS OUT DATASET [options of `handlens-batch benchmark`, without --shard and --out]
#
# SHARDS  number of tasks; each has its own part of the frame pairs
# OUT     folder on a file system that all nodes share: OUT/shard-0 ... OUT/shard-N, OUT/slurm-*.log, OUT/merged
#
# A task that is killed or preempted is queued again by Slurm and goes on after its last finished fit. To repair a task by
# hand, give the same command again: what is finished is not computed twice.
# HANDLENS_BATCH names the program if it is not in the PATH; SBATCH_* variables (partition, account, time) work as ever.
set -euo pipefail
if [ $# -lt 3 ]; then
    sed -n '3,13s/^# \{0,1\}//p' "$0"
    exit 2
fi
shards=$1
out=$(mkdir -p "$2" && cd "$2" && pwd)
dataset=$(cd "$3" && pwd)
shift 3
export HANDLENS_BATCH=${HANDLENS_BATCH:-handlens-batch}
here=$(cd "$(dirname "$0")" && pwd)

array=$(sbatch --parsable --job-name=handlens --array=0-$((shards - 1)) --requeue --open-mode=append \
    --output="$out/slurm-%a.log" "$here/shard.sbatch" "$shards" "$out" "$dataset" "$@")
merge=$(sbatch --parsable --job-name=handlens-merge --dependency=afterok:"${array%%;*}" --kill-on-invalid-dep=yes \
    --output="$out/slurm-merge.log" "$here/merge.sbatch" "$shards" "$out")
echo "array job ${array%%;*} with $shards tasks, then job ${merge%%;*}; the results will be in $out/merged"
