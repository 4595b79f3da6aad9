#!/bin/sh
# qvol-mpi: pictures of 1, 2, 3, 4 and 8 ranks are those of qvol splat, byte for byte; what is
# refused is refused once, by one rank, and nobody waits for it.
#
# All ranks run on this machine, as root or not, over shared memory; nothing is asked of a network
# but the loopback interface.
. tests/command/common
: "${BUILD:=build}"
RANKS="1 2 3 4 8"
HEAD=/usr/share/mricron/templates/ch2.nii.gz

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_plm=isolated                # no remote shell is looked for
export OMPI_MCA_btl=self,vader              # shared memory
export OMPI_MCA_btl_vader_single_copy_mechanism=none # needs rights that containers lack
export OMPI_MCA_rmaps_base_oversubscribe=1  # more ranks than processors
export OMPI_MCA_hwloc_base_binding_policy=none
export TMPDIR="$work"

check "mpirun and mpicc are installed" sh -c 'command -v mpirun && command -v mpicc'
check "qvol-mpi is built" make -s BUILD="$BUILD" mpi
[ $failures -eq 0 ] || finish
MPI=$(realpath "$BUILD/host/qvol-mpi")

on_ranks() { # on_ranks N ARGUMENT...: qvol-mpi, without the comments of mpirun
    n=$1
    shift
    timeout 60 mpirun -q -n "$n" "$MPI" "$@" </dev/null
}

# ---- What is linked --------------------------------------------------------------

needs_mpi() {
    ldd "$1" | grep -q libmpi
}
check "qvol-mpi needs MPI" needs_mpi "$MPI"
needs_mpi "$QVOL"
outcome $((1 - $?)) "qvol does not"
without_mpi() { # without_mpi STATUS TARGET: as where there is no mpicc
    status=0
    make -n MPICC=no-mpicc BUILD="$work/none" "$2" >"$work/out" 2>&1 || status=$?
    cat "$work/out"
    [ $status -eq "$1" ]
}
check "make needs no MPI" without_mpi 0 all
check "make without MPI leaves qvol-mpi out" sh -c '! grep -q "host/qvol-mpi" "$1"' - "$work/out"
asks_for_packages() {
    make -s MPICC=no-mpicc BUILD="$work/none" mpi 2>&1 | grep "libopenmpi-dev openmpi-bin"
}
check "make mpi without MPI names the packages" asks_for_packages

# ---- Sums ------------------------------------------------------------------------

builds_sums() {
    # shellcheck disable=SC2046
    OMPI_CC=$CC mpicc -std=c99 -Icore -Iport/host -Iport/mpi tests/device/mpi_sums.c \
        port/mpi/ranks.c port/host/error.c "$BUILD/host/libqvol.a" -pthread -o "$work/mpi_sums"
}
adds_sums() { # adds_sums N
    timeout 60 mpirun -q -n "$1" "$work/mpi_sums" >"$work/out" && cat "$work/out" &&
        [ "$(cat "$work/out")" = "sums of $1 ranks agree" ]
}
check "the program of sums compiles" builds_sums
for n in $RANKS; do
    check "sums of $n ranks, full ones as well" adds_sums "$n"
done

# ---- Pictures ----------------------------------------------------------------------

cd "$work" || exit 1
"$PYTHON" - <<'PY'
from volumes import *
write("in_23x19x17_uint8.raw", packed(blob((23, 19, 17))))
write("thin.tf", b"0 250 120 60 0\n60 250 120 60 0\n100 250 120 60 .05\n255 90 240 60 .3\n")
PY
makes() { # makes FILE OPTION...
    file=$1
    shift
    "$QVOL" freevoxel in_23x19x17_uint8.raw -o "$file" --tf ./thin.tf -q "$@"
}
check "a file in Hilbert's order" makes levels.qvf --order hilbert
check "a file of wide voxels without levels" makes wide.qvf --storage rgba16 --levels 0

shows_something() { # shows_something FILE: many different bytes
    [ "$(od -An -v -t u1 -w1 "$1" | sort -u | wc -l)" -ge 16 ]
}
same_pictures() { # same_pictures FILE OPTION...: the last is --output's value
    for last in "$@"; do :; done
    "$QVOL" splat "$@" || return 1
    mv "$last" expected
    shows_something expected || return 1
    for n in $RANKS; do
        on_ranks "$n" splat "$@" && cmp expected "$last" || return 1
    done
}
check "orthographic: pictures of $RANKS ranks" same_pictures levels.qvf --size 120x90 \
    --azimuth 30 --elevation 20 -o a.pam
check "perspective, from a file of wide voxels" same_pictures wide.qvf --size 64x48 \
    --azimuth 200 --perspective 50 -o a.pam
check "two lights and ambient light, linear kernel" same_pictures levels.qvf --size 80x70 \
    --light 40,20,ff8040 --light -90,60,2040ff --ambient 202020 --kernel linear -o a.pam
check "levels, over a transparent background, nearest directions" same_pictures levels.qvf \
    --size 40x40 --zoom .4 --levels --detail 2 --interpolation nearest --background transparent -o a.pam
check "a part of the voxels of level 1, for a display" same_pictures levels.qvf --size 50x40 \
    --level 1 --part 2/3 --zoom 2 --format bgra8888 -o a.raw
check "more ranks than voxels" same_pictures levels.qvf --size 50x40 --level 5 \
    --background 80ff40 --zoom 3 -o a.pam
on_ranks 3 splat levels.qvf --size 30x30 -o - >standard.pam
"$QVOL" splat levels.qvf --size 30x30 -o file.pam
check "a picture on standard output" cmp standard.pam file.pam

