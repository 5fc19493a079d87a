#!/usr/bin/env python3
"""Run a sweep as shards on HyperQueue, and merge them.

    pip install hyperqueue
    scripts/hyperqueue_sweep.py sweeps/trade.toml --shards 64 --server-dir ~/.hq-server
    scripts/hyperqueue_sweep.py sweeps/trade.toml --shards 4 --local 2

HyperQueue brings the machines: its server allocates them through Slurm or PBS (`hq alloc add`). The
shards and the folder of results must be on a file system that all machines share. A shard that fails,
or whose machine dies, is submitted again and goes on from its journal. `--local` starts a cluster of
workers with one core each on this machine.
"""

import argparse
import logging
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig
from hyperqueue.ffi.protocol import ResourceRequest

# So often the machine under a task may die before HyperQueue itself gives the task up.
CRASH_LIMIT = 20


def options():
    """What the command line asks for."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("sweep", type=Path, help="sweep file (TOML)")
    parser.add_argument("--shards", type=int, required=True, help="number of parts, one task each")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--server-dir", type=Path, help="folder of a running HyperQueue server")
    where.add_argument("--local", type=int, metavar="WORKERS", help="start so many workers here")
    parser.add_argument("--out", type=Path, default=Path("results"), help="folder for the results")
    parser.add_argument("--threads", type=int, default=1, help="cores for each shard")
    parser.add_argument("--retries", type=int, default=3, help="times a failed shard runs again")
    parser.add_argument("--touchdown", default="touchdown", help="the program")
    return parser.parse_args()


@contextmanager
def connected(arguments):
    """A client of the cluster that was asked for."""
    if arguments.local is None:
        yield Client(arguments.server_dir)
        return
    with tempfile.TemporaryDirectory() as folder, LocalCluster(folder) as cluster:
        for _ in range(arguments.local):
            cluster.start_worker(WorkerConfig(cores=arguments.threads))
        yield cluster.client()


def job_of(arguments, shards):
    """One task for each shard that is still to be done."""
    job = Job(max_fails=None, name=arguments.sweep.stem, default_workdir=Path.cwd())
    for shard in shards:
        log = str(arguments.out / f"{arguments.sweep.stem}.{shard}-of-{arguments.shards}.log")
        job.program(
            [
                arguments.touchdown, "sweep", str(arguments.sweep),
                "--out", str(arguments.out),
                "--shard", f"{shard}/{arguments.shards}",
                "--threads", str(arguments.threads),
            ],
            stdout=log,
            stderr=log,
            name=str(shard),
            resources=ResourceRequest(cpus=arguments.threads),
            crash_limit=CRASH_LIMIT,
        )  # fmt: skip
    return job


def main():
    """Submits, waits, submits again what failed, and merges."""
    logging.basicConfig(level=logging.INFO, format="%(message)s")
    arguments = options()
    arguments.out.mkdir(parents=True, exist_ok=True)
    with connected(arguments) as client:
        shards = list(range(1, arguments.shards + 1))
        for attempt in range(arguments.retries + 1):
            submitted = client.submit(job_of(arguments, shards))
            if client.wait_for_jobs([submitted], raise_on_error=False):
                shards = []
                break
            shards = [shards[task] for task in client.get_failed_tasks(submitted)]
            logging.warning("shards %s failed, attempt %d", shards, attempt + 1)
    if shards:
        sys.exit(f"shards {shards} failed {arguments.retries + 1} times: see their .log")
    merge = [arguments.touchdown, "merge", str(arguments.out)]
    sys.exit(subprocess.run(merge, check=False).returncode)


if __name__ == "__main__":
    main()
