#!/usr/bin/env bash
# Run time against error on this machine: writes results/tolerance.csv and prints it as a table.
# Takes a few minutes on one core.
set -euo pipefail
cd "$(dirname "$0")/.."
table=$(mktemp)
trap 'rm -f "$table"' EXIT
cargo bench -p touchdown-dynamics --bench tolerance > "$table"
mv "$table" results/tolerance.csv
trap - EXIT
column -s, -t results/tolerance.csv
