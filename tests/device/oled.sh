#!/bin/sh
# The head on the OLED of the emulated Cortex-M3: the device's checksum, the
# pixels of the screenshot and the bytes of the host are the same.
set -eu
. tests/tap
build=${BUILD:-build}
out=$build/cortex-m3

same_checksum() {
    device=$(sed -n 's/^checksum //p' "$work/console")
    host=$(sed -n 's/.*"crc32": "\(.*\)".*/\1/p' "$out/oled.json")
    echo "device ${device:-none}, host ${host:-none}"
    [ -n "$device" ] && [ "$device" = "$host" ]
}

# Every pixel of the panel is a square of the same grey in the screenshot.
same_pixels() {
    /usr/bin/python3 - "$work/oled.png" "$out/oled.raw" <<'END'
import sys
from PIL import Image

WIDTH, HEIGHT, GREYS = 128, 64, 16
picture = Image.open(sys.argv[1]).convert("RGB")
packed = open(sys.argv[2], "rb").read()
scale = picture.width // WIDTH
if picture.size != (WIDTH * scale, HEIGHT * scale) or len(packed) != WIDTH * HEIGHT // 2:
    sys.exit(f"picture of {picture.size}, {len(packed)} bytes from the host")
wrong = lit = 0
for y in range(picture.height):
    for x in range(picture.width):
        pixel = y // scale * WIDTH + x // scale
        level = packed[pixel // 2] >> (4 if pixel % 2 == 0 else 0) & (GREYS - 1)
        grey = level * 255 // (GREYS - 1)
        wrong += picture.getpixel((x, y)) != (grey, grey, grey)
        lit += level > 0
share = lit / (picture.width * picture.height)
print(f"{wrong} pixels differ, {share:.2f} of the panel is lit")
sys.exit(wrong > 0 or share < 0.1)
END
}

reports_figures() {
    grep -q '^instructions [1-9]' "$work/console" && grep -q '^stack [1-9]' "$work/console"
}

check "firmware builds" make -s TARGET=cortex-m3 BUILD="$build" "$out/head.elf"
check "screenshot" sh -c "toolchain/screenshot cortex-m3 '$out/head.elf' '$work/oled.png' \
    >'$work/console'"
check "checksum of the device and of the host" same_checksum
check "pixels of the panel and bytes of the host" same_pixels
check "instructions and stack are reported" reports_figures
check "firmware ends when it is told to" toolchain/emulate cortex-m3 "$out/head.elf" exit
sed -n 's/^\(instructions\|stack\)/# head on the OLED: \1/p' "$work/console"
finish
