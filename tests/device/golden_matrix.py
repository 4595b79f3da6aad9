"""Compares what devices say of the golden scenes with golden.h.

    golden_matrix.py GOLDEN.h FOLDER RUNS

RUNS has a line "TARGET LEVEL" for each run, whose console is FOLDER/TARGET.LEVEL: a line
"NUMBER CHECKSUM CHECKSUM..." for each scene (tests/golden/golden_device.c) and at last "end".
Prints TAP, a result for each run, what differs, and a matrix: a row for each kind of scenes,
a column for each run, in which stands how many of them agree.
"""

import re
import sys
from pathlib import Path

WAYS = ("whole", "strips", "rows", "pieces")
ORDERS = ("front to back", "back to front", "levels")
FEWEST_WAYS = 2
MOST_DIFFERENCES = 20  # that are shown of a run
SCENE = re.compile(r"0x([0-9a-f]{8})u, /\* (\d+) (.*) \*/")


def read_golden(file):
    """Number to (checksum, name)."""
    return {int(number): (checksum, name)
            for checksum, number, name in SCENE.findall(Path(file).read_text(encoding="utf-8"))}


def kind(name):
    """What a row is of: a family and its order, or a blend, or a splatting."""
    family, _, drawn, *_ = name.split(", ")
    return f"{family}, {drawn}" if drawn in ORDERS or family == "freevoxels" else drawn


def read_run(file):
    """Number to checksums, and the lines that are none."""
    said, others = {}, []
    for line in file.read_text(encoding="utf-8", errors="replace").splitlines():
        words = line.split()
        if words and words[0].isdigit():
            said[int(words[0])] = words[1:]
        elif not line.startswith("  "):  # of the Makefile
            others.append(line)
    return said, others


def differences(golden, said):
    """Number to what is wrong with the scene."""
    wrong = {}
    for number, (expected, name) in golden.items():
        found = said.get(number, [])
        off = [f"{way} {checksum}" for way, checksum in zip(WAYS, found) if checksum != expected]
        if len(found) < FEWEST_WAYS:
            off.append(f"{len(found)} ways drawn")
        if off:
            wrong[number] = f"scene {number} ({name}): {', '.join(off)} instead of {expected}"
    return wrong


def judge(place, run, golden, folder):
    """Prints one result; returns the numbers of the scenes that differ."""
    file = folder / ".".join(run)
    said, others = read_run(file) if file.exists() else ({}, ["did not run"])
    wrong = differences(golden, said)
    ended = others[-1:] == ["end"]
    ways = max(map(len, said.values()), default=0)
    good = ended and not wrong and golden.keys() == said.keys()
    print(f"{'ok' if good else 'not ok'} {place} - golden scenes on {' '.join(run)}: "
          f"{len(golden) - len(wrong)} of {len(golden)} agree, {', '.join(WAYS[:ways])}")
    for line in list(wrong.values())[:MOST_DIFFERENCES]:
        print(f"# {' '.join(run)}: {line}")
    if not ended:
        for line in others[-MOST_DIFFERENCES:]:
            print(f"# {' '.join(run)}: {line}")
    return set(wrong), good


def print_matrix(golden, runs, wrong):
    kinds = {}
    for number, (_, name) in golden.items():
        kinds.setdefault(kind(name), set()).add(number)
    for column, run in enumerate(runs, 1):
        print(f"# column {column}: {' '.join(run)}")
    numbers = "".join(f"{column:4}" for column in range(1, len(runs) + 1))
    print(f"# {'scenes that agree':41}  all{numbers}")
    for name, numbers in kinds.items():
        cells = "".join(f"{len(numbers - off):4}" for off in wrong)
        print(f"# {name:41} {len(numbers):4}{cells}")


def main():
    golden = read_golden(sys.argv[1])
    folder = Path(sys.argv[2])
    runs = [line.split() for line in Path(sys.argv[3]).read_text(encoding="utf-8").splitlines()]
    results = [judge(place, run, golden, folder) for place, run in enumerate(runs, 1)]
    print_matrix(golden, runs, [wrong for wrong, _ in results])
    print(f"1..{len(runs)}")
    return 0 if runs and golden and all(good for _, good in results) else 1


if __name__ == "__main__":
    sys.exit(main())
