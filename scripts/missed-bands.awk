# Bands of a search, then bands of the fine scan: which of these have no like one to meet in the search.
BEGIN { FS = "," }
FNR == 1 { file++; next }
file == 1 { n[$1, $2]++; low[$1, $2, n[$1, $2]] = $4; high[$1, $2, n[$1, $2]] = $5; kind[$1, $2, n[$1, $2]] = $6; next }
{
    bands++; met = 0
    for (i = 1; i <= n[$1, $2]; i++)
        if (kind[$1, $2, i] == $5 && low[$1, $2, i] <= $4 && high[$1, $2, i] >= $3) met = 1
    if (!met) { missed++; printf "missed: cross-slope %s, roll %s: %s from %s to %s ft/s\n", $1, $2, $5, $3, $4 }
}
END { printf "%d of %d bands of the fine scan missed\n", missed, bands }
