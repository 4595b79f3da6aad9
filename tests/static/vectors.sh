#!/bin/sh
# The committed test vectors are what their generator writes, rows keep what they were declared to
# be under a version of the specification, and the manifest tells the truth.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"
folder=tests/vectors
generator=$BUILD/tests/vectors/from_library
fresh=$work/fresh
PYTHON=/usr/bin/python3

make -s BUILD="$BUILD" "$generator" >&2
mkdir "$fresh"

# As committed; `declared` and the text about them are not made.
equal() {
    diff -rq -x README.md -x '*.mk' -x '*.sh' -x declared -x 'from_*' "$1" "$2"
}

# What was promised: the first rows of each stage, under this version of the specification.
kept() { # kept FOLDER
    version=$(sed -n 's/^#define QV_SPECIFICATION  *\([0-9]*\)$/\1/p' core/qvol.h)
    grep -q "^$version " $folder/declared || return 1
    while read -r declared stage rows hash; do
        [ "$declared" = "$version" ] || continue
        [ "$(wc -l <"$1/$stage.csv")" -gt "$rows" ] || { echo "$stage: rows are gone" && return 1; }
        first=$(head -n $((rows + 1)) "$1/$stage.csv" | sha256sum | cut -d' ' -f1)
        [ "$first" = "$hash" ] ||
            { echo "$stage: rows changed without a new version" && return 1; }
    done <$folder/declared
}

declares_all() { # each stage with all of its rows
    for file in "$1"/*.csv; do
        stage=$(basename "$file" .csv)
        rows=$(($(wc -l <"$file") - 1))
        grep -q " $stage $rows $(sha256sum <"$file" | cut -d' ' -f1)$" $folder/declared ||
            { echo "$stage: declare it by make vectors" && return 1; }
    done
}

ids_count() { # row n of a stage is STAGE-n
    for file in "$1"/*.csv; do
        awk -F, -v stage="$(basename "$file" .csv)" \
            'NR > 1 && $1 != sprintf("%s-%05d", stage, NR - 2) { bad = 1 }
             END { exit bad }' "$file" ||
            { echo "$file: ids" && return 1; }
    done
}

headers_compile() {
    for file in "$1"/*.h; do
        printf '#include "%s"\nint main(void) { return sizeof qvol_%s_vectors == 0; }\n' \
            "$(cd "$(dirname "$file")" && pwd)/$(basename "$file")" "$(basename "$file" .h)" >"$work/use.c"
        "$CC" -std=c99 -pedantic -Wall -Wextra -Wconversion -Wsign-conversion -Wundef -Werror \
            -fsyntax-only "$work/use.c" || return 1
    done
}

cat >"$work/manifest.py" <<'END'
import csv, hashlib, json, os, re, sys
folder = sys.argv[1]
MINIMUM = str(-2 ** 63)
manifest = json.load(open(os.path.join(folder, "manifest.json")))
version = re.search(r"#define QV_SPECIFICATION\s+(\d+)", open("core/qvol.h").read()).group(1)
assert manifest["schema"] == "qvol-vectors-1" and manifest["spdx_license"] == "MIT"
assert manifest["specification"]["version"] == int(version)
names = [stage["stage"] for stage in manifest["stages"]]
assert sorted(names) == sorted(n[:-4] for n in os.listdir(folder) if n.endswith(".csv")), names
for stage in manifest["stages"]:
    for file in stage["files"]:
        data = open(os.path.join(folder, file["name"]), "rb").read()
        assert hashlib.sha256(data).hexdigest() == file["sha256"], file
    rows = list(csv.reader(open(os.path.join(folder, stage["stage"] + ".csv"))))
    assert stage["count"] == len(rows) - 1, stage["stage"]
    columns = []
    for field in stage["fields"]:
        n = field["columns"]
        columns += [(field["name"] + (str(i) if n > 1 else ""), field) for i in range(n)]
    assert rows[0] == ["id", "flags"] + [name for name, _ in columns], stage["stage"]
    digits = [(field["width"] + 3) // 4 for _, field in columns]
    lines = [l.strip() for l in open(os.path.join(folder, stage["stage"] + ".hex"))]
    hexes = [l for l in lines if l[:2] != "//"]
    assert len(hexes) == stage["count"]
    above = 4 * sum(digits)
    layout = [l.split() for l in lines if l[:4] == "// ["]
    assert len(layout) == len(columns), stage["stage"]
    for (_, bits, *rest), count, (name, field) in zip(layout, digits, columns):
        expected = "[%d:%d]" % (above - 1, above - 4 * count)
        assert [bits, *rest] == [expected, name, field["format"], field["role"]], name
        above -= 4 * count
    header = open(os.path.join(folder, stage["stage"] + ".h")).read().replace("INT64_MIN", MINIMUM)
    initialisers = [l for l in header.split("\n") if l[:5] == "    {"]
    assert len(initialisers) == stage["count"], stage["stage"]
    for row, text in zip(rows[1:], initialisers):
        values = re.findall(r"-?\d+", re.sub(r"U?INT64_C", "", text))
        assert values == row[2:], row[0]
    flags = dict.fromkeys(stage["coverage"], 0)
    for row, text in zip(rows[1:], hexes):
        for flag in row[1].split("+"):
            flags[flag] += 1
        parts = text.split("_")
        assert len(parts) == len(columns), row[0]
        for value, part, count, (name, field) in zip(row[2:], parts, digits, columns):
            v, w = int(value), field["width"]
            assert len(part) == count and int(part, 16) == v % 16 ** count, (row[0], name)
            low, high = (-(1 << w - 1), (1 << w - 1) - 1) if field["signed"] else (0, (1 << w) - 1)
            assert low <= v <= high, (row[0], name)
    assert flags == stage["coverage"], stage["stage"]
END

check "the generator runs" "$generator" "$fresh"
check "the committed vectors are what it writes" equal $folder "$fresh"
check "no row that was declared has changed or gone" kept "$fresh"
check "every row is declared" declares_all "$fresh"
check "ids count the rows" ids_count "$fresh"
check "the C headers compile" headers_compile "$fresh"
check "the manifest: hashes, counts, flags, widths; hex, its layout and C equal CSV" \
    "$PYTHON" "$work/manifest.py" "$fresh"
check "the committed vectors take at most 20 MB" \
    test "$(cat $folder/* 2>/dev/null | wc -c)" -le 20000000

# A change of one bit is found, and no new line hides it.
cp -r "$fresh" "$work/changed"
sed -i '5s/\([0-9]*\)$/\11/' "$work/changed/weights.csv"
status=0
! kept "$work/changed" >/dev/null || status=1
outcome $status "a changed bit fails until a new version is declared"

# A larger set begins with the same rows.
mkdir "$work/larger"
check "a larger set" "$generator" "$work/larger" 1200
status=0
for file in "$fresh"/*.csv; do
    head -n "$(wc -l <"$file")" "$work/larger/$(basename "$file")" | cmp - "$file" >&2 || status=1
done
outcome $status "a larger set begins with the committed rows"
for wrong in abc 0 -5 12x 100001 ''; do
    status=0
    "$generator" "$work/larger" "$wrong" 2>"$work/refused" && status=1
    grep -q "^vectors: VECTORS: $wrong: is no number of rows" "$work/refused" || status=1
    outcome $status "'$wrong' is refused as a number of rows"
done
check "it has more of them" test "$(wc -l <"$work/larger/over.csv")" -eq 1201
finish
