#!/bin/sh
# Reads of a frame by cache: a head through pages of each shape, as a device would read it from a
# card. Prints Markdown.
#
#     tests/bench/pages.sh [SCAN]
#
#     VIEW    options of the view, an oblique one unless set
set -eu
: "${QVOL:=build/host/qvol}"
: "${VIEW:=--azimuth 30 --elevation 20 --size 128x128}"
cd "$(dirname "$0")/../.."
scan=${1:-/usr/share/mricron/templates/ch2.nii.gz}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# figure NAME: of the last report.
figure() {
    sed -n "s/^ *\"$1\": \([0-9]*\),*\$/\1/p" "$work/report" | tail -n 1
}

# A cell: reads of the cache, bytes read as part of the volume's.
cell() { # cell PAGES PAGE
    # shellcheck disable=SC2086 # the view is several options
    "$QVOL" render "$scan" -o "$work/head.raw" --quiet --tf oled --storage indexed8 $VIEW \
        --cache "$1" --page "$2" --json="$work/report" 2>/dev/null || { printf ' - |' && return; }
    awk -v reads="$(figure reads)" -v bytes="$(figure file_bytes)" -v all="${bytes_of_volume:-1}" \
        'BEGIN { printf " %d, %.2f |", reads, bytes / all }'
}

# One page holds all of it.
cell 1 4096x4096x4096 >"$work/none"
bytes_of_volume=$(figure page_bytes)

echo "Reads of a frame, and bytes read as multiples of the volume's $bytes_of_volume, of" \
    "$(basename "$scan"), $VIEW:"
echo
echo "| cache | 4x4x4 | 8x8x8 | 16x16x16 | 32x8x8 |"
echo "|---|---|---|---|---|"
for kilobytes in 4 16 64 256 1024; do
    printf '| %d KB |' $kilobytes
    for page in 4x4x4 8x8x8 16x16x16 32x8x8; do
        cell $((kilobytes * 1024 / ($(echo $page | tr x '*')))) $page
    done
    echo
done
