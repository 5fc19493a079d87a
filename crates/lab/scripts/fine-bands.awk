# Landings in order of speed at each point (cross-slope, roll, speed, outcome) to bands.
BEGIN { FS = OFS = ","; print "cross_slope_deg,roll_deg,from_fps,to_fps,outcome" }
{
    class = $4 ~ /^(stable|time)/ ? "stable" : $4 ~ /^bottomed/ ? "bottomed" : $4 ~ /^unstable/ ? "unstable" : "failure"
    here = $1 OFS $2
    if (NR > 1 && (here != point || class != before)) print point, from, to, before
    if (here != point || class != before) from = $3 + 0
    point = here; before = class; to = $3 + 0
}
END { print point, from, to, before }
