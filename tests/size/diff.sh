#!/bin/sh
# Sizes beside those of another revision, built in a working tree of its own:
#
#     tests/size/diff.sh REVISION TARGET...
#
# Prints a line for each program whose flash, context, scratch or stack differ: what it is
# now, and by how much it has changed.
set -eu
if [ $# -lt 2 ] || [ -z "$1" ]; then
    echo "usage: make size-diff REV=REVISION" >&2
    exit 2
fi
revision=$1
shift
build=${BUILD:-build}
tree=$build/size-diff/tree
work=$(mktemp -d)
remove() {
    rm -rf "$work"
    git worktree remove --force "$tree" 2>/dev/null || :
}
trap remove EXIT

rm -rf "$tree"
git worktree prune
git worktree add --quiet --detach "$tree" "$revision"
if [ ! -f "$tree/tests/size/sizes.sh" ]; then
    echo "size-diff: $revision is older than these measurements" >&2
    exit 2
fi

BUILD=$build tests/size/sizes.sh lines "$@" >"$work/now"
for target; do
    [ ! -f "$tree/toolchain/$target.mk" ] ||
        (cd "$tree" && BUILD=../build tests/size/sizes.sh lines "$target") >>"$work/then"
done

awk '
    function change(now, before) {
        return now == before ? now : sprintf("%s (%+d)", now, now - before)
    }
    { program = $1 " " $2; flash = $3 + $4; ram = $5 + $6 }
    NR == FNR { was[program] = flash " " ram " " $7 " " $8 " " $9; next }
    !(program in was) { print program ": new"; next }
    was[program] != flash " " ram " " $7 " " $8 " " $9 {
        split(was[program], old)
        printf "%s: flash %s, RAM %s, context %s, scratch %s, stack %s\n", program,
            change(flash, old[1]), change(ram, old[2]), change($7, old[3]), change($8, old[4]),
            change($9, old[5])
        differ = 1
    }
    END { if (!differ) print "no program differs" }' "$work/then" "$work/now"
