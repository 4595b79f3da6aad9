#!/bin/sh
# `make picture`, the one command from a clone to a picture on an emulated board: it has dark and
# bright places, in colour.
set -eu
. tests/tap
build=${BUILD:-build}

shows_something() {
    /usr/bin/python3 - "$build/picture.png" <<'END'
import sys
from PIL import Image, ImageStat

picture = Image.open(sys.argv[1]).convert("RGB")
deviation = ImageStat.Stat(picture).stddev
colours = len(picture.getcolors(picture.width * picture.height))
print(f"{picture.width}x{picture.height}, {colours} colours, deviation {deviation}")
sys.exit(picture.size != (320, 240) or colours < 1000 or min(deviation) < 20)
END
}

rm -f "$build/picture.png"
check "make picture" make -s BUILD="$build" picture
check "the panel shows something" shows_something
finish
