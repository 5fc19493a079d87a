#!/usr/bin/env bash
# A sweep on disks too small for it, of every size up to one that is large enough: each run ends with a
# clear error and leaves its journal or nothing; when the disk has grown it goes on, and its results are
# those of a run in peace, byte for byte.
#
#   scripts/tests/full_disk.sh [mount|limit]
#
# mount: the disks are file systems in memory, mounted where only this script sees them, without being
#   root. Some systems do not allow that;
# limit: then no file may grow beyond a limit instead, which works everywhere. The first that works is
#   taken, and told.
set -euo pipefail
cd "$(dirname "$0")/../.."
export touchdown=${TOUCHDOWN:-$PWD/target/release/touchdown}
apart=(unshare --map-root-user --mount)
way=${1:-mount}
if [ $# = 0 ] && ! "${apart[@]}" mount -t tmpfs none /mnt 2>/dev/null; then
    echo "full disks: this system lets nobody mount a disk of their own; files that may not grow instead"
    way=limit
fi
case $way in
mount) inside=("${apart[@]}") refusal="No space left on device" ;;
limit) inside=() refusal="File too large" ;;
*) echo "full disks: $way is neither mount nor limit" >&2 && exit 2 ;;
esac
export way refusal

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r sweeps/vehicles "$folder"
sed -e 's/step = 5/step = 10/' -e 's/from_fps = 0/from_fps = 8/' -e 's/to_fps = 25/to_fps = 14/' \
    sweeps/figure-4-09.toml >"$folder/full.toml"
cd "$folder"
"$touchdown" sweep full.toml --out peace --quiet

# Prints whether the disk was full; whatever else happens ends the script.
try='
    trap "echo \"full disks: at $1 kB this is not so: \$BASH_COMMAND\" >&2" ERR
    sweep() { "$touchdown" sweep full.toml --out disk/results --quiet; }
    rm -rf disk
    mkdir disk
    [ $way = limit ] || mount -t tmpfs -o size="$1"k none disk
    was=enough
    # With the signal ignored, a write beyond the limit is refused.
    ([ $way = mount ] || { trap "" XFSZ; ulimit -f "$1"; }; sweep 2>error) || {
        [ $? = 1 ]
        was=full
        grep -q "$refusal" error
        [ -z "$(ls -A disk/results | grep -v "^full.journal$")" ]
        [ $way = limit ] || mount -o remount,size=10m disk
        sweep 2>error
    }
    for name in full.csv full-bands.csv full.svg full.png; do
        cmp "peace/$name" "disk/results/$name" >&2
    done
    echo $was'
full=0
for size in $(seq 4 8 400); do
    was=$("${inside[@]}" bash -euo pipefail -c "$try" - "$size")
    [ "$was" = full ] || break
    full=$((full + 1))
done
[ "$was" = enough ] && [ $full -gt 0 ]
echo "full disks ($way): $full sizes below $size kB, each resumed to the same bytes"
