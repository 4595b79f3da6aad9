# From the headers of tests/vectors/*.hex to macros: for each column `STAGE_COLUMN, what to select
# of a row, and `STAGE_COLUMN_top, its uppermost bit; `STAGE_ROWS and `STAGE_BITS.
# // [247:240] f0 u8.8 in
FNR == 1 {
    stage = FILENAME
    sub(/.*\//, "", stage)
    sub(/\.hex$/, "", stage)
    stages[++count] = stage
}
/^\/\/ \[[0-9]+:[0-9]+\]/ {
    split(substr($2, 2), bits, /[:\]]/)
    printf "`define %s_%s %d -: %d\n", stage, $3, bits[1], bits[1] - bits[2] + 1
    printf "`define %s_%s_top %d\n", stage, $3, bits[1]
    if (!(stage in width)) width[stage] = bits[1] + 1
    if (bits[2] == 0) complete[stage] = 1
}
!/^\/\// { rows[stage]++ }
END {
    for (i = 1; i <= count; i++) {
        stage = stages[i]
        if (!complete[stage] || !rows[stage]) {
            print "layout.awk: no layout or no rows of " stage > "/dev/stderr"
            exit 1
        }
        printf "`define %s_ROWS %d\n`define %s_BITS %d\n", stage, rows[stage], stage, width[stage]
    }
}
