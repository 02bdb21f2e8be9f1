"""Opens our exports in other programs, and what these save in ours, and prints the tables of docs/measurements/exchange.md. See docs/measurements/make-exchange."""
import argparse
import collections
import json
import os
import re
import sys
import tempfile

try:
    import numpy
    import exchange_points
    import exchange_programs
    from exchange_chain import Grid, mine_frame, scanner_frame
except ImportError as problem:
    print(f"Not run: {problem}")
    sys.exit(77)

HERE = os.path.dirname(os.path.abspath(__file__))
FRAMES = ["scanner", "local", "mine"]

FEW_CELLS = 20  # that may differ where the axis of the scanner had to be found from rounded points

# An export: most that its own rounding explains in mm, whether it carries colours and classes, and the frames that it has.
Export = collections.namedtuple("Export", "rounding_mm coloured classed frames", defaults=[False, False, FRAMES])
EXPORTS = {
    "xyz": Export(0.1),
    "csv": Export(0.1, classed=True),
    "ply": Export(0.1, True, True),
    "pcd": Export(0.1, True, True),
    "las": Export(0.51, True, True),
    "obj": Export(0.1, True),
    "ptx": Export(0.1),
    "dxf": Export(0.1, True, True),
    "mcap": Export(0, frames=["scanner"]),
}


class Scan:
    """The scan in all its exports, what their points must be, and what our own reading of them finds."""

    def __init__(self, cli, folder):
        self.cli, self.folder = cli, folder
        page = open(os.path.join(HERE, "../reference/coordinates.md")).read()
        examples = [json.loads(block) for block in re.findall(r"```json\n(.*?)```", page, re.S)]
        robot, pose = (next(one for one in examples if one.get("format") == f"edgescan-{kind}/1") for kind in ("calibration", "pose"))
        self.place = []
        for flag, content in (("calibration", robot), ("pose", pose)):
            path = os.path.join(folder, f"{flag}.json")
            json.dump(content, open(path, "w"))
            self.place += [f"--{flag}", path]
        self.raw = os.path.join(folder, "bell.json")
        self.ours("simulate", "-o", self.raw, "--axis", "spin", "--lines", "200", "--beams", "300", "--seed", "7")
        self.grid = Grid(self.raw)
        self.in_mine = mine_frame(pose, robot)
        for frame in FRAMES:
            os.makedirs(os.path.join(folder, frame))
            for kind in (one for one, about in EXPORTS.items() if frame in about.frames):
                path = self.export(kind, frame)
                content = ["convert", self.raw, path] if kind in ("ptx", "mcap") else ["detect", self.raw, "--cloud", path]
                self.ours(*content, *([] if kind == "mcap" else [*self.place, "--frame", frame]))
        record = json.load(open(self.export("csv", "local") + ".provenance.json"))
        self.origin = numpy.array(record["record"]["coordinates"]["origin_enh_m"])
        points = self.grid.points(self.in_mine)
        self.points = {"scanner": self.grid.points(scanner_frame(self.grid)), "local": points - self.origin, "mine": points}
        self.edges = self.edges_of(self.raw)
        self.classes = exchange_points.read(self.export("csv", "scanner"))[:, 6]

    def export(self, kind, frame):
        return os.path.join(self.folder, frame, f"bell.{kind}")

    def ours(self, *command):
        program = os.path.join(os.path.dirname(self.cli), "edgescan-lab") if command[0] == "simulate" else self.cli
        said = exchange_programs.said_by([program, *command])
        if said.returncode != 0:
            raise RuntimeError(re.sub(r"^edgescan-cli: (/\S+: )?", "", said.stdout.strip().split("\n")[-1]).split(":")[0])
        return said.stdout

    def farthest(self, rows, frame):
        """The greatest difference of a coordinate in mm; the points are in the order of the cells."""
        return 1000 * abs(rows[:, :3] - self.points[frame]).max()

    def edges_of(self, path, *reading):
        """The cells of the edges that we find in a file, and the shape of its grid."""
        with tempfile.TemporaryDirectory() as folder:
            listed, counted = os.path.join(folder, "edges.csv"), os.path.join(folder, "counts.json")
            self.ours("detect", path, "--edges", listed, "--json", counted, *reading)
            columns, counts = exchange_points.table(listed), json.load(open(counted))
            return set(zip(columns["line"].astype(int), columns["beam"].astype(int))), (counts["lines"], counts["beams"])

    def differing(self, path):
        """How many cells differ between the edges of the scan and those of a file that another program saved."""
        edges, shape = self.edges_of(path)
        return len(edges ^ self.edges[0]) if shape == self.edges[1] else f"another grid, {shape[0]} x {shape[1]}"

    def by_rounding(self, path, frame):
        """As many cells differ where each gets the range of its rounded point and nothing else happens."""
        points = exchange_points.read(path)[:, :3]
        if len(points) != len(self.grid.cells):
            return "other points"
        if frame != "scanner" and abs(points).max() < abs(self.origin).max() / 2:
            points = points + self.origin
        nothing = Grid(self.raw)
        nothing.ranges = nothing.ranges * 0
        sensors = nothing.points(scanner_frame(nothing) if frame == "scanner" else self.in_mine)
        ranges = 0 * self.grid.ranges
        ranges.flat[self.grid.cells] = 1000 * numpy.linalg.norm(points - sensors, axis=1)
        rounded = os.path.join(self.folder, "rounded.npy")
        numpy.save(rounded, ranges.astype("<f4"))
        beams, lines = self.grid.beam_deg, self.grid.line_deg
        edges, _ = self.edges_of(rounded, "--unit", "mm", "--axis", "spin", "--beam-start", str(beams[0]), "--beam-step", str(beams[1] - beams[0]),
                                 "--line-start", str(lines[0]), "--line-step", str(lines[1] - lines[0]))
        return len(edges ^ self.edges[0])


