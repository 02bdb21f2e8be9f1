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
    root = program.root
    if not root and command[0] == "python3":
        command = [sys.executable] + command[1:]
    if root:
        command = ["chroot", root, "env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/root", "LC_ALL=C.UTF-8", "LIBGL_ALWAYS_SOFTWARE=1"] + command
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=SECONDS)


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
    """A program that is read with by one of the scripts exchange_read.*."""
    def reads(program, path, folder, saved):
        out = os.path.join(folder, "points.f64")
        said = run(program, [*interpreter, os.path.join(WHERE["scripts"], name), *(["--"] if interpreter[0] == "blender" else []), library, path, out] + ([saved] if saved else []))
        if said.returncode == 0 and not os.path.exists(out):
            return said.stdout.strip()
        return rows_of(need(out, said))
    return reads


def node(library):
    def reads(program, path, folder, _):
        out = os.path.join(folder, "points.f64")
        said = run(program, ["node", os.path.join(WHERE["scripts"], "exchange_read.mjs"), WHERE["modules"], library, path, out])
        return said.stdout.strip() if said.returncode == 0 and not os.path.exists(out) else rows_of(need(out, said))
    return reads


def cloud_compare(program, path, folder, saved):
    out = os.path.join(folder, "read.asc")
    command = ["xvfb-run", "-a", "CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-O", "-GLOBAL_SHIFT", "AUTO", path,
               "-C_EXPORT_FMT", "ASC", "-PREC", "9", "-SEP", "SPACE", "-ADD_HEADER", "-SAVE_CLOUDS", "FILE", out]
    if saved:
        command += ["-C_EXPORT_FMT", kind_of(saved).upper(), "-SAVE_CLOUDS", "FILE", saved]
    said = run(program, command)
    if "unhandled file extension" in said.stdout.lower():
        raise RuntimeError("this build has no reader for it")
    return exchange_points.read(need(out, said))


def meshlab(program, path, folder, saved):
    out = saved or os.path.join(folder, "read.ply")
    said = run(program, ["xvfb-run", "-a", "meshlabserver", "-i", path, "-o", out] + (["-m", "vc"] if kind_of(out) != "xyz" else []))
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
    if saved:
        shutil.copy(made, saved)
    return exchange_points.read(made)


def libre_cad(program, path, folder, _):
    out = os.path.join(folder, "page.pdf")
    said = run(program, ["xvfb-run", "-a", "librecad", "dxf2pdf", "-a", "-o", out, path])
    return ink(program, need(out, said))


def ink(program, pdf):
    run(program, ["pdftoppm", "-r", "50", "-gray", "-singlefile", pdf, pdf[:-4]])
    data = open(need(pdf[:-4] + ".pgm", run(program, ["true"])), "rb").read()
    width, height = (int(n) for n in data.split()[1:3])
    return drawn(numpy.frombuffer(data, "u1", width * height, len(data) - width * height) < 200)


def f3d(program, path, folder, _):
    out = os.path.join(folder, "picture.bmp")
    said = run(program, ["xvfb-run", "-a", "f3d", path, "--output", out, "--resolution", "400,300", "--point-size", "3", "--no-background"])
    data = open(need(out, said), "rb").read()
    start = int.from_bytes(data[10:14], "little")
    picture = numpy.frombuffer(data, "u1", 400 * 300 * 3, start).reshape(-1, 3)
    return drawn((picture != picture[0]).any(axis=1))


def drawn(pixels):
    return f"a picture, {100 * pixels.mean():.0f} % drawn" if pixels.mean() > 0.001 else "an empty picture"


def kind_of(path):
    return os.path.basename(path).split(".", 1)[1]


def stem_of(path):
    return os.path.basename(path).split(".", 1)[0]


def importing(module, version="__version__"):
    return ["python3", "-c", f"import {module} as m; print(m.{version})"]


def packaged(name):
    """The version of a package of npm."""
    return ["node", "-p", f"require('{WHERE['modules']}/node_modules/{name}/package.json').version"]


# A program: the command that prints its version, what reads a file, the formats, the format that each is saved in, whether it holds
# coordinates as 4-byte numbers, what it asks when a file of mine coordinates is opened by hand, the formats that it reads in part or not
# at all, and where it is.
Program = collections.namedtuple("Program", "name version reads formats saves four_bytes asks refuses root", defaults=[{}, False, "", [], ""])


