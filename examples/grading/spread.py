"""Marks a class in parts on a Dask cluster and puts the parts together.

    pip install "dask[distributed]"
    python spread.py key.md submissions marked --parts 8

Without --scheduler the cluster is of processes on this machine. All workers must see the three paths.
"""

import argparse
import subprocess
import sys

from dask.distributed import Client, LocalCluster

# 0: all work is marked; 3: someone waits for a person.
DONE = (0, 3)


def mark_part(polhode: str, key: str, submissions: str, out: str, number: int, parts: int) -> int:
    """Marks one part. A part that was stopped goes on where it was."""
    part = f"{number}/{parts}"
    command = [polhode, "grade", key, submissions, "--out", out, "--shard", part, "--threads", "1"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in DONE:
        raise RuntimeError(f"part {part}: {done.stderr.strip()}")
    return done.returncode


def main() -> int:
    """Returns the exit code of the merge."""
    reader = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    reader.add_argument("key")
    reader.add_argument("submissions")
    reader.add_argument("out")
    reader.add_argument("--parts", type=int, default=8)
    reader.add_argument("--scheduler", help="the address of a cluster")
    reader.add_argument("--polhode", default="polhode", help="the command, if it is not on the path")
    options = reader.parse_args()
    cluster = options.scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        parts = [
            client.submit(
                mark_part, options.polhode, options.key, options.submissions, options.out, number, options.parts,
                retries=2, pure=False,
            )
            for number in range(1, options.parts + 1)
        ]
        client.gather(parts)
    merge = [options.polhode, "grade", options.key, "--out", options.out, "--merge"]
    return subprocess.run(merge).returncode


if __name__ == "__main__":
    sys.exit(main())
