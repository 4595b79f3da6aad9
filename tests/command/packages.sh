#!/bin/sh
# Built with no package: raw data to PAM and the device's bytes still work, the
# other formats name the package that they need.
. tests/command/common
plain=$work/build
# shellcheck disable=SC2031
check "builds without any package" make -s BUILD="$plain" WITHOUT="png nifti nrrd cmocka" OPTIMISE=-O1 \
    "$plain/host/qvol"
check "links nothing but the C library" sh -c \
    '! ldd "$1" | grep -v -e "linux-vdso" -e "ld-linux" -e "libc\.so" -e "libm\.so" | grep .' - "$plain/host/qvol"
full=$QVOL
QVOL=$plain/host/qvol
cd "$work" || exit 1
"$PYTHON" -c '
from volumes import *
write("in_12x10x8_uint8.raw", packed(blob()))
write("in.nii", nifti(blob()))
write("in.nii.gz", gzip.compress(nifti(blob())))
write("in.nrrd", *nrrd(blob()))'
IN=in_12x10x8_uint8.raw
for file in out.pam out.raw; do
    "$QVOL" render $IN -o $file --size 24x20 --tf surface
    "$full" render $IN -o full.${file#*.} --size 24x20 --tf surface
    check "raw to .${file#*.}" cmp $file full.${file#*.}
done
check "compare PAM" "$QVOL" compare out.pam full.pam
check "info of raw data" "$QVOL" info $IN
check "classify raw data" "$QVOL" classify $IN -o out.h
refuses "NIfTI names its package" 1 "NIfTI needs the package libnifti2-dev" "$QVOL" info in.nii
refuses "gzip NIfTI too" 1 "NIfTI needs the package libnifti2-dev" "$QVOL" info in.nii.gz
refuses "NRRD names its package" 1 "NRRD needs the package libteem-dev" "$QVOL" info in.nrrd
refuses "PNG names its package" 2 "PNG: needs the package libpng-dev" "$QVOL" render $IN -o out.png
refuses "--as png too" 2 "PNG: needs the package libpng-dev" "$QVOL" render $IN -o - --as png
"$full" render $IN -o in.png --size 8x8
refuses "PNG that is read" 1 "PNG needs the package libpng-dev" "$QVOL" compare in.png in.png
finish