def compared(scan, kind, frame, rows):
    """What a program read in one frame: what the table shows, and whether it is right."""
    if isinstance(rows, str):
        return rows, not rows.startswith(("not read", "an empty"))
    if len(rows) != len(scan.grid.cells):
        return f"{len(rows)} of {len(scan.grid.cells)} points", False
    worst = scan.farthest(rows, frame)
    if worst > 1000 and frame == "mine":  # a file whose header has the origin
        about = scan.farthest(rows, "local")
        if about < worst:
            return f"{about:.4f} about the origin", about <= EXPORTS[kind].rounding_mm
    return f"{worst:.4f}", worst <= EXPORTS[kind].rounding_mm


def colours_of(scan, kind, rows):
    if not EXPORTS[kind].coloured or isinstance(rows, str) or numpy.isnan(rows[:, 3]).all():
        return "", True
    colours = rows[:, 3:6]
    coloured = int((colours.max(axis=1) > 1.05 * colours.min(axis=1)).sum())
    edges = len(scan.edges[0])
    return f"{coloured} of {edges}", coloured == edges


def classes_of(scan, kind, rows):
    if not EXPORTS[kind].classed or isinstance(rows, str) or len(rows) != len(scan.classes) or numpy.isnan(rows[:, 6]).all():
        return "", True
    same = int((rows[:, 6] == scan.classes)[scan.classes > 0].sum())
    return f"{same} of {len(scan.edges[0])}", same == len(scan.edges[0])


def tried(act):
    """What act gives, or the words of a refusal."""
    try:
        return act()
    except Exception as problem:  # a refusal by another program is a result
        return f"not read: {str(problem).strip() or type(problem).__name__}"


Tried = collections.namedtuple("Tried", "cells right seen saved sound")


def read_and_saved(scan, program, kind):
    """One program with one format in all frames: its row of each table, the frames in which it reads it rightly, and whether all is sound."""
    cells, right, seen, saved_cells, sound = [], [], None, [], True
    for frame in FRAMES:
        if frame not in EXPORTS[kind].frames:
            cells.append("")
            saved_cells.append("")
            continue
        with tempfile.TemporaryDirectory(dir=scan.folder) as own:
            saved = os.path.join(own, f"saved.{program.saves[kind]}") if kind in program.saves else None
            rows = tried(lambda: program.reads(program, scan.export(kind, frame), own, saved))
            cell, good = compared(scan, kind, frame, rows)
            cells.append(cell)
            right += [frame] if good else []
            expected = kind not in program.refuses and not (program.four_bytes and frame == "mine")
            sound = sound and (good or not expected)
            if seen is None and not isinstance(rows, str):
                seen = [colours_of(scan, kind, rows), classes_of(scan, kind, rows)]
                sound = sound and all(same for _, same in seen)
            if saved:
                differ, by_rounding = opened_again(scan, saved, frame)
                saved_cells.append(f"{differ}" if not differ else f"{differ} (rounding alone: {by_rounding})")
                explained = by_rounding + (FEW_CELLS if frame != "scanner" else 0) if isinstance(by_rounding, int) else 0
                sound = sound and (not expected or isinstance(differ, int) and differ <= explained)
    return Tried(cells, right, [shown for shown, _ in seen] if seen else ["", ""], saved_cells if kind in program.saves else [], sound)


