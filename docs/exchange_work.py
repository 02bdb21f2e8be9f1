"""Opens our exports in other programs and prints a table: points, largest coordinate difference, colours. See docs/make-exchange."""
import csv
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile

CLI, MODULES = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else ""
HERE = os.path.dirname(os.path.abspath(__file__))
COLOURED = ["ply", "pcd", "las", "obj", "dxf", "foxglove.mcap"]
MOST_OFF_MM = {"xyz": 0.01, "csv": 0.01, "ply": 0.01, "pcd": 0.01, "las": 0.501, "obj": 0.01, "ptx": 0.01, "dxf": 0.06, "foxglove.mcap": 0.01}
# Formats that these programs cannot read: listed in the table, not an error of the file.
WITHOUT_READER = {("CloudCompare", "pcd"), ("CloudCompare", "las"), ("loaders.gl", "las"), ("MeshLab", "ptx")}
FORMATS = ["xyz", "csv", "ply", "pcd", "las", "obj", "ptx", "dxf", "mcap", "foxglove.mcap"]


def run(command, **more):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=240, **more)


def has(program):
    return shutil.which(program) is not None


def shown(command):
    """Programs with a window need a display."""
    return (["xvfb-run", "-a"] if has("xvfb-run") else []) + command


class Cloud:
    """The points that a program read, in metres, and the number with the colour of an edge; None: unknown."""

    def __init__(self, points, coloured=None):
        self.points, self.coloured = points, coloured


def is_coloured(r, g, b):
    """An edge of any class; other points are gray."""
    return max(r, g, b) > 1.05 * min(r, g, b)


