#!/usr/bin/env bash
# All pairs of a family of curves on a cluster, in one of two ways:
#
#   sbatch examples/slurm_batch.sh job.toml                  one job of several ranks (lober_mpi): balanced dynamically
#   sbatch --array=1-16 --ntasks=1 examples/slurm_batch.sh job.toml    an array of 16 shards, no MPI needed; afterwards
#                                                                      lober batch merge job.results job.results.part*
#
# What was stored is never computed again: after a time limit or a node failure just submit the same line once more.
#SBATCH --job-name=lober
#SBATCH --ntasks=8
#SBATCH --cpus-per-task=8
#SBATCH --mem-per-cpu=2G
#SBATCH --time=01:00:00
set -euo pipefail
manifest=${1:?usage: sbatch slurm_batch.sh MANIFEST}
store=${manifest%.toml}.results
threads=${SLURM_CPUS_PER_TASK:-1}
# Four fifths of what the ranks of a node are given is for curves and the work on them.
memory=$((${SLURM_MEM_PER_CPU:-2048} * threads * 4 / 5))M

if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
  # Every task has a store of its own: SQLite does not lock reliably on network file systems.
  lober batch run "$manifest" --store "$store.part$SLURM_ARRAY_TASK_ID" \
    --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --threads "$threads" --memory "$memory"
else
  srun lober_mpi "$manifest" --store "$store" --threads "$threads" --memory "$memory"
fi
