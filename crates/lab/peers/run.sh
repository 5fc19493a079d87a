#!/usr/bin/env bash
# Time against error of the same landings: SciPy, ode_solvers and diffsol beside touchdown.
# Builds everything, measures on one core (about 5 minutes), prints the table and writes
# crates/lab/results/peers.csv and peers.md. With --quick: ten landings, written to target/quick.
#
# Needs Python 3.11 or later with venv, and a Rust toolchain.
set -euo pipefail
cd "$(dirname "$0")"

python3 -m venv target/python
target/python/bin/pip install --quiet .
exec target/python/bin/python compare.py "$@"
