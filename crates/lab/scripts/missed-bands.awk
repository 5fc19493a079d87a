# Bands of a search, then bands of a fine scan of the same points: which of these have no like one to
# meet in the search. Tables begin with the axes; then come, with or without a number, the bands.
BEGIN { FS = "," }
FNR == 1 {
    file++
    for (column = NF; column > 0; column--) {
        if ($column == "from_fps") from = column
        if ($column == "outcome") outcome = column
    }
    axes = from - 1 - ($(from - 1) == "band")
    split($0, heading)
    next
}
{
    place = ""
    for (column = 1; column <= axes; column++) place = place heading[column] " " $column ", "
}
file == 1 { n[place]++; low[place, n[place]] = $from; high[place, n[place]] = $(from + 1); kind[place, n[place]] = $outcome; next }
{
    bands++; met = 0
    for (i = 1; i <= n[place]; i++)
        if (kind[place, i] == $outcome && low[place, i] <= $(from + 1) && high[place, i] >= $from) met = 1
    if (!met) { missed++; printf "missed: %s%s from %s to %s ft/s\n", place, $outcome, $from, $(from + 1) }
}
END { printf "%d of %d bands of the fine scan missed\n", missed, bands }
