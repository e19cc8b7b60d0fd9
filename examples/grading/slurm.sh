#!/usr/bin/env bash
# Marks a very large class on a cluster that runs Slurm, in 20 parts, and puts the parts together:
#
#   marking=$(sbatch --parsable --array=1-20 slurm.sh key.md submissions marked)
#   sbatch --dependency=afterok:"$marking" slurm.sh key.md submissions marked merge
#
# A part that was stopped goes on where it was when it is sent again. All nodes see the folder of results.
#SBATCH --job-name=polhode
#SBATCH --cpus-per-task=4
#SBATCH --mem=4G
#SBATCH --time=00:30:00
set -eu
key="$1" submissions="$2" marked="$3"
if [ "${4:-}" = merge ]; then
    polhode grade "$key" --out "$marked" --merge || [ $? -eq 3 ]
else
    part="${SLURM_ARRAY_TASK_ID:?send this with --array}/${SLURM_ARRAY_TASK_COUNT:?}"
    # 3: someone waits for a person.
    polhode grade "$key" "$submissions" --out "$marked" --shard "$part" --threads "${SLURM_CPUS_PER_TASK:-1}" || [ $? -eq 3 ]
fi
