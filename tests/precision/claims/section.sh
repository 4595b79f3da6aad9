#!/bin/sh
# section.sh FOLDER: section 4, the papers' claims. The papers' programs compute them anew; every
# line of claims.txt becomes a row of the table, and of FOLDER/claims.csv.
set -eu
: "${BUILD:=build}"
OUT=$1/claims
CLAIMS=tests/precision/claims/claims.txt

# Every test that is named is there, and every line of it that is to assert something.
awk -F'|' '/^[WKAF][|]/ { sub(/: .*/, "", $7); print $7 }' $CLAIMS | tr -d ' ' | tr ',' '\n' | sort -u |
    while read -r test; do
        [ -e "tests/$test.c" ] || [ -e "tests/$test.sh" ] || {
            echo "claims.txt: there is no test $test" >&2
            exit 1
        }
    done

has_line() { # has_line TEST LINE: of the test's own source, or of its folder of programs
    cat "tests/$1.c" "tests/$1.sh" "tests/${1##*/}"/*.c 2>/dev/null |
        grep -qF -e "cmocka_unit_test($2)" -e "\"$2"
}
awk -F'|' '$5 ~ /^asserted: / { print $7 }' $CLAIMS |
    while read -r asserted; do
        has_line "${asserted%%: *}" "${asserted#*: }" || {
            echo "claims.txt: there is no line $asserted" >&2
            exit 1
        }
    done

compute() { # compute PAPER [OPTION]
    mkdir -p "$OUT/$1/data"
    "$BUILD/tests/papers/$1" "$OUT/$1" ${2:+"$2"}
}
compute wittenbrink
compute kraus
compute dithering
compute freevoxels numbers

cat <<'END'
## 4 Claims

Every number that the four papers state and that can be computed, in the order of the papers: the
paper's number, the same in double precision, by the library's integers, the difference of the
two, what is allowed, and the tests that fail beyond it (`tests/`; this table is held by
`static/precision`, too). Where a paper states none, a dash stands for it. **WRONG** are claims that
double precision does not confirm, **NOT REPRODUCED** those whose technique or data are not ours or
are not told: both numbers are shown, and nothing is allowed or forbidden. Where a test is named with
a line of its, this line asserts what the row says. W: Wittenbrink, Malzbender, Goss 1998; K: Kraus and Buerger
2008; A: Williams, Frank, LaMar, alpha dithering; F: FreeVoxels. Opacity, light and extinction are
in parts of 1, all of A and what says so in levels of 255. Section 9 asks questions: its double
precision is what programs apart from this library found to be attainable.

| paper | claim | paper's number | double precision | ours | error | allowed | test | remark |
|---|---|---|---|---|---|---|---|---|
END
awk -F' *[|] *' -v csv="$1/claims.csv" '
    function row_of(paper, name) { return paper SUBSEP name }
    function keep(name, exact, ours, error, allowed) { # the first of a name
        key = row_of(paper, name)
        if (key in found) return
        found[key] = ours; exact_of[key] = exact; error_of[key] = error; allowed_of[key] = allowed
    }
    function number(value) { return sprintf("%.6g", value) }
    function off(value) { return value < 5e-10 && value > -5e-10 ? 0 : sprintf("%.2g", value) }
    function fail(text) { print "claims.txt: " text >"/dev/stderr"; failed = 1; exit 1 }
    FNR == 1 {
        n = split(FILENAME, part, "/")
        paper = toupper(substr(part[n - 1], 1, 1))
        if (paper == "D") paper = "A"
        if (FILENAME ~ /claims.txt$/) {
            FS = "|"
            $0 = $0
            print "bound,worst,exact,ours,paper,claim" >csv
        }
    }
    FILENAME !~ /claims.txt$/ {
        if (NF == 8 && $4 + 0 == $4) keep($2, $4, $5, $6, $7)
        if (NF == 5 && $3 + 0 == $3) {
            keep("left " $2, $3, $3, 0, 0)
            keep("right " $2, $4, $4, 0, 0)
        }
        if (NF == 6 && $5 + 0 == $5) keep($2 ": " $3, $5, $5, 0, 0)
        if (NF == 10 && $2 + 0 == $2) {
            split("plain ordered random ours wide", column, " ")
            for (c = 1; c <= 5; c++) {
                split($(c + 4), worst, " ")
                keep("worst " $2 " " column[c], 0, worst[1] < 0 ? -worst[1] : worst[1], 0, 0)
            }
        }
        next
    }
    /^#/ || NF != 8 { if (NF > 1 && !/^#/) fail("a line is not of 8 fields: " $0); next }
    { sub(/^WRONG/, "**WRONG**", $8); sub(/^NOT REPRODUCED/, "**NOT REPRODUCED**", $8) }
    $5 ~ /^asserted: / {
        printf "| %s | %s | %s | %s | %s | - | - | %s | %s |\n", $1, $2, $3, $4,
            substr($5, length("asserted: ") + 1), $7, $8
        next
    }
    {
        key = row_of($1, $5)
        if (!(key in found)) fail("there is no row \"" $5 "\" of " $1)
        if ($6 == "-") {
            printf "| %s | %s | %s | %s | %s | %s | - | %s | %s |\n", $1, $2, $3, $4,
                number(found[key]), $4 == "-" ? "-" : off(found[key] - $4), $7, $8
            next
        }
        exact = $4 == "=" ? exact_of[key] : $4
        allowed = $6 == "=" ? allowed_of[key] : $6
        error = $4 == "=" ? error_of[key] : found[key] - exact
        printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", $1, $2, $3, number(exact),
            number(found[key]), off(error), allowed + 0, $7, $8
        printf "%s,%s,%s,%s,%s,\"%s\"\n", allowed + 0, off(error < 0 ? -error : error), exact,
            found[key], $1, $2 >csv
    }
    END { exit failed }' "$OUT/wittenbrink/table.md" "$OUT/kraus/table.md" "$OUT/dithering/table.md" \
    "$OUT/dithering/numbers.txt" "$OUT/freevoxels/table.md" $CLAIMS