def reference(path):
    """The cells of a raw grid as points, by the formulas of docs/coordinates.md."""
    grid = json.load(open(path))
    counts = open(os.path.join(os.path.dirname(path), grid["data"]), "rb").read()
    ranges = struct.unpack(f"<{len(counts) // 2}H", counts)
    points = []
    for k, count in enumerate(ranges):
        if count in grid["no_return"]:
            continue
        r = count * grid["unit_mm"] / 1000
        a = math.radians(grid["beam_deg"][k % grid["beams"]])
        p = math.radians(grid["line_deg"][k // grid["beams"]])
        if grid["axis"] == "spin":
            points.append((r * math.cos(a) * math.cos(p), r * math.cos(a) * math.sin(p), r * math.sin(a)))
        else:
            points.append((r * math.cos(a), -r * math.sin(a) * math.sin(p), r * math.sin(a) * math.cos(p)))
    return points


def read_ply(path):
    data = open(path, "rb").read()
    head, body = data.split(b"end_header", 1)
    body = body[body.index(b"\n") + 1:]
    kinds = {"float": "f", "double": "d", "uchar": "B", "uint8": "B", "float32": "f", "float64": "d", "int": "i", "uint": "I", "short": "h",
             "ushort": "H", "char": "b", "int32": "i", "uint32": "I", "uint16": "H", "int16": "h"}
    names, layout, count, inside = [], "<", 0, False
    for line in head.decode("latin1").split("\n"):
        words = line.split()
        if words[:1] == ["element"]:
            inside = words[1] == "vertex"
            count = int(words[2]) if inside else count
        if words[:1] == ["property"] and inside:
            names.append(words[2])
            layout += kinds[words[1]]
    if b"format ascii" in head:
        rows = [[float(w) for w in line.split()] for line in body.decode().split("\n")[:count]]
    else:
        size = struct.calcsize(layout)
        rows = [struct.unpack_from(layout, body, n * size) for n in range(count)]
    at = [names.index(n) for n in "xyz"]
    coloured = None
    if "red" in names:
        colour = [names.index(n) for n in ("red", "green", "blue")]
        coloured = sum(is_coloured(*(row[c] for c in colour)) for row in rows)
    return Cloud([tuple(row[c] for c in at) for row in rows], coloured)


def read_pcd_text(path):
    names, points, coloured = [], [], None
    for line in open(path):
        words = line.split()
        if words[0] == "FIELDS":
            names = words[1:]
        elif words[0][0] in "-0123456789n":
            row = words
            points.append(tuple(float(row[names.index(n)]) for n in "xyz"))
            if "rgb" in names:
                text = row[names.index("rgb")]
                bits = struct.unpack("<I", struct.pack("<f", float(text)))[0] if "." in text or "e" in text else int(text)
                coloured = (coloured or 0) + is_coloured(bits >> 16 & 255, bits >> 8 & 255, bits & 255)
    return Cloud(points, coloured)


def cloud_compare(path, folder):
    out = os.path.join(folder, "cc.asc")
    said = run(shown(["CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-C_EXPORT_FMT", "ASC", "-PREC", "9", "-SEP", "SPACE", "-ADD_HEADER", "-O",
                      path, "-SAVE_CLOUDS", "FILE", out]), cwd=folder)
    if not os.path.exists(out):
        raise RuntimeError("this build has no reader for it" if "unhandled file extension" in said.stdout else "nothing was read")
    rows = open(out).read().split("\n")
    names = rows[0].lstrip("/").split()
    body = [[float(w) for w in row.split()] for row in rows[1:] if row]
    coloured = None
    if "R" in names:
        colour = [names.index(c) for c in "RGB"]
        coloured = sum(is_coloured(*(row[c] for c in colour)) for row in body)
    return Cloud([tuple(row[:3]) for row in body], coloured)


def meshlab(path, folder):
    out = os.path.join(folder, "meshlab.ply")
    said = run(shown(["meshlabserver", "-i", path, "-o", out, "-m", "vc"]), cwd=folder)
    if not os.path.exists(out):
        raise RuntimeError("does not open it" if "nable to open" in said.stdout or "rror" in said.stdout else "nothing was read")
    return read_ply(out)


def pcl(path, folder):
    pcd = os.path.join(folder, "pcl.pcd")
    kind = path.rsplit(".", 1)[1]
    first = {"ply": ["pcl_ply2pcd", "-format", "0", path, pcd], "pcd": ["pcl_convert_pcd_ascii_binary", path, pcd, "0"],
             "obj": ["pcl_obj2pcd", path, pcd], "xyz": ["pcl_xyz2pcd", path, pcd]}[kind]
    said = run(first)
    if not os.path.exists(pcd):
        raise RuntimeError(said.stdout.strip()[-90:] or "nothing was read")
    text = os.path.join(folder, "pcl_text.pcd")
    run(["pcl_convert_pcd_ascii_binary", pcd, text, "0"])
    return read_pcd_text(text)


def pandas_reads(path, folder):
    import pandas
    table = pandas.read_csv(path) if path.endswith("csv") else pandas.read_csv(path, sep=" ", header=None)
    return Cloud([tuple(row) for row in table.iloc[:, :3].to_numpy(dtype=float)])


def numpy_reads(path, folder):
    import numpy
    return Cloud([tuple(row) for row in numpy.loadtxt(path)])


def gdal_reads(path, folder):
    from osgeo import ogr
    ogr.UseExceptions()
    if path.endswith("csv"):
        names = next(csv.reader(open(path)))[:3]
        source = ogr.GetDriverByName("CSV").Open(path)
        return Cloud([tuple(float(feature.GetField(n)) for n in names) for feature in source.GetLayer(0)])
    points = []
    drawing = ogr.Open(path) # its features are destroyed with it
    for feature in drawing.GetLayer(0):
        shape = feature.GetGeometryRef()
        if shape.GetGeometryType() in (ogr.wkbPoint, ogr.wkbPoint25D) and feature.GetField("Layer") in ("CLOUD", "EDGE_POINTS"):
            points.append((shape.GetX(), shape.GetY(), shape.GetZ()))
    return Cloud(points)


def ezdxf_reads(path, folder):
    import ezdxf
    drawing = ezdxf.readfile(path)
    problems = drawing.audit()
    if problems.errors:
        raise RuntimeError(f"{len(problems.errors)} errors")
    found = [entity for entity in drawing.modelspace().query("POINT")]
    coloured = sum(entity.dxf.layer == "EDGE_POINTS" for entity in found)
    return Cloud([tuple(entity.dxf.location) for entity in found], coloured)


def f3d_shows(path, folder):
    """A picture only: gives colours, not points."""
    out = os.path.join(folder, "f3d.ppm.png")
    said = run(shown(["f3d", path, "--output", out, "--resolution", "400,300", "--point-size", "3", "--camera-azimuth-angle", "20"]))
    if not os.path.exists(out):
        raise RuntimeError(said.stdout.strip()[-90:] or "no picture")
    from osgeo import gdal
    picture = gdal.Open(out).ReadAsArray()[:3].astype(float)
    if picture.std() == 0:
        raise RuntimeError("an empty picture")
    return Cloud(None, int((picture[1] > 1.3 * picture[[0, 2]].max(axis=0)).sum()))


def node_reads(library):
    def reads(path, folder):
        said = run(["node", os.path.join(HERE, "exchange_read.mjs"), MODULES, library, path, os.path.join(folder, "points.json")])
        if said.returncode != 0:
            raise RuntimeError(said.stdout.strip().split("\n")[-1][:90])
        read = json.load(open(os.path.join(folder, "points.json")))
        return Cloud(None if read["points"] is None else [tuple(p) for p in read["points"]], read.get("coloured"))
    return reads


def module(name):
    return MODULES != "" and has("node") and os.path.isdir(os.path.join(MODULES, "node_modules", name))


def importable(name):
    return run([sys.executable, "-c", f"import {name}"]).returncode == 0


PROGRAMS = [
    ("CloudCompare", lambda: has("CloudCompare"), cloud_compare, ["xyz", "csv", "ply", "pcd", "las", "obj", "ptx"]),
    ("MeshLab", lambda: has("meshlabserver"), meshlab, ["xyz", "ply", "obj", "ptx"]),
    ("PCL tools", lambda: has("pcl_ply2pcd"), pcl, ["xyz", "ply", "pcd", "obj"]),
    ("GDAL", lambda: importable("osgeo.ogr"), gdal_reads, ["csv", "dxf"]),
    ("ezdxf", lambda: importable("ezdxf"), ezdxf_reads, ["dxf"]),
    ("f3d", lambda: has("f3d") and importable("osgeo.gdal"), f3d_shows, ["ply", "obj"]),
    ("pandas", lambda: importable("pandas"), pandas_reads, ["xyz", "csv"]),
    ("numpy", lambda: importable("numpy"), numpy_reads, ["xyz"]),
    ("three", lambda: module("three"), node_reads("three"), ["xyz", "ply", "pcd", "obj"]),
    ("loaders.gl", lambda: module("@loaders.gl/core"), node_reads("loaders.gl"), ["csv", "ply", "pcd", "las", "obj"]),
    ("copc", lambda: module("copc"), node_reads("copc"), ["las"]),
    ("@mcap/core", lambda: module("@mcap/core"), node_reads("mcap"), ["mcap"]),
    ("Foxglove's schemas", lambda: module("@mcap/core") and module("@foxglove/schemas") and module("ajv"), node_reads("foxglove"),
     ["foxglove.mcap"]),
]


def difference(ours, theirs):
    """Largest difference of a coordinate, point by point."""
    return max(max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(ours, theirs))


def farthest(ours, theirs, cell=0.001):
    """The same for points in another order (drawings are ordered by layer): each point is compared with our nearest one within a millimetre."""
    near = {}
    for p in ours:
        near.setdefault(tuple(round(c / cell) for c in p), []).append(p)
    worst = 0
    for q in theirs:
        x, y, z = (round(c / cell) for c in q)
        around = [p for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1) for p in near.get((x + i, y + j, z + k), [])]
        worst = max(worst, min((max(abs(a - b) for a, b in zip(p, q)) for p in around), default=math.inf))
    return worst


def row_of(name, path, read, folder, points, edges):
    kind = os.path.basename(path).split(".", 1)[1]
    try:
        cloud = read(path, folder)
    except Exception as problem:  # a refusal by another program is a result
        return f"| {kind} | {name} | not read: {str(problem).strip() or type(problem).__name__} | | |", (name, kind) in WITHOUT_READER
    told = cloud.coloured is not None and kind in COLOURED
    colours = "" if not told else f"{cloud.coloured} green pixels" if cloud.points is None else f"{cloud.coloured} of {edges}"
    if cloud.points is None:
        return f"| {kind} | {name} | {'200 telegrams' if kind == 'mcap' else 'a picture'} | | {colours} |", True
    if len(cloud.points) != len(points):
        return f"| {kind} | {name} | {len(cloud.points)} of {len(points)} | | {colours} |", (name, kind) in WITHOUT_READER
    worst = 1000 * (farthest(points, cloud.points) if kind == "dxf" else difference(points, cloud.points))
    sound = worst <= MOST_OFF_MM[kind] and (not told or cloud.coloured == edges)
    return f"| {kind} | {name} | {len(cloud.points)} | {worst:.4f} | {colours} |", sound


def main():
    sound = True
    with tempfile.TemporaryDirectory() as folder:
        grid = os.path.join(folder, "bell.json")
        subprocess.run([CLI, "simulate", "-o", grid, "--lines", "200", "--beams", "300", "--seed", "7"], check=True, capture_output=True)
        points = reference(grid)
        edges = 0
        for kind in FORMATS:
            path = os.path.join(folder, f"bell.{kind}")
            command = [CLI, "convert", grid, path] if kind in ("mcap", "ptx") else [CLI, "detect", grid, "--cloud", path, "--json", "-"]
            said = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            edges = json.loads(said)["edges"] if "--json" in command else edges
        there = [program for program in PROGRAMS if program[1]()]
        missing = [name for name, is_there, _, _ in PROGRAMS if not is_there()]
        print("| format | program | points | largest difference, mm | points with the colour of an edge |\n|---|---|---|---|---|")
        for kind in FORMATS:
            for name, _, read, kinds in there:
                if kind not in kinds:
                    continue
                with tempfile.TemporaryDirectory() as own:
                    row, good = row_of(name, os.path.join(folder, f"bell.{kind}"), read, own, points, edges)
                print(row, flush=True)
                sound = sound and good
        print(f"\nA scan of 200 lines x 300 beams: {len(points)} points, {edges} of them edges.", end="")
        print(f" Not installed, so not tried: {', '.join(missing)}." if missing else "")
    return sound


if __name__ == "__main__":
    if not any(there() for _, there, _, _ in PROGRAMS):
        print("None of these is installed: " + ", ".join(name for name, _, _, _ in PROGRAMS))
        sys.exit(77)
    sys.exit(0 if main() else 1)
