"""Other programs, and how each of them reads an export and saves it again. See exchange_work.py."""
import collections
import os
import re
import shutil
import subprocess
import sys

import numpy

import exchange_points

SECONDS = 240  # for one program with one file
WHERE = {"scripts": os.path.dirname(os.path.abspath(__file__)), "modules": ""}  # exchange_read.*, and the packages of npm


def run(program, command):
    """Runs a command where the program is: in the root of another system, or on this machine."""
    if program.root:
        values = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LC_ALL": "C.UTF-8", "DISPLAY": os.environ.get("DISPLAY", "")}
        command = ["chroot", program.root, "env", "-i", *(f"{name}={value}" for name, value in values.items()), *command]
    elif command[0] == "python3":
        command = [sys.executable, *command[1:]]
    return said_by(command)


def said_by(command):
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          timeout=SECONDS)


def need(path, said):
    """The file that a program was to write, or why there is none."""
    if not os.path.exists(path):
        lines = [line.strip() for line in said.stdout.split("\n") if line.strip()]
        why = next((line for line in lines if line.startswith("refused: ")), lines[-1] if lines else "nothing was written")
        raise RuntimeError(why.removeprefix("refused: ")[:120])
    return path


def rows_of(path):
    return numpy.fromfile(path, "<f8").reshape(-1, 7)


def script(name, library, *interpreter):
    """A program in which one of the scripts exchange_read.* reads."""
    def reads(program, path, folder, saved):
        out = os.path.join(folder, "points.f64")
        modules = [WHERE["modules"]] if interpreter[0] == "node" else ["--"] if interpreter[0] == "blender" else []
        said = run(program, [*interpreter, os.path.join(WHERE["scripts"], name), *modules, library, path, out, *([saved] if saved else [])])
        if said.returncode == 0 and not os.path.exists(out):
            return said.stdout.strip().split("\n")[-1]
        return rows_of(need(out, said))
    return reads


def cloud_compare(program, path, folder, saved):
    out = os.path.join(folder, "read.asc")
    command = ["CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-O", "-GLOBAL_SHIFT", "AUTO", path,
               "-C_EXPORT_FMT", "ASC", "-PREC", "9", "-SEP", "SPACE", "-ADD_HEADER", "-SAVE_CLOUDS", "FILE", out]
    if saved:
        command += ["-C_EXPORT_FMT", kind_of(saved).upper(), "-SAVE_CLOUDS", "FILE", saved]
    said = run(program, command)
    if "unhandled file extension" in said.stdout.lower():
        raise RuntimeError("this build has no reader for it")
    return exchange_points.read(need(out, said))


def meshlab(program, path, folder, saved):
    out = saved or os.path.join(folder, "read.ply")
    said = run(program, ["meshlabserver", "-i", path, "-o", out] + (["-m", "vc"] if kind_of(out) != "xyz" else []))
    return exchange_points.read(need(out, said))


def pcl(program, path, folder, saved):
    first = os.path.join(folder, "read.pcd")
    said = run(program, {"ply": ["pcl_ply2pcd", "-format", "0", path, first], "pcd": ["pcl_convert_pcd_ascii_binary", path, first, "0"],
                         "obj": ["pcl_obj2pcd", path, first], "xyz": ["pcl_xyz2pcd", path, first]}[kind_of(path)])
    need(first, said)
    text = os.path.join(folder, "text.pcd")
    run(program, ["pcl_convert_pcd_ascii_binary", first, text, "0"])
    if saved:
        need(saved, run(program, ["pcl_pcd2ply", first, saved] if kind_of(saved) == "ply" else ["pcl_convert_pcd_ascii_binary", first, saved, "1"]))
    return exchange_points.read(text)


