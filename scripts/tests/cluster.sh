#!/usr/bin/env bash
# A sweep on HyperQueue, with a shard killed on the way, and one through Slurm's interface, must give
# the bytes of one run on one machine.
#
#   scripts/tests/cluster.sh [PYTHON WITH HYPERQUEUE]
set -euo pipefail
cd "$(dirname "$0")/../.."
python=${1:-python3}
touchdown=${TOUCHDOWN:-$PWD/target/release/touchdown}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cp -r sweeps/vehicles "$folder"
cp sweeps/figure-4-09.toml "$folder/trade.toml"
cd "$folder"
"$touchdown" sweep trade.toml --out one --quiet

same() {
    for table in trade.csv trade-bands.csv trade.svg; do
        cmp "one/$table" "$1/$table"
    done
    echo "$1: the same bytes"
}

scripts=$OLDPWD/scripts
"$python" "$scripts/hyperqueue_sweep.py" trade.toml --shards 4 --local 2 --out hyperqueue \
    --touchdown "$touchdown" >hyperqueue.log 2>&1 &
runner=$!
# Kill one shard in the middle of its work, which takes half a second or more.
killed=no
while [ $killed = no ] && kill -0 $runner 2>/dev/null; do
    journal=hyperqueue/trade.2-of-4.journal
    head=$(stat -c %s "$journal" 2>/dev/null || echo 0)
    if [ "$head" -gt 0 ]; then
        shard=$(pgrep -f "^$touchdown sweep trade.toml --out hyperqueue --shard 2/4" || true)
        [ -n "$shard" ] && sleep 0.1 && kill -KILL "$shard" 2>/dev/null && killed=yes
    fi
    sleep 0.02
done
wait $runner || { cat hyperqueue.log; exit 1; }
grep -q "shards \[2\] failed, attempt 1" hyperqueue.log || { cat hyperqueue.log; exit 1; }
same hyperqueue

mkdir bin
cp "$scripts/tests/stub_sbatch" bin/sbatch
PATH=$folder/bin:$PATH TOUCHDOWN=$touchdown "$scripts/slurm_sweep.sh" trade.toml 3 slurm --time=1:00
same slurm
