"""Runs the mutants of the library against the test vectors.

    python3 mutate.py [--every N [--first N]] [--jobs N] [--out FOLDER] [--quick] [FILE...]

Each mutant is built with the generator of the vectors, in a copy of the sources below the folder.
It is killed if the build fails, if a stage has other rows than the committed ones, or if it
crashes or does not end. A survivor is tried again with narrow products and, if its file has
forms for several compilers, with the system's; then it is compared with the original by what an
optimising compiler makes of both: the same code is the same function.

Prints a line for each survivor, FILE:LINE: OLD -> NEW, then the numbers.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import shutil
import subprocess
import sys
import threading

import mutants

FOLDERS = ("core", "fixedpoint", "tests/vectors/from_library", "tests/mutation")
FILES = ("port/crc32.c", "port/crc32.h")
NOT_OF_THE_ROWS = ("main.c", "write_rows.c", "write_description.c", "sha256.c")
INCLUDES = ["-Icore", "-Ifixedpoint", "-Iport", "-Itests/vectors/from_library"]
CONFIGURATIONS = (
    ["tcc", "-std=c99"],
    ["tcc", "-std=c99", "-DFX_NARROW=1"],
    ["cc", "-std=c99", "-O1", "-w"],
)
OPTIMISED = ["cc", "-std=c99", "-O2", "-w", "-S", "-o", "code.o"]
PATIENCE = 100   # seconds; rows limits its own time

# Where the formulas of the vectors' stages stand; the rest of core/ calls them, for each voxel,
# pixel or slice, checks arguments, or lays out memory.
NUMERIC = """
    core/associate.c core/bspline.h core/camera_orthographic.c core/camera_perspective.c
    core/cell.h core/composite.h core/convert.c core/correct.h core/curve.h
    core/domain_extinction.c core/domain_stored.c core/downsample.c core/entry.h
    core/footprint.c core/gradient.c core/gradient.h core/kernel.c core/kernel.h core/march.h
    core/march_lengths.h core/medium.c core/medium.h core/mixture.c core/order.h
    core/order_hilbert.c core/order_linear.c core/order_morton.c core/pixels.c
    core/preweighted.h core/ray.c core/ray.h core/reduce.c core/replay.c core/sample.h
    core/sample_preweighted.c core/scalars.h core/shade.c core/splat.c core/splat.h
    core/stretch.c core/stretch.h core/sum.h core/thickness.c core/thickness.h core/transfer.c
    core/unit_vector.c core/weights.h
    fixedpoint/fx_alpha.c fixedpoint/fx_alpha.h fixedpoint/fx_angle.c fixedpoint/fx_bits.h
    fixedpoint/fx_blend.h fixedpoint/fx_correct.c fixedpoint/fx_correct.h fixedpoint/fx_dither.c
    fixedpoint/fx_dither.h fixedpoint/fx_exp.c fixedpoint/fx_exp.h fixedpoint/fx_exp_table.h
    fixedpoint/fx_log.c fixedpoint/fx_log.h fixedpoint/fx_log8_table.h fixedpoint/fx_log_table.h
    fixedpoint/fx_phi.c fixedpoint/fx_phi_table.h fixedpoint/fx_root.c fixedpoint/fx_scaled.c
    fixedpoint/fx_unorm.h fixedpoint/fx_weight.h fixedpoint/fx_wide.c fixedpoint/fx_wide.h
