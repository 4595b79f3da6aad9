#!/bin/sh
# Branches of core and fixedpoint that the unit tests and the golden scenes take:
# at least 95 of 100.
#
# The library's inline functions count as well. Attributes are left out of the
# build, so that they stay functions: dissolved into each sampling mode they would
# have a branch for each constant argument, most of which no mode can take. A
# header's branch is covered when any file that includes it takes it, also a test.
set -eu
. tests/tap
LEAST=95

cat >"$work/gcc" <<'END'
#!/bin/sh
exec gcc '-D__attribute__(list)=' --coverage "$@"
END
chmod +x "$work/gcc"

# What the Makefile compiles to find packages would leave its notes here.
status=0
make -s BUILD="$work/build" CC="$work/gcc" OPTIMISE=-O0 WITHOUT="png nifti nrrd cmocka" \
    check >"$work/log" 2>&1 || status=1
outcome $status "unit tests and golden scenes pass while branches are counted"
[ $status -eq 0 ] || awk '/not ok|error/ { print "# " $0 }' "$work/log"

gcovr --root . --filter core/ --filter fixedpoint/ --branches "$work" \
    >"$work/report" 2>"$work/messages" || sed 's/^/# /' "$work/messages"
awk '/^(core|fixedpoint|TOTAL)/ { print "# " $0 }' "$work/report"
share=$(awk '$1 == "TOTAL" && $2 > 0 { printf "%d", 100 * $3 / $2 }' "$work/report")
status=0
[ "${share:-0}" -ge $LEAST ] || status=1
outcome $status "branches of core and fixedpoint: ${share:-0} of 100, at least $LEAST"
finish