# Millions of voxels.
check "a head is installed" test -r $HEAD
check "a file of the head" "$QVOL" freevoxel $HEAD -o head.qvf --tf head --levels 0 -q \
    --directions +x,+x+y,+x+y+z
check "pictures of the head" same_pictures head.qvf --size 256x256 --azimuth 130 --elevation 20 \
    -o a.pam

# ---- Work ------------------------------------------------------------------------

# Each rank draws what is its part; what all have drawn is what qvol splat draws.
cat >work.py <<'PY'
import json, subprocess, sys
qvol, ranks = sys.argv[1], int(sys.argv[2])
def voxels(*options):
    command = [qvol, "splat", "levels.qvf", "--levels", "--size", "20x20", "-o", "part.pam", "--json"]
    report = json.loads(subprocess.run(command + list(options), check=True,
                                       stdout=subprocess.PIPE).stdout)
    return report["statistics"]["voxels_with_opacity"]
report = json.load(open("report.json"))
work = [rank["voxels_with_opacity"] for rank in report["ranks"]]
assert work == [voxels("--part", f"{k + 1}/{ranks}") for k in range(ranks)], work
assert sum(work) == report["statistics"]["voxels_with_opacity"] == voxels()
assert all(rank["seconds"] > 0 for rank in report["ranks"])
assert max(work) < 1.1 * sum(work) / ranks, work
print(work)
PY
for n in 1 4; do
    check "a report of $n ranks" on_ranks "$n" splat levels.qvf --levels --size 20x20 -o a.pam --json=report.json
    check "the work of $n ranks is their parts', and even" "$PYTHON" work.py "$QVOL" "$n"
done

# ---- What is refused -----------------------------------------------------------------

once() { # once NAME TEXT ARGUMENT...: rank 0 alone prints, and the text once
    test_name=$1 text=$2
    shift 2
    on_ranks 4 "$@" >"$work/.out" 2>"$work/.err"
    status=$?
    [ $status -eq 0 ] && [ ! -s "$work/.err" ] && [ "$(grep -c -e "$text" "$work/.out")" -eq 1 ]
    outcome $? "$test_name"
}
once "--help is printed once" "^Usage: qvol-mpi splat" --help
once "--help of splat too" "^Usage: qvol-mpi splat" splat --help
once "--version is printed once" "^qvol [0-9]" --version

rejects() { # rejects NAME STATUS PATTERN ARGUMENT...: 4 ranks, one line
    name=$1 status=$2 pattern=$3
    shift 3
    refuses "$name" "$status" "$pattern" mpirun -q -n 4 "$MPI" "$@"
}
head -c 5000 levels.qvf >short.qvf
head -c 5000 /dev/zero >zeros.qvf
rejects "no command" 2 "^qvol-mpi: command: none given, use splat"
rejects "a command that there is not" 2 "^qvol-mpi: render: unknown command" render levels.qvf -o a.pam
rejects "no file" 2 "operands: 0 given" splat -o a.pam
rejects "no output" 2 "^qvol-mpi splat: --output: is missing" splat levels.qvf
rejects "an unknown option" 2 "--threads: unknown" splat levels.qvf -o a.pam --threads 2
rejects "an order that ranks do not keep" 2 "--splatting: over needs all voxels in one order" \
    splat levels.qvf -o a.pam --splatting over
rejects "too many parts" 2 "--part: 4294967295 parts for 4 ranks" splat levels.qvf -o a.pam \
    --part 1/4294967295
rejects "a level that there is not" 2 "--level: 1, wide.qvf has 0" splat wide.qvf -o a.pam --level 1
rejects "a file that there is not" 1 "none.qvf: No such file" splat none.qvf -o a.pam
rejects "a truncated file" 1 "short.qvf: total bytes" splat short.qvf -o a.pam
rejects "a foreign file" 1 "zeros.qvf: format: no FreeVoxel file" splat zeros.qvf -o a.pam
rejects "a picture that cannot be written: rank 0 fails alone, at the end" 1 "nowhere/a.pam: No such" \
    splat levels.qvf -o nowhere/a.pam
rejects "a report that cannot be written" 1 "nowhere/a.json: No such" splat levels.qvf -o b.pam \
    --json=nowhere/a.json
check "without its report there is no picture, nor what was begun" sh -c '! ls b.pam qvol-*.tmp'

refuses "a file that rank 0 cannot read" 1 "none.qvf: No such file or directory$" \
    mpirun -q -n 1 "$MPI" splat none.qvf -o c.pam : -n 3 "$MPI" splat levels.qvf -o c.pam
apart() { # apart NAME STATUS PATTERN ARGUMENT...: what ranks 2 and 3 have been given
    name=$1 status=$2 pattern=$3
    shift 3
    refuses "$name" "$status" "$pattern" mpirun -q -n 2 "$MPI" splat levels.qvf -o c.pam \
        : -n 2 "$MPI" "$@"
}
apart "a file that some ranks cannot read" 1 "none.qvf: No such file or directory (rank 2)$" \
    splat none.qvf -o c.pam
apart "a file that is damaged for some ranks" 1 "short.qvf: total bytes: .*(rank 2)$" \
    splat short.qvf -o c.pam
apart "an option that some ranks refuse" 2 "--zoom: .*(rank 2)$" splat levels.qvf -o c.pam --zoom 0
apart "another file on some ranks" 1 "wide.qvf: checksum: is not that of .* rank 0 (rank 2)$" \
    splat wide.qvf -o c.pam
apart "another size on some ranks" 2 "--size: is not that of rank 0 .*(rank 2)$" \
    splat levels.qvf -o c.pam --size 20x30
check "none of these has written a picture" test ! -e c.pam
finish
