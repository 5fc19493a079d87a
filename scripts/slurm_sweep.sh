#!/usr/bin/env bash
# Run a sweep as shards on Slurm: a job array, and a job that merges them when all are done.
#
#   scripts/slurm_sweep.sh SWEEP SHARDS OUT [SBATCH OPTIONS...]
#   scripts/slurm_sweep.sh sweeps/trade.toml 64 /scratch/trade --time=12:00:00 --cpus-per-task=8
#
# OUT must be on a file system that all machines share. Requeued, or submitted again with the same
# arguments, shards go on from their journals. TOUCHDOWN names the program.
set -euo pipefail

if [ $# -lt 3 ]; then
    sed -n '2,9s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
sweep=$1 shards=$2 out=$3
shift 3
touchdown=${TOUCHDOWN:-touchdown}
name=$(basename "$sweep" .toml)
mkdir -p "$out"

array=$(sbatch --parsable --job-name="$name" --array="1-$shards" --requeue \
    --output="$out/$name.%a-of-$shards.log" "$@" \
    --wrap="$(printf '%q ' "$touchdown" sweep "$sweep" --out "$out")\
--shard \$SLURM_ARRAY_TASK_ID/$shards --threads \${SLURM_CPUS_PER_TASK:-1}")

# A federated cluster adds its name after a semicolon.
merge=$(sbatch --parsable --job-name="$name-merge" --dependency="afterok:${array%%;*}" \
    --output="$out/$name.merge.log" --wrap="$(printf '%q ' "$touchdown" merge "$out")")

echo "shards: job ${array%%;*}, merge: job ${merge%%;*}; results will be in $out"
