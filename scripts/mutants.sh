#!/usr/bin/env bash
# Faults planted one by one in the source: which of them does no test notice?
#
#     scripts/mutants.sh CRATE MINUTES        a random sample of the faults in a crate, for so long
#     scripts/mutants.sh --in-diff REVISION   every fault in what has changed since a revision
#
# CRATE is dynamics, search, input, sweep, figures or explorer. Each fault is built and tested by itself in a copy of the
# tree, which takes minutes; a test that hangs counts as noticing after five. target/mutants.out has the lists: missed.txt is
# what nobody noticed. The tests are those of the crate and of the program, with its corpus; for search and input also
# those of sweep.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v cargo-mutants > /dev/null || cargo install --locked cargo-mutants

common=(--output target --profile release --timeout 300 --shuffle --colors never)
case ${1-} in
    --in-diff)
        git diff "${2:?a revision}" > target/mutants.diff
        cargo mutants "${common[@]}" --workspace --test-workspace true --in-diff target/mutants.diff
        ;;
    "" | -*)
        sed -n '2,10p' "$0"
        exit 2
        ;;
    *)
        tests=touchdown-$1,touchdown
        case $1 in search | input) tests+=,touchdown-sweep ;; esac
        # Interrupted, it leaves the lists of what it has tried.
        timeout --signal INT "${2:?minutes}m" \
            cargo mutants "${common[@]}" --package "touchdown-$1" --test-package "$tests" || true
        ;;
esac
for list in caught missed timeout unviable; do
    printf '%8s %s\n' "$(wc -l < target/mutants.out/$list.txt)" "$list"
done
cat target/mutants.out/missed.txt