def libre_office(program, path, folder, saved):
    """A table is saved as it is shown; a drawing becomes a page."""
    out = os.path.join(folder, "office")
    if kind_of(path) == "dxf":
        said = run(program, ["soffice", "--headless", "--convert-to", "pdf", "--outdir", out, path])
        return ink(program, need(os.path.join(out, stem_of(path) + ".pdf"), said))
    said = run(program, ["soffice", "--headless", "--convert-to", "csv", "--outdir", out, path])
    made = need(os.path.join(out, stem_of(path) + ".csv"), said)
    if stem_of(path) == "rocks":
        rows = [line.split(",") for line in open(made)]
        return f"{len(rows) - 1} rows, {len(rows[0])} columns"
    if saved:
        shutil.copy(made, saved)
    return exchange_points.read(made)


def libre_cad(program, path, folder, _):
    path = shutil.copy(path, folder)
    out = path.replace(".dxf", ".pdf")  # it takes no other place
    said = run(program, ["librecad", "dxf2pdf", "-a", path])
    return ink(program, need(out, said))


def ink(program, pdf):
    run(program, ["pdftoppm", "-scale-to", "600", "-png", "-singlefile", pdf, pdf[:-4]])
    return drawn(program, pdf[:-4] + ".png")


def f3d(program, path, folder, _):
    out = os.path.join(folder, "picture.png")
    for _ in range(5):  # it sometimes ends with a segmentation fault before it opens the file
        said = run(program, ["f3d", path, "--output", out, "--resolution", "400,300", "--point-size", "3", "--no-background"])
        if os.path.exists(out):
            break
    return drawn(program, need(out, said))


def drawn(program, picture):
    """How much of a picture differs from its corner, by GDAL of the same system."""
    said = run(program, ["python3", "-c", "import sys; from osgeo import gdal; p = gdal.Open(sys.argv[1]).ReadAsArray(); "
                         "p = p if p.ndim == 3 else p[None]; "
                         "print((abs(p.astype(int) - p[:, :1, :1]) > 40).any(axis=0).mean())", picture])
    share = float(said.stdout.split()[-1])
    return f"a picture, {100 * share:.0f} % drawn" if share > 0.001 else "an empty picture"


def kind_of(path):
    return os.path.basename(path).split(".", 1)[1]


def stem_of(path):
    return os.path.basename(path).split(".", 1)[0]


# Commands that print a version.
def debian(package, program):
    return ["sh", "-c", f"command -v {program} >/dev/null && dpkg-query -W -f '${{Version}}' {package}"]


def npm(package):
    return ["node", "-p", f"require('{WHERE['modules']}/node_modules/{package}/package.json').version"]


def importing(module, version="__version__"):
    return ["python3", "-c", f"import {module} as m; print(m.{version})"]


# A program: the command that prints its version, what reads a file, the formats, the format that each is saved in, the formats that it
# reads in part or not at all, the files of rocks, whether it holds coordinates as 4-byte numbers, what it asks when a file of mine
# coordinates is opened by hand, and where it is.
Program = collections.namedtuple("Program", "name version reads formats saves refuses rocks four_bytes asks root",
                                 defaults=[{}, [], [], False, "nothing", ""])
ROCK_FILES = ["rocks.csv", "rocks.geojson", "rocks.dxf"]