def opened_again(scan, saved, frame):
    """The cells that differ in a file that another program saved, and those that its rounding alone explains."""
    if not os.path.exists(saved):
        return "not saved", "-"
    differ = tried(lambda: scan.differing(saved))
    return differ, 0 if differ == 0 else tried(lambda: scan.by_rounding(saved, frame))


def choice(kinds_right):
    """What to choose for a program, of the formats that it reads rightly in each frame."""
    listed = lambda frame: ", ".join(kind for kind, right in kinds_right.items() if frame in right)
    if listed("mine"):
        return f"`--frame mine`: {listed('mine')}"
    return f"`--frame local`: {listed('local')}" if listed("local") else listed("scanner")


def row(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def head(title, words, *columns):
    print(f"\n## {title}\n\n{words}\n")
    row(*columns)
    print("|" + "---|" * len(columns))


def clouds(scan, programs):
    """The tables of what programs read and what they save. Gives the formats that each reads rightly with their frames, and whether all is sound."""
    head("What they read", "Differences in mm.", "format", "program", "scanner", "local", "mine", "colours of edges", "classes of edges")
    sound, saves, right = True, [], collections.defaultdict(dict)
    for kind in EXPORTS:
        for program in (one for one in programs if kind in one.formats):
            result = read_and_saved(scan, program, kind)
            row(kind, program.name, *result.cells, *result.seen)
            saves += [(program.name, kind, program.saves[kind], *result.saved)] if result.saved else []
            right[program.name][kind] = result.right
            sound = sound and result.sound
            if not result.sound:
                print(f"{program.name}, {kind}: not as it must be", file=sys.stderr)
    head("What they save", "The program opens our file and saves it. EdgeScan opens that, without a record, and finds the edges. The table shows how many of "
         "their cells differ from those of the scan. *Rounding alone* is how many differ if each cell only gets the range of its saved point.",
         "program", "format", "saved as", "scanner", "local", "mine")
    for cells in saves:
        row(*cells)
    return right, sound


def rocks(scan, programs):
    """The table of rock tables and drawings."""
    head("Rocks", "`rocks --csv --outlines` in the mine grid.", "file", "program", "what it reads")
    sound = True
    table, *drawings = [os.path.join(scan.folder, name) for name in exchange_programs.ROCK_FILES]
    for path in drawings:
        scan.ours("rocks", scan.raw, "--outlines", path, *scan.place, "--frame", "mine")
    scan.ours("rocks", scan.raw, "--csv", table, *scan.place, "--frame", "mine")
    for path in (table, *drawings):
        for program in (one for one in programs if os.path.basename(path) in one.rocks):
            with tempfile.TemporaryDirectory(dir=scan.folder) as own:
                said = tried(lambda: program.reads(program, path, own, None))
            row(os.path.basename(path), program.name, said)
            sound = sound and not said.startswith("not read")
    return sound


def main():
    there = [exchange_programs.found(program, ROOTS) for program in exchange_programs.programs() if program.name in ONLY or not ONLY]
    programs = [program for program, version in there if version]
    if not programs:
        print("Not run: not one of these is installed: " + ", ".join(program.name for program, _ in there))
        return 77
    with tempfile.TemporaryDirectory(dir=WORK) as folder:
        scan = Scan(CLI, folder)
        print(f"A scan of 200 lines x 300 beams, {len(scan.grid.cells)} points, {len(scan.edges[0])} of them edges, with the pose and the robot of "
              "docs/reference/coordinates.md: E 498,765 N 5,150,123.")
        right, sound = clouds(scan, programs)
        sound = rocks(scan, programs) and sound
    head("What to choose", "The exports that arrive as they are, and what the program asks when one of mine coordinates is opened by hand.",
         "program", "version", "choose", "it asks")
    for program, version in there:
        row(program.name, version or "not run", choice(right[program.name]), program.asks)
    return 0 if sound else 1


if __name__ == "__main__":
    given = argparse.ArgumentParser()
    given.add_argument("cli")
    given.add_argument("--modules", default="", help="folder of the packages of npm")
    given.add_argument("--root", action="append", default=[], help="a system that has programs; searched in this order, then this machine")
    given.add_argument("--work", help="folder with exchange_read.* that the roots have under the same path")
    given.add_argument("--only", default="", help="names of programs, for a trial")
    given = given.parse_args()
    CLI, ROOTS, WORK, ONLY = given.cli, given.root, given.work, given.only
    exchange_programs.WHERE = {"scripts": WORK or HERE, "modules": given.modules}
    sys.exit(main())
