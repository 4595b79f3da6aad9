#!/bin/sh
# NIfTI and NRRD volumes stored along any axes show the same head.
. tests/command/common
cd "$work" || exit 1
cat >make.py <<'END'
from itertools import permutations, product
from volumes import *
values = blob()
write("in_12x10x8_uint8.raw", packed(values))
spacing = (1.0, 1.5, 2.0)  # of the world's axes
for axis in permutations(range(3)):
    for flips in product((False, True), repeat=3):
        stored, size = turned(values, SIZE, axis, flips)
        rows = [[0.0] * 4 for _ in range(3)]
        steps = [0] * 3
        for world in range(3):
            rows[world][axis[world]] = -spacing[world] if flips[world] else spacing[world]
            steps[axis[world]] = spacing[world]
        name = "".join(map(str, axis)) + "".join("-" if f else "+" for f in flips)
        write(f"s{name}.nii", nifti(stored, size, sform=rows, spacing=steps))
        columns = [[rows[w][a] for w in range(3)] for a in range(3)]
        text = " ".join("(" + ",".join(map(str, c)) + ")" for c in columns)
        write(f"n{name}.nrrd", *nrrd(stored, size, extra=["space: RAS", f"space directions: {text}"]))
        lps = " ".join(f"({-c[0]},{-c[1]},{c[2]})" for c in columns)
        write(f"l{name}.nrrd", *nrrd(stored, size, extra=[
            "space: left-posterior-superior", f"space directions: {lps}"]))
# 17 degrees about z: the nearest axes are still x and y.
c, s = math.cos(math.radians(17)), math.sin(math.radians(17))
write("oblique.nii", nifti(values, sform=[[c, -1.5 * s, 0, 0], [s, 1.5 * c, 0, 0], [0, 0, 2, 0]],
                           spacing=spacing))
# qform: half a turn about z (b = c = 0, d = 1) is LPS.
stored, size = turned(values, SIZE, (0, 1, 2), (True, True, False))
write("qform.nii", nifti(stored, size, qform=(0, 0, 1, 0, 0, 0), spacing=spacing))
write("both.nii", nifti(values, qform=(0, 0, 1, 0, 0, 0), spacing=spacing,
                        sform=[[1, 0, 0, 0], [0, 1.5, 0, 0], [0, 0, 2, 0]]))
write("none.nii", nifti(values, spacing=spacing))
write("spacings.nrrd", *nrrd(values, extra=["spacings: 1 1.5 2"]))
write("metres.nii", nifti(values, spacing=(.001, .0015, .002)))
END
check "volumes are made" "$PYTHON" make.py
VIEW="--size 40x30 --tf surface --azimuth 30 --elevation 20"
# shellcheck disable=SC2086
"$QVOL" render in_12x10x8_uint8.raw --spacing 1x1.5x2 -o base.pam $VIEW
for file in s*.nii n*.nrrd l*.nrrd oblique.nii qform.nii both.nii none.nii spacings.nrrd metres.nii; do
    rm -f a.pam
    # shellcheck disable=SC2086
    "$QVOL" render "$file" -o a.pam $VIEW
    cmp -s base.pam a.pam
    outcome $? "$file"
done
"$QVOL" info s210-+-.nii >info.txt
check "info names the axes as stored" grep -q '^orientation  IAL$' info.txt
"$QVOL" info none.nii >info.txt
check "info tells where nothing is known" grep -q '^orientation  unknown$' info.txt
finish