def programs():
    python = lambda library, *interpreter: script("exchange_read.py", library, *(interpreter or ["python3"]))
    blender = python("blender", "blender", "-b", "--factory-startup", "-noaudio", "-P")
    r = lambda library: script("exchange_read.R", library, "Rscript")
    r_version = lambda package: ["Rscript", "-e", f"cat(as.character(packageVersion('{package}')))"]
    node = lambda library: script("exchange_read.mjs", library, "node")
    columns = "of CSV: the columns of x, y and z, and the coordinate system"
    return [
        Program("CloudCompare", debian("cloudcompare", "CloudCompare"), cloud_compare, ["xyz", "csv", "ply", "pcd", "las", "obj", "ptx"],
                saves={"ply": "ply", "xyz": "asc", "csv": "asc", "obj": "ply"}, refuses=["pcd", "las"],
                asks="*Global shift/scale*: *Yes*, with the shift that it suggests; saved files have the full coordinates again"),
        Program("MeshLab", debian("meshlab", "meshlabserver"), meshlab, ["xyz", "ply", "obj", "ptx"], saves={"ply": "ply", "obj": "obj", "xyz": "xyz"},
                refuses=["ptx"], four_bytes=True, asks="of XYZ and PTX: the options of the format, which can stay as they are"),
        Program("PCL tools", debian("pcl-tools", "pcl_ply2pcd"), pcl, ["xyz", "ply", "pcd", "obj"], saves={"pcd": "pcd", "ply": "ply", "xyz": "pcd"}, four_bytes=True),
        Program("Open3D", importing("open3d"), python("open3d"), ["xyz", "ply", "pcd"], saves={"xyz": "xyz", "ply": "ply", "pcd": "pcd"}),
        Program("ParaView", ["pvpython", "--version"], python("paraview", "pvpython"), ["csv", "ply", "obj"],
                saves={"csv": "csv", "ply": "ply"}, four_bytes=True,
                asks="of CSV: *Apply*, then the filter *Table To Points* with the columns of x, y and z"),
        Program("Blender", ["blender", "--version"], blender, ["ply", "obj"], saves={"ply": "ply", "obj": "obj"}, four_bytes=True,
                asks="the axes: *Forward Y*, *Up Z*, when opening and when saving"),
        Program("F3D", debian("f3d", "f3d"), f3d, ["ply", "obj"], four_bytes=True),
        Program("GDAL", importing("osgeo.gdal"), python("gdal"), ["csv", "dxf"], saves={"csv": "csv"}, rocks=ROCK_FILES),
        Program("QGIS", importing("qgis.core", "Qgis.version()"), python("qgis"), ["csv", "dxf"], saves={"csv": "csv"}, rocks=ROCK_FILES,
                asks=columns + ": that of the mine where it has an EPSG code, else *No CRS*"),
        Program("ezdxf", importing("ezdxf"), python("ezdxf"), ["dxf"], rocks=["rocks.dxf"]),
        Program("LibreCAD", debian("librecad", "librecad"), libre_cad, ["dxf"], rocks=["rocks.dxf"], four_bytes=True,
                asks="nothing; *Auto Zoom* shows the drawing"),
        Program("LibreOffice", ["soffice", "--version"], libre_office, ["csv", "dxf"], saves={"csv": "csv"}, rocks=["rocks.csv", "rocks.dxf"],
                asks="*Text Import*: separator comma, language English (USA), so that points are decimal points"),
        Program("R", ["Rscript", "-e", "cat(as.character(getRversion()))"], r("R"), ["csv", "xyz"], saves={"csv": "csv", "xyz": "xyz"},
                rocks=["rocks.csv"]),
        Program("R terra", r_version("terra"), r("terra"), ["csv"], saves={"csv": "csv"}, asks=columns + " (`geom`, `crs`)"),
        Program("R sf", r_version("sf"), r("sf"), ["csv", "dxf"], saves={"csv": "csv"}, rocks=["rocks.geojson", "rocks.dxf"],
                asks=columns + " (`coords`, `crs`)"),
        Program("pandas", importing("pandas"), python("pandas"), ["xyz", "csv"], saves={"xyz": "xyz", "csv": "csv"}, rocks=["rocks.csv"]),
        Program("numpy", importing("numpy"), python("numpy"), ["xyz"], saves={"xyz": "xyz"}),
        Program("laspy", importing("laspy"), python("laspy"), ["las"], saves={"las": "las"}),
        Program("three", npm("three"), node("three"), ["xyz", "ply", "pcd", "obj"], four_bytes=True),
        Program("loaders.gl", npm("@loaders.gl/core"), node("loaders.gl"), ["csv", "ply", "pcd", "las", "obj"], refuses=["las"], four_bytes=True),
        Program("copc", npm("copc"), node("copc"), ["las"]),
        Program("@mcap/core", npm("@mcap/core"), node("mcap"), ["mcap"]),
    ]


def found(program, roots):
    """The program with the root where it is, and its version; None where it is nowhere."""
    for root in roots + [""]:
        here = program._replace(root=root)
        try:
            said = run(here, program.version)
        except OSError:
            continue
        version = re.search(r"\d+\.\d[\w.]*", said.stdout)
        if said.returncode == 0 and version:
            return here, version[0]
    return program, None
