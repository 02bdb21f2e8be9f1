"""Points of files that other programs save: text tables, PLY, PCD and OBJ, with their colours and classes where they have some."""
import struct

import numpy


def table(path):
    """Text with a header (CSV, CloudCompare's ASC) or without one (XYZ): the columns by name."""
    with open(path) as file:
        first, *rest = file.read().replace('"', "").strip().split("\n")
    mark = ";" if ";" in first else "," if "," in first else None
    names = [name.strip() for name in first.lstrip("/#").split(mark)]
    bare = all(name.lstrip("-")[:1].isdigit() for name in names)
    body = numpy.array([line.split(mark) for line in ([first] if bare else []) + rest])
    body = numpy.where(body == "", "nan", body).astype(float).reshape(-1, len(names))
    return {name: body[:, n] for n, name in enumerate("xyz" if bare else names)}


def ply(path):
    kinds = {"float": "f4", "double": "f8", "uchar": "u1", "uint8": "u1", "float32": "f4", "float64": "f8", "int": "i4", "uint": "u4", "short": "i2",
             "ushort": "u2", "char": "i1", "int32": "i4", "uint32": "u4", "uint16": "u2", "int16": "i2"}
    data = open(path, "rb").read()
    head, body = data.split(b"end_header", 1)
    body = body[body.index(b"\n") + 1:]
    layout, count, inside = [], 0, False
    for words in (line.split() for line in head.decode("latin1").split("\n")):
        if words[:1] == ["element"]:
            inside = words[1] == "vertex"
            count = int(words[2]) if inside else count
        if words[:1] == ["property"] and inside:
            layout.append((words[2], "<" + kinds[words[1]]))
    if b"format ascii" in head:
        read = numpy.array([line.split() for line in body.decode().split("\n")[:count]], dtype=float)
        return {name: read[:, n] for n, (name, _) in enumerate(layout)}
    if b"PCL generated" in head and len(body) >= count * (numpy.dtype(layout).itemsize + 1):
        layout.append(("unnamed", "u1"))  # behind the colours, where its header has three of four bytes
    read = numpy.frombuffer(body, dtype=layout, count=count)
    return {name: read[name] for name, _ in layout}


def pcd(path):
    """Text or uncompressed binary."""
    data = open(path, "rb").read()
    at = data.index(b"\nDATA ")
    head = {line.split()[0]: line.split()[1:] for line in data[:at].decode("latin1").split("\n") if line and line[0] != "#"}
    body = data[data.index(b"\n", at + 1) + 1:]
    kinds = {"F": "f", "U": "u", "I": "i"}
    layout = [(name + "_" * (name == "_") * n, "<" + kinds[kind] + size, (int(count),)) for n, (name, kind, size, count)
              in enumerate(zip(head["FIELDS"], head["TYPE"], head["SIZE"], head["COUNT"]))]
    if data[at:].startswith(b"\nDATA ascii"):
        read = numpy.array([line.split() for line in body.decode().split("\n") if line])
        columns = {name: read[:, n] for n, (name, _, _) in enumerate(layout)}
        if "rgb" in columns and not all(text.isdigit() for text in columns["rgb"]):
            columns["rgb"] = columns["rgb"].astype("<f4").view("<u4")
        columns = {name: column.astype(float) for name, column in columns.items()}
    else:
        read = numpy.frombuffer(body, dtype=layout, count=int(head["POINTS"][0]))
        columns = {name: read[name][:, 0].copy().view("<u4") if name == "rgb" else read[name][:, 0] for name, _, _ in layout}
    if "rgb" in columns:
        bits = columns["rgb"].astype(int)
        columns.update(red=bits >> 16 & 255, green=bits >> 8 & 255, blue=bits & 255)
    return columns


def obj(path):
    found = numpy.array([line.split()[1:4] for line in open(path) if line.startswith("v ")], dtype=float)
    return dict(zip("xyz", found.T))


def las(path):
    data = open(path, "rb").read()
    start, = struct.unpack_from("<I", data, 96)
    size, count = struct.unpack_from("<HI", data, 105)
    count = count or struct.unpack_from("<Q", data, 247)[0]
    scale = struct.unpack_from("<6d", data, 131)
    whole = numpy.ndarray((count, 3), "<i4", data, start, (size, 4))
    return dict(zip("xyz", (whole * scale[:3] + scale[3:]).T))


def read(path):
    """One row per point: x y z red green blue class, not a number where there is none."""
    kind = path.rsplit(".", 1)[1]
    columns = {"ply": ply, "pcd": pcd, "obj": obj, "las": las}.get(kind, table)(path)
    called = {name.lower(): column for name, column in columns.items()}
    found = lambda *names: next((called[name] for name in names if name in called), numpy.nan)
    places = [found(*names) for names in (("x", "x_m", "easting_m", "east_m", "points:0"), ("y", "y_m", "northing_m", "north_m", "points:1"),
                                               ("z", "z_m", "elevation_m", "up_m", "points:2"))]
    rows = numpy.empty((len(places[0]), 7))
    for n, column in enumerate(places + [found("red", "r"), found("green", "g"), found("blue", "b"), found("class", "scalar_class")]):
        rows[:, n] = column
    return rows
