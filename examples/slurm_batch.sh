#!/usr/bin/env bash
# All pairs of a family of curves on a cluster with Slurm: an array of 16 shards, and their merger.
#
#   array=$(sbatch --parsable --array=1-16 slurm_batch.sh job.toml)
#   sbatch --dependency=afterany:"$array" slurm_batch.sh job.toml     without an array: merges into job.results
#
# Results that are stored are never computed again: after a time limit or the failure of a node, submit the same lines once more. The
# arrays may be of another size then, as long as the stores of the old one are merged too.
#SBATCH --job-name=lober
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=8
#SBATCH --mem-per-cpu=2G
#SBATCH --time=01:00:00
set -euo pipefail
manifest=${1:?usage: sbatch --array=1-N slurm_batch.sh MANIFEST, then sbatch slurm_batch.sh MANIFEST}
store=${manifest%.toml}.results
if [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then
  lober batch merge "$store" "$store".part*[0-9]
  exit
fi
threads=${SLURM_CPUS_PER_TASK:-1}
# Four fifths of the memory of the task are for curves and the work on them.
memory=$((${SLURM_MEM_PER_CPU:-2048} * threads * 4 / 5))M
# Every task has a store of its own: SQLite does not lock reliably on network file systems.
shard=$((SLURM_ARRAY_TASK_ID - ${SLURM_ARRAY_TASK_MIN:-1} + 1))
lober batch run "$manifest" --store "$store.part$shard-of-$SLURM_ARRAY_TASK_COUNT" \
  --shard "$shard/$SLURM_ARRAY_TASK_COUNT" --threads "$threads" --memory "$memory" --quiet
