#!/bin/sh
# make demo's pictures: all there, of the right size, showing something, and the
# device's checksum equal to the host's.
set -u
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

if DEMO_OUT=$out toolchain/demo >"$out/messages" 2>&1; then
    echo "ok - the demo runs and the checksums are equal"
else
    cat "$out/messages" >&2
    echo "not ok - the demo runs and the checksums are equal"
    exit 1
fi

/usr/bin/python3 - "$out" <<'PYTHON'
import sys
from pathlib import Path

from PIL import Image, ImageStat

out = Path(sys.argv[1])
failed = False


def check(good, name):
    global failed
    failed = failed or not good
    print(("" if good else "not ") + "ok - " + name)


def shows_something(name, size, deviation):
    picture = Image.open(out / name).convert("RGB")
    spread = max(ImageStat.Stat(picture).stddev)
    check(picture.size == size and spread > deviation,
          f"{name}: {picture.size[0]}x{picture.size[1]}, standard deviation {spread:.0f}")


for name in ("head.png", "panel.png", "separate.png", "weighted.png", "difference.png"):
    shows_something(name, (512, 512), 20)
shows_something("oled.png", (512, 256), 20)
shows_something("turn.png", (1536, 1024), 20)
frames = sorted((out / "turn").glob("frame*.png"))
different = len({path.read_bytes() for path in frames})
check(different == 24, f"turn: {different} different frames")
animation = Image.open(out / "turn.apng")
check(animation.n_frames == 24, f"turn.apng: {animation.n_frames} frames")
sys.exit(failed)
PYTHON