def programs():
    python = lambda library, *interpreter: script("exchange_read.py", library, *(interpreter or ["python3"]))
    r = lambda library: script("exchange_read.R", library, "Rscript")
    return [
        Program("CloudCompare", ["dpkg-query", "-W", "-f", "${Version}", "cloudcompare"], cloud_compare, ["xyz", "csv", "ply", "pcd", "las", "obj", "ptx", "dxf"],
                {"ply": "ply", "xyz": "asc", "csv": "asc", "obj": "ply"}, refuses=["pcd", "las"], asks="*Global shift/scale*: answer *Yes* with the shift that it suggests; it saves the shift with the cloud"),
        Program("MeshLab", ["dpkg-query", "-W", "-f", "${Version}", "meshlab"], meshlab, ["xyz", "ply", "obj", "ptx"],
                {"ply": "ply", "obj": "obj", "xyz": "xyz"}, four_bytes=True, refuses=["ptx"], asks="Nothing; of PTX the pre-open options"),
        Program("PCL tools", ["dpkg-query", "-W", "-f", "${Version}", "pcl-tools"], pcl, ["xyz", "ply", "pcd", "obj"],
                {"pcd": "pcd", "ply": "ply", "xyz": "pcd"}, four_bytes=True, asks="Nothing"),
        Program("Open3D", importing("open3d"), python("open3d"), ["xyz", "ply", "pcd"], {"xyz": "xyz", "ply": "ply", "pcd": "pcd"}, asks="Nothing"),
        Program("ParaView", ["pvpython", "--version"], python("paraview", "pvpython"), ["csv", "ply", "obj"], {"csv": "csv", "ply": "ply"}, four_bytes=True,
                asks="Of CSV: *Apply*, then the filter *Table To Points* with its three columns"),
        Program("Blender", ["blender", "--version"], python("blender", "blender", "-b", "--factory-startup", "-noaudio", "-P"), ["ply", "obj"],
                {"ply": "ply", "obj": "obj"}, four_bytes=True, asks="The axes: choose *Forward Y*, *Up Z*"),
        Program("F3D", ["dpkg-query", "-W", "-f", "${Version}", "f3d"], f3d, ["ply", "obj", "dxf"], four_bytes=True, asks="Nothing"),
        Program("GDAL", importing("osgeo.gdal"), python("gdal"), ["csv", "dxf"], {"csv": "csv"}, asks="Nothing"),
        Program("QGIS", importing("qgis.core", "Qgis.version()"), python("qgis"), ["csv", "dxf"], {"csv": "csv"},
                asks="The coordinate system: the mine's, where it has an EPSG code, else *No CRS*; of CSV the X, Y and Z field"),
        Program("ezdxf", importing("ezdxf"), python("ezdxf"), ["dxf"], asks="Nothing"),
        Program("LibreCAD", ["dpkg-query", "-W", "-f", "${Version}", "librecad"], libre_cad, ["dxf"], asks="Nothing; *Auto Zoom* shows the drawing"),
        Program("LibreOffice", ["soffice", "--version"], libre_office, ["csv", "dxf"], {"csv": "csv"},
                asks="*Text Import*: separator comma, language English (USA), so that points are decimal points"),
        Program("R", ["Rscript", "-e", "cat(as.character(getRversion()))"], r("R"), ["csv", "xyz"], {"csv": "csv", "xyz": "xyz"}, asks="Nothing"),
        Program("R terra", ["Rscript", "-e", "cat(as.character(packageVersion('terra')))"], r("terra"), ["csv"], {"csv": "csv"}, asks="The names of the columns and `crs`"),
        Program("R sf", ["Rscript", "-e", "cat(as.character(packageVersion('sf')))"], r("sf"), ["csv", "dxf"], {"csv": "csv"}, asks="The names of the columns and `crs`"),
        Program("pandas", importing("pandas"), python("pandas"), ["xyz", "csv"], {"xyz": "xyz", "csv": "csv"}, asks="Nothing"),
        Program("numpy", importing("numpy"), python("numpy"), ["xyz"], {"xyz": "xyz"}, asks="Nothing"),
        Program("laspy", importing("laspy"), python("laspy"), ["las"], {"las": "las"}, asks="Nothing"),
        Program("three", packaged("three"), node("three"), ["xyz", "ply", "pcd", "obj"], four_bytes=True, asks="Nothing"),
        Program("loaders.gl", packaged("@loaders.gl/core"), node("loaders.gl"), ["csv", "ply", "pcd", "las", "obj"], four_bytes=True, refuses=["las"], asks="Nothing"),
        Program("copc", packaged("copc"), node("copc"), ["las"], asks="Nothing"),
        Program("@mcap/core", packaged("@mcap/core"), node("mcap"), ["mcap"], asks="Nothing"),
        Program("Foxglove's schemas", packaged("@foxglove/schemas"), node("foxglove"), ["foxglove.mcap"], asks="Nothing; the display frame: `mine` or `scanner`"),
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
