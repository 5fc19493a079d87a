#!/usr/bin/env bash
# The module of exported pages: it is what the source builds, and answers as the program does, bit for bit.
#
#     scripts/tests/explorer_wasm.sh
#
# The command line must have been built for release; node is needed.
set -euo pipefail
cd "$(dirname "$0")/../.."

scripts/build_explorer_wasm.sh --check

files=(sweeps/vehicles/surveyor-table-4-1.toml sweeps/vehicles/four-legs.toml sweeps/vehicles/six-legs.toml
    results/surface-4-20.csv results/figure-4-09.csv)
out=$(mktemp -d)
target/release/touchdown explore "${files[@]}" >"$out/address" &
server=$!
trap 'kill "$server"; rm -rf "$out"' EXIT
target/release/touchdown explore "${files[@]}" --export "$out/page.html"
until [ -s "$out/address" ]; do sleep 0.1; done
node scripts/tests/explorer_wasm.mjs "$out/page.html" "$(cat "$out/address")"