""".split()


def run(command, folder):
    """The status and the output; a run that does not end has status -1."""
    try:
        done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, timeout=PATIENCE, close_fds=False,
                              check=False)
        return done.returncode, done.stdout.decode(errors="replace")
    except subprocess.TimeoutExpired:
        return -1, ""


class Tree:
    """A copy of the sources, with the objects of one configuration."""

    def __init__(self, folder, compiler):
        self.folder = folder
        self.compiler = compiler
        self.code = {} # assembly of the unchanged sources, once it is wanted
        shutil.rmtree(folder, ignore_errors=True)
        for name in FOLDERS:
            shutil.copytree(name, os.path.join(folder, name))
        for name in FILES:
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            shutil.copy(name, os.path.join(folder, name))
        files = [os.path.join(name, file) for name in FOLDERS for file in sorted(os.listdir(name))]
        self.sources = [name for name in [*files, *FILES] if name.endswith(".c")
                        and os.path.basename(name) not in NOT_OF_THE_ROWS]
        self.users = self.find_users()
        if not all([self.compile(source) for source in self.sources]):
            sys.exit("mutate: the sources do not compile: " + " ".join(compiler))
        if not self.build([]):
            sys.exit("mutate: the sources do not link: " + " ".join(compiler))
        status, hashes = run(["./rows"], folder)
        if status != 0:
            sys.exit("mutate: the unchanged rows cannot be computed")
        with open(os.path.join(folder, "hashes"), "w", encoding="ascii") as file:
            file.write(hashes)

    def find_users(self):
        """For each file, the sources that contain it."""
        users = collections.defaultdict(list)
        for source in self.sources:
            _, text = run(["cc", "-MM", *INCLUDES, source], self.folder)
            for name in text.replace("\\\n", " ").split(":", 1)[1].split():
                users[os.path.normpath(name)].append(source)
        return users

    @staticmethod
    def object_of(source):
        return source.replace("/", "_")[:-2] + ".o"

    def compile(self, source):
        command = [*self.compiler, *INCLUDES, "-c", source, "-o", self.object_of(source)]
        return run(command, self.folder)[0] == 0

    def build(self, changed):
        """Builds rows, with the changed sources compiled anew."""
        parts = [source if source in changed else self.object_of(source) for source in self.sources]
        return run([*self.compiler, *INCLUDES, "-o", "rows", *parts], self.folder)[0] == 0

    def write(self, path, text):
        with open(os.path.join(self.folder, path), "w", encoding="utf-8") as file:
            file.write(text)

    def killer(self, path, text, stages):
        """What kills the file with this text: a stage, or how it failed; None if it lives."""
        self.write(path, text)
        built = self.build(self.users[path])
        self.write(path, read(path))
        if not built:
            return "build"
        status, stage = run(["./rows", "hashes", *stages], self.folder)
        return None if status == 0 else stage.strip() or "crash"

    def is_same_code(self, path, text):
        """Whether the code of each user is the same: as the quick compiler makes it, or else as
        an optimising one does."""
        quick = [*self.compiler, "-c", "-o", "code.o"]
        narrow = [option for option in self.compiler if option.startswith("-D")]
        return all(self.is_same(source, path, text, quick) or
                   self.is_same(source, path, text, [*OPTIMISED, *narrow])
                   for source in self.users[path])

    def is_same(self, source, path, text, compiler):
        key = source, *compiler
        if key not in self.code:
            self.code[key] = self.compiled(source, compiler)
        self.write(path, text)
        code = self.compiled(source, compiler)
        self.write(path, read(path))
        return code == self.code[key]

    def compiled(self, source, compiler):
        run([*compiler, *INCLUDES, source], self.folder)
        with open(os.path.join(self.folder, "code.o"), "rb") as file:
            return file.read()


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def lines_run(out):
    """For each file, its lines that the rows of the vectors run."""
    tree = Tree(os.path.join(out, "coverage"), ["cc", "-std=c99", "-w", "--coverage"])
    run(["./rows"], tree.folder)
    lines = collections.defaultdict(set)
    for source in tree.sources:
        _, text = run(["gcov", "--json-format", "--stdout", Tree.object_of(source)], tree.folder)
        for file in json.loads(text)["files"]:
            lines[os.path.normpath(file["file"])].update(
                line["line_number"] for line in file["lines"] if line["count"] > 0)
    return lines


def is_run(path, line, lines):
    """Whether a line is outside of all functions, or in one that the rows run."""
    for first, last in mutants.functions_of(read(path)):
        if first <= line <= last:
            return any(first <= other <= last for other in lines[path])
    return True


class Worker(threading.local):
    """The trees of one thread, made when they are first wanted."""
    trees = None

    def tree(self, out, number):
        if self.trees is None:
            self.trees = {}
        if number not in self.trees:
            folder = os.path.join(out, f"tree{threading.get_ident()}-{number}")
            self.trees[number] = Tree(folder, CONFIGURATIONS[number])
        return self.trees[number]


WORKER = Worker()
LAST_KILLS = collections.defaultdict(list) # of a file: stages, the latest first


def verdict(out, path, text, compare):
    """What kills a mutant; "same" if it is the same code; None if it lives."""
    conditional = "#if" in read(path).split("_H\n", 1)[-1]
    for number in range(len(CONFIGURATIONS) if conditional else 2):
        killer = WORKER.tree(out, number).killer(path, text, LAST_KILLS[path][:4])
        if killer is not None:
            if killer not in LAST_KILLS[path][:1] and killer not in ("build", "crash"):
                LAST_KILLS[path].insert(0, killer)
            return killer
    same = compare and all(WORKER.tree(out, n).is_same_code(path, text) for n in range(2))
    return "same" if same else None


def examine(options, path, start, old, new):
    source = read(path)
    text = source[:start] + new + source[start + len(old):]
    name = f"{path}:{mutants.line_of(source, start)}: {old} -> {new}"
    column = start - source.rfind("\n", 0, start)
    return name, column, verdict(options.out, path, text, not options.quick)


def sample_tasks(options):
    """The changes that a file lists: path, what stands there once, what shall; tabs between."""
    tasks = []
    for line in read(options.sample).splitlines():
        if line.startswith("#"):
            continue
        path, old, new = line.split("\t")
        if read(path).count(old) != 1:
            sys.exit(f"mutate: {options.sample}: {path} has not exactly one: {old}")
        tasks.append((options, path, read(path).index(old), old, new))
    return tasks


def all_tasks(options):
    """The mutants of all functions that the rows run, and of the constants outside of them."""
    lines = lines_run(options.out)
    tasks = []
    for path in options.files or NUMERIC:
        source = read(path)
        tasks += [(options, path, *mutant) for mutant in mutants.mutants_of(source)
                  if is_run(path, mutants.line_of(source, mutant[0]), lines)]
    return tasks[options.first::options.every]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--out", default="build/mutants")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--sample")
    parser.add_argument("files", nargs="*")
    options = parser.parse_args()
    tasks = sample_tasks(options) if options.sample else all_tasks(options)
    counts, files = collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for name, column, killer in pool.map(lambda task: examine(*task), tasks):
            files[name.split(":")[0], "killed" if killer else "survived"] += 1
            counts["same" if killer == "same" else "killed" if killer else "survived"] += 1
            if killer is None:
                print(f"{name} (column {column})", flush=True)
    for (file, what), count in sorted(files.items()):
        print(file, what, count)
    print(f"{len(tasks)} mutants: {counts['killed']} killed, {counts['survived']} survived, "
          f"{counts['same']} are the same code")


if __name__ == "__main__":
    main()
