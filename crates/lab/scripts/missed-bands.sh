#!/bin/sh
# How many bands the search misses: the level-vehicle grid scanned by 0.02 ft/s (178,893 landings, eight
# minutes of one core) to crates/lab/results/fine-bands.csv, against the sweep crates/lab/sweeps/level-grid.toml; and
# Figures 4-5 to 4-8, where struts bottom (87,570 landings, three minutes), against their sweeps.
# With --kept the fine scan of the level-vehicle grid is not computed again.
set -eu
cd "$(dirname "$0")/../../.."
cargo build --release --quiet
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
if [ "${1:-}" != --kept ]; then
    awk 'BEGIN {
        print "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,roll_deg,slope_deg,friction,pitch_deg,yaw_deg"
        for (c = 80; c <= 180; c += 10) for (r = -60; r <= 60; r += 10) for (i = 0; i <= 1250; i++)
            printf "%d,14,%.2f,%d,%d,15,1,0,0\n", ++n, 0.02 * i, c, r
    }' > "$work/cases.csv"
    target/release/touchdown land --vehicle sweeps/vehicles/surveyor-table-4-1.toml \
        --cases "$work/cases.csv" --out "$work/landings.csv"
    cut -d, -f3-5 "$work/cases.csv" | awk -F, -v OFS=, '{ print $2, $3, $1 }' |
        paste -d, - "$work/landings.csv" | tail -n +2 | cut -d, -f1-3,5 |
        awk -f crates/lab/scripts/fine-bands.awk > crates/lab/results/fine-bands.csv
fi
target/release/touchdown sweep crates/lab/sweeps/level-grid.toml --out "$work"
awk -f crates/lab/scripts/missed-bands.awk "$work/level-grid-bands.csv" crates/lab/results/fine-bands.csv

for figure in 05 06 07 08; do
    sweep=sweeps/figure-4-$figure.toml
    sed -e "s|\"vehicles/|\"$PWD/sweeps/vehicles/|; s/^scan_step_fps.*/scan_step_fps = 0.02/" \
        -e 's/^tolerance_fps.*/tolerance_fps = 0.02/; s/^scan = .*/scan = "full"\ncertainty = "none"/' \
        "$sweep" > "$work/fine-$figure.toml"
    target/release/touchdown sweep "$sweep" "$work/fine-$figure.toml" --out "$work" --quiet
    echo "$sweep"
    awk -f crates/lab/scripts/missed-bands.awk "$work/figure-4-$figure-bands.csv" "$work/fine-$figure-bands.csv"
done
