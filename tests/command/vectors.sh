#!/bin/sh
# qvol vectors: results of somebody else against the truth, and one vector explained.
. tests/command/common
VECTORS=$PWD/tests/vectors
cd "$work" || exit 1

against() { # against STAGE FILE [OPTION...]: compared with the vectors of this tree
    stage=$1 file=$2
    shift 2
    "$QVOL" vectors check "$stage" "$file" --from "$VECTORS" "$@"
}

# tells NAME STATUS LINE COMMAND...: the command ends with that status and prints that line alone.
tells() {
    test_name=$1 expected=$2 line=$3
    shift 3
    "$@" >.told 2>/dev/null
    status=$?
    [ $status -eq "$expected" ] && [ "$(cat .told)" = "$line" ]
    good=$?
    [ $good -eq 0 ] || sed "s/^/# status $status: /" .told >&2
    outcome $good "$test_name"
}

# ---- check ----------------------------------------------------------------------
status=0
for file in "$VECTORS"/*.csv; do
    against "$(basename "$file" .csv)" "$file" -q || status=1
done
outcome $status "every stage equals itself"
rows=$(($(wc -l <"$VECTORS/weights.csv") - 1))
cut -d, -f1,11 "$VECTORS/weights.csv" >column.csv
tells "one column of all rows" 0 "weights: $rows of $rows rows, 1 columns: equal" against weights column.csv
sed -n '1p;30,34p' column.csv | sed 's/$/\r/' >some.csv
tells "some rows, with carriage returns" 0 "weights: 5 of $rows rows, 1 columns: equal" against weights some.csv
cat >named.csv <<'END'
w1,id,f0
0x7FFF,weights-00077,0x81
32767,weights-00077,129
END
head -n 2 named.csv >hex.csv
tells "columns in any order, hexadecimal" 0 "weights: 1 of $rows rows, 2 columns: equal" against weights hex.csv
printf 'id,w0,w1\nweights-00077,32258,32767\nweights-00078,1,2\nweights-00079,3,4\n' >wrong.csv
tells "the first field that differs" 1 "weights-00078: w0: expected 508, found 1" against weights wrong.csv
tells "standard input" 1 "weights-00078: w0: expected 508, found 1" against weights - <wrong.csv
tells "-q prints nothing" 1 "" against weights wrong.csv -q
against weights wrong.csv --json >report.json
check "--json" "$PYTHON" -c '
import json
r = json.load(open("report.json"))
assert r["equal"] is False and r["stage"] == "weights" and r["rows"] == 3 and r["columns"] == 2
assert r["first"] == {"id": "weights-00078", "field": "w0", "expected": "508", "found": "1"}'
printf 'id,scaled\nscale-00001,-0\n' >minus.csv
tells "-0 is 0" 0 "scale: 1 of $(($(wc -l <"$VECTORS/scale.csv") - 1)) rows, 1 columns: equal" against scale minus.csv
printf 'id,w0\nweights-00077,-32258\n' >sign.csv
tells "a sign too many differs" 1 "weights-00077: w0: expected 32258, found -32258" against weights sign.csv

broken() { # broken NAME PATTERN TEXT: results that are refused
    printf '%b' "$3" >broken.csv
    refuses "$1" 1 "broken.csv: $2" "$QVOL" vectors check weights broken.csv --from "$VECTORS"
}
broken "no id" "line 1: no column id" 'w0,w1\n1,2\n'
broken "a column that there is not" "w8: no column of the stage weights" 'id,w8\nweights-00000,0\n'
broken "a column twice" "w0: two columns" 'id,w0,w0\nweights-00000,65536,65536\n'
broken "an id that there is not" "id: line 2: 'weights-99999' is no row" 'id,w0\nweights-99999,0\n'
broken "an id with fewer digits" "id: line 2: 'weights-77' is no row" 'id,w0\nweights-77,0\n'
broken "an id of another stage" "id: line 2: 'under-00000' is no row" 'id,w0\nunder-00000,0\n'
broken "an id twice" "id: line 3: .* twice" 'id,w0\nweights-00000,65536\nweights-00000,65536\n'
broken "no number" "w0: line 2: 'x' is no whole number" 'id,w0\nweights-00000,x\n'
broken "an empty cell" "w0: line 2: '' is no whole number" 'id,w0\nweights-00000,\n'
broken "a blank before a number" "w0: line 2: ' 1' is no" 'id,w0\nweights-00000, 1\n'
broken "a fraction" "w0: line 2: '1.5' is no" 'id,w0\nweights-00000,1.5\n'
broken "65 bits" "w0: line 2: '18446744073709551616' is no" 'id,w0\nweights-00000,18446744073709551616\n'
broken "a cell too few" "line 3: 1 cells, not 2" 'id,w0\nweights-00000,65536\nweights-00001\n'
broken "a cell too many" "line 2: 3 cells, not 2" 'id,w0\nweights-00000,65536,1\n'
broken "no rows" "no rows" 'id,w0\n'
broken "nothing but ids" "no column beside id" 'id\nweights-00000\n'
broken "nothing" "line 1: no column id" ''
broken "a null byte" "holds a null byte" 'id,w0\nweights-00000,\0000\n'
refuses "no file" 1 "nowhere.csv: No such file" "$QVOL" vectors check weights nowhere.csv --from "$VECTORS"
refuses "an unknown stage" 2 "stage: 'weight' is none of .*fields.tsv" "$QVOL" vectors check weight some.csv --from "$VECTORS"
refuses "a stage that is a path" 2 "stage: '../vectors/weights' is none of" "$QVOL" vectors check ../vectors/weights some.csv --from "$VECTORS"
refuses "an empty folder" 1 "fields.tsv: No such file" "$QVOL" vectors check weights some.csv --from .
refuses "neither check nor show" 2 "vectors: needs check or show" "$QVOL" vectors
refuses "another word" 2 "vectors: needs check or show" "$QVOL" vectors list
mkdir other
printf 'a\tb\n1\t2\n' >other/fields.tsv
refuses "another fields.tsv" 1 "fields.tsv: line 1: not the columns" "$QVOL" vectors check weights some.csv --from other
cp "$VECTORS/fields.tsv" other
cut -d, -f1-5 "$VECTORS/weights.csv" | sed 's/f1/g1/' >other/weights.csv
refuses "a stage with other columns" 1 "weights.csv: line 1: not the columns" "$QVOL" vectors check weights some.csv --from other

# ---- show -----------------------------------------------------------------------
"$QVOL" vectors show weights-00077 --from "$VECTORS" >shown
check "the section and the flags" grep -qFx 'weights-00077: tests/SPEC.md, section 11; edge' shown
check "an input in its format" grep -q '^in  f0 *= 129  (u8.8: 0.50390625)$' shown
check "a formula" grep -q '^out w1 *= 256 f0 + xyz - xy - xz$' shown
check "the formula with numbers" grep -q '^ *= 256 \* 129 + 1 - 129 - 129$' shown
check "its result" grep -q '^ *= 32767  (u17.16: 0.499984741)$' shown
status=0
for file in "$VECTORS"/*.csv; do
    "$QVOL" vectors show "$(basename "$file" .csv)-00000" --from "$VECTORS" >shown || status=1
done
outcome $status "a row of every stage"
"$QVOL" vectors show sample8-00000 --from "$VECTORS" >shown
check "prose stays" test "$(grep -A1 '^out skipped' shown | tail -n 1 | tr -s ' ')" = " = 1 (u1)"
"$QVOL" vectors show hits-00003 --from "$VECTORS" >shown
check "a name behind a word is no factor" grep -Eq '^ *= [0-9]+ mod [0-9]+$' shown
refuses "a number too high" 2 "id: 'weights-99999' is none of the $rows rows" "$QVOL" vectors show weights-99999 --from "$VECTORS"
refuses "no number" 2 "id: 'weights' is no id" "$QVOL" vectors show weights --from "$VECTORS"
refuses "an id of no stage" 2 "stage: 'some' is none of" "$QVOL" vectors show some-00000 --from "$VECTORS"
finish
