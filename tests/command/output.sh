#!/bin/sh
# Outputs appear whole or not at all.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" "$TESTS/volumes.py" in_12x10x8_uint8.raw
IN=in_12x10x8_uint8.raw
SMALL="--size 8x8"

for kind in png pam raw; do
    # shellcheck disable=SC2086
    refuses "full disk: $kind" 1 "/dev/full: No space left" "$QVOL" render $IN $SMALL -o /dev/full --as $kind
done
refuses "full disk: classify" 1 "/dev/full: No space left" "$QVOL" classify $IN -o /dev/full
# shellcheck disable=SC2086
refuses "full disk: report" 1 "/dev/full: No space left" "$QVOL" render $IN $SMALL -o a.png --json=/dev/full
check "then the picture is not there either" test ! -e a.png
for command in "--help" "--version" "render --help" "info $IN" "info $IN --json" "render $IN $SMALL -o -" \
    "classify $IN --storage rgba8 -o -"; do
    # shellcheck disable=SC2086
    "$QVOL" $command >/dev/full 2>.err
    status=$?
    [ $status -eq 1 ] && [ "$(wc -l <.err)" -eq 1 ] && grep -q "No space left" .err
    outcome $? "full disk behind standard output: $command"
done

# What fills up in the middle: a limit on the size of files, in blocks of 512.
(
    ulimit -f 8
    "$QVOL" render $IN --size 200x200 -o big.raw
) >said.out 2>said.err
status=$?
check "a file that cannot grow: status 1" test $status -eq 1
check "a file that cannot grow: one line" test "$(wc -l <said.err)" -eq 1
check "a file that cannot grow: nothing is left" sh -c '! ls | grep -e "^big.raw" -e "\.tmp$"'

refuses "no such folder" 1 "nowhere/a.png: No such file" "$QVOL" render $IN -o nowhere/a.png
mkdir folder.png
refuses "a folder as output" 1 "directory" "$QVOL" render $IN -o folder.png

if [ "$(id -u)" -eq 0 ]; then
    as_user="setpriv --reuid=65534 --regid=65534 --clear-groups"
else
    as_user=
fi
chmod 755 "$work"
mkdir closed
chmod 555 closed
cp $IN secret_12x10x8_uint8.raw
chmod 000 secret_12x10x8_uint8.raw
# shellcheck disable=SC2086
refuses "an unreadable input" 1 "secret_12x10x8_uint8.raw: Permission denied" \
    $as_user "$QVOL" info secret_12x10x8_uint8.raw
# shellcheck disable=SC2086
refuses "a folder that may not be written" 1 "closed/a.png: Permission denied" \
    $as_user "$QVOL" render $IN $SMALL -o closed/a.png

# The output may be the input; an interrupted run leaves the old file.
cp $IN same_12x10x8_uint8.raw
check "output over the input" "$QVOL" render same_12x10x8_uint8.raw -o same_12x10x8_uint8.raw --size 8x8
check "it holds the picture" test "$(wc -c <same_12x10x8_uint8.raw)" -eq 192
echo before >kept.raw
"$QVOL" render $IN -o kept.raw --size 8x8 --json=report.json &&
    check "an old file is replaced" test "$(wc -c <kept.raw)" -eq 192
# Names of files have at most 255 characters.
long=$(printf '%0250d' 0 | tr 0 x)
check "a name of 254 characters" "$QVOL" render $IN -o "$long.raw" --size 8x8
check "it is there" test "$(wc -c <"$long.raw")" -eq 192
mkdir deep
check "in a folder, with a report" "$QVOL" render $IN -o "deep/$long.raw" --size 8x8 --json="deep/$long.js"
check "both are there and nothing else" test "$(find deep -type f | wc -l)" -eq 2
refuses "a name of 256 characters" 1 "File name too long" \
    "$QVOL" render $IN -o "${long}xx.raw" --size 8x8 --json=early.json
check "no report is left" test ! -e early.json
# Links stay links, standard output by another name is not replaced.
mkdir behind
echo before >behind/real.pam
ln -s behind/real.pam link.pam
"$QVOL" render $IN -o link.pam --size 8x8
check "a link stays a link" test -h link.pam
check "what it leads to is replaced" grep -q P7 behind/real.pam
ln -s /proc/self/fd/1 stdout.pam
"$QVOL" render $IN -o stdout.pam --size 8x8 >redirected.pam
check "a link to standard output stays" test -h stdout.pam
check "the picture is where standard output leads" cmp redirected.pam behind/real.pam
touch private.raw
chmod 600 private.raw
"$QVOL" render $IN -o private.raw --size 8x8
check "a file that is replaced keeps its permissions" test "$(stat -c %a private.raw)" = 600

# A standard stream that is closed is no place for a report.
"$QVOL" render $IN -o shut.pam --size 8x8 --json >&- 2>shut.err
check "a closed standard output is an error" test $? -eq 1
check "in one line" test "$(wc -l <shut.err)" -eq 1
check "and leaves no picture" test ! -e shut.pam

# A reader that has seen enough.
mkdir piped
(
    cd piped || exit 1
    TMPDIR=$PWD
    export TMPDIR
    "$QVOL" render - --dims 12x10x8 --type u8 -o a.pam --size 200x200 --json <../$IN | true
    "$QVOL" render - --dims 12x10x8 --type u8 -o - --size 900x900 <../$IN | head -c 1 >one
)
check "a pipe that breaks leaves no temporary file" sh -c '! ls piped | grep -v -x -e one -e a.pam'

umask 027
"$QVOL" render $IN -o mode.raw --size 8x8
check "files get the usual permissions" test "$(stat -c %a mode.raw)" = 640
echo before >kept.raw
"$QVOL" render $IN -o kept.raw --size 3000x3000 --step 0.0625 --termination 0 --tf fog --threads 1 2>interrupted.err &
pid=$!
sleep 0.3
kill -TERM $pid 2>/dev/null
wait $pid
status=$?
check "an interrupted run ends by its signal" test $status -eq 143
check "and leaves the old file" grep -q before kept.raw
check "and no other" sh -c '! ls | grep "\.tmp$"'
mkfifo held
sh -c 'trap "" HUP; exec "$@"' - "$QVOL" info held >said.out 2>said.err &
pid=$!
exec 3>held
cat $IN >&3
sleep 0.3
kill -HUP $pid
exec 3>&-
wait $pid
check "a signal that was ignored stays so" test $? -eq 1
mkdir spool
mkfifo fifo
TMPDIR=$work/spool "$QVOL" info fifo 2>interrupted.err &
pid=$!
exec 3>fifo
cat $IN >&3
sleep 0.3
check "a pipe is copied while it is read" sh -c 'ls spool | grep -q qvol-input'
kill -TERM $pid
wait $pid
exec 3>&-
check "an interrupted run removes its copy of a pipe" sh -c '! ls spool | grep .'
check "progress is silent where standard error is no terminal" sh -c \
    '"$1" render "$2" -o a.raw --size 8x8 2>&1 | grep -c . | grep -qx 0' - "$QVOL" $IN
if command -v script >/dev/null; then
    script -qec "$QVOL render $IN -o a.raw --size 64x64" /dev/null >typescript 2>&1
    check "progress shows on a terminal" grep -q "rendering 100 %" typescript
    script -qec "$QVOL render $IN -o a.raw -q --size 64x64" /dev/null >typescript 2>&1
    check "-q silences it" sh -c '! grep -q rendering typescript'
else
    outcome 1 "progress on a terminal: no program 'script'"
fi
finish
