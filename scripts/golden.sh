#!/usr/bin/env bash
# Renews what the corpus of crates/touchdown/tests/golden is expected to give, and prints what changed: the column, in how many
# rows, and by how much at most. Commit the result where a change of the model explains it.
set -euo pipefail
cd "$(dirname "$0")/.."
for test in the_corpus_gives pictures_of_the_corpus; do
    TOUCHDOWN_RENEW_GOLDEN=1 cargo test --quiet --release -p touchdown --test suite -- "$test" --nocapture
done
