"""The page docs/reference/python.md, the folder examples, the docstrings, the type stubs and the types of the reports."""
import ast
import doctest
import importlib.util
import inspect
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import edgescan
from edgescan import reports
from support import CLI, HERE, LAB, SOURCE, bell_file, cli, recording_file, served


def can_run(code):
    """Whether every package that the code imports is there; if not, it prints the code that is left out."""
    absent = [name for name in sorted(set(re.findall(r"^(?:import|from) (\w+)", code, re.M))) if importlib.util.find_spec(name) is None]
    if absent:
        print(f"left out, {', '.join(absent)} is not there:\n{code}", file=sys.stderr)
    return not absent


class Documents(unittest.TestCase):
    def test_docstrings(self):
        bell = edgescan.simulate(seed=7, lines=120, beams=161, truth=True)
        result = edgescan.detect(bell.scan)
        runner = doctest.DocTestRunner()
        with served(bell_file("small.json", 5, 40, 96), "--rate", 400) as address:
            names = {"edgescan": edgescan, "bell": bell, "scan": bell.scan, "result": result, "path": bell_file(), "folder": HERE,
                     "recording": recording_file(), "address": address, "lab": LAB}
            for thing in [edgescan, *(getattr(edgescan, name) for name in edgescan.__all__)]:
                for test in doctest.DocTestFinder(recurse=False).find(thing, getattr(thing, "__name__", ""), False, None, names):
                    runner.run(test)
        self.assertEqual(runner.summarize(), (0, runner.tries))
        self.assertGreaterEqual(runner.tries, 25)

    def page(self, runs=True):
        """The examples of the page: one script of all that follow each other, and those that are scripts of their own. If it runs, what
        needs a package that is not there is left out."""
        together, own = [], []
        for block in re.findall(r"```python\n(.*?)```", (SOURCE / "docs/reference/python.md").read_text(), re.S):
            if not runs or can_run(block):
                (own if "__main__" in block else together).append(block)
        self.assertGreaterEqual(len(together), 8)
        return ["".join(together), *own]

    def test_the_page_runs_as_a_script(self):
        folder = HERE / "page"
        folder.mkdir()
        (folder / "BELL.mcap").write_bytes(recording_file().read_bytes())
        cli("convert", bell_file(), folder / "BELL.pcd")
        environment = dict(os.environ, PATH=os.path.dirname(LAB) + os.pathsep + os.environ["PATH"])
        with served(bell_file("small.json", 5, 40, 96), "--rate", 400) as address:
            for number, script in enumerate(self.page()):
                path = folder / f"page{number}.py"
                path.write_text(script.replace("192.168.0.1", address))
                run = subprocess.run([sys.executable, path.name], cwd=folder, env=environment, capture_output=True, text=True, check=False)
                self.assertEqual(run.returncode, 0, script + run.stderr)
        for made in ("edges.ply", "OWN.json", "change.png", "report.html", "SIMULATED.json", "TRUTH/gt_class.png", "live.mcap"):
            self.assertTrue((folder / made).exists(), made)

    def test_the_notebook_runs_as_a_script(self):
        cells = json.loads((SOURCE / "examples/edges.ipynb").read_text(encoding="utf-8"))["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        self.assertGreaterEqual(len(code), 5)
        self.assertEqual([cell for cell in cells if cell.get("outputs")], [])
        shutil.copytree(SOURCE / "examples", HERE / "notebook")
        run = subprocess.run([sys.executable, "-c", "\n".join(filter(can_run, code))], cwd=HERE / "notebook", capture_output=True, text=True,
                             env=dict(os.environ, MPLBACKEND="Agg"), check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        for said in ("cells: jump", "edge cells", "rocks; the ten", "['edges.ply', 'edges.ply.provenance.json']"):
            self.assertIn(said, run.stdout)

    def test_the_script_of_an_archive(self):
        archive = HERE / "archive"
        (archive / "50% off").mkdir(parents=True)
        for name in ("stones.json", "stones.u16"):
            shutil.copyfile(SOURCE / "examples" / name, archive / "50% off" / name)

        def script(*arguments):
            return subprocess.run([SOURCE / "examples/batch.sh", *arguments], cwd=HERE, env=dict(os.environ, EDGESCAN_CLI=CLI),
                                  capture_output=True, text=True, check=False)

        whole = script(archive, "results")
        self.assertEqual((whole.returncode, whole.stdout.count(": identical to ")), (0, 3), whole.stdout + whole.stderr)
        (archive / "bad.pcd").write_text("no scan\n")
        self.assertEqual(script(archive, "results").returncode, 4)
        cloud = next((HERE / "results").rglob("*.ply"))
        cloud.write_bytes(cloud.read_bytes()[:-1] + b"x")
        altered = script(archive, "results")
        self.assertEqual((altered.returncode, altered.stdout.count(": NOT identical to ")), (3, 1), altered.stdout + altered.stderr)
        self.assertEqual(script(archive).returncode, 2)

    def test_the_sample_has_its_credits(self):
        page = (SOURCE / "examples/README.md").read_text(encoding="utf-8")
        for credit in ("NASA JSC Astromaterials 3D", "Poly Haven", "EDUROCK", "Aalto University", "CC0 1.0", "CC-BY-4.0", '"Biotite"', '"Sphalerite"'):
            self.assertIn(credit, page)

    def test_the_figures_of_the_readme_are_those_of_the_pages(self):
        readme = (SOURCE / "README.md").read_text(encoding="utf-8")
        part = readme[readme.index("## How well it works"):readme.index("## Why not")]

        def rows(text):
            return [[field.strip().replace("*", "") for field in line.strip("|").split("|")] for line in text.split("\n") if line.startswith("| ")]

        tables = (SOURCE / "docs/measurements/accuracy.md").read_text(encoding="utf-8").split("\nF of ")
        every, outlines = ({row[0]: row[2:] for row in rows(table)} for table in tables[1:3])
        families = [row for row in rows(part) if row[0] in every and row[0] != "family"]
        self.assertGreaterEqual(len(families), 10)
        for name, *cells in families:
            shown, rock_borders, gray, log_range, thesis = cells
            self.assertEqual(shown, every[name][0], name)
            self.assertEqual([rock_borders, thesis, log_range, gray], [outlines[name][n] for n in (1, 3, 4, 5)], name)
            best = max(outlines[name], key=lambda cell: float(cell.split()[0]))
            self.assertIn(f"**{best.split()[0]}**", next(line for line in part.split("\n") if line.startswith(f"| {name} |")), name)
        self.assertIn(max(every[name][n].split()[0] for name, *_ in families for n in (3, 4, 5)), part)
        cited = [line for line in part.split("\n") if line.startswith("| [") or line.startswith("| the same")]
        self.assertGreaterEqual(len(cited), 5)
        for line in cited:
            page, label = re.search(r"\(([^)#]+)", line).group(1), re.sub(r"\([^)]*\)", "", line)
            text = (SOURCE / page).read_text(encoding="utf-8")
            for number in re.findall(r"\d*\.\d+", label):
                self.assertIn(number, text, line)
        install = (SOURCE / "docs/guide/install.md").read_text(encoding="utf-8")
        for figure in ("303 s", "0.7 GB"):
            self.assertTrue(figure in readme and figure in install, figure)

    def test_workflows_call_scripts_that_exist(self):
        for name, calls in (("ci", [".ci/run"]), ("release", ["packaging/install-packages", "packaging/make-deb", "packaging/test-deb"]),
                            ("manual", ["packaging/apt-install", "docs/make-manual"])):
            text = (SOURCE / f".github/workflows/{name}.yml").read_text()
            found = re.findall(r"(?<![\w/.])(?:packaging|docs|\.ci)/[\w-]+", "".join(re.findall(r"^ +(?:- )?run: .*\n", text, re.M)))
            self.assertLessEqual(set(calls), set(found), name)
            for script in found:
                self.assertTrue(os.access(SOURCE / script, os.X_OK), f"{name}.yml calls {script}")

    def test_every_library_has_its_licence(self):
        page = (SOURCE / "docs/reference/third-party.md").read_text()
        rows = {line.split("|")[1].strip().rstrip(" *") for line in page.splitlines() if line.startswith("| ")}
        opencv, lapack = "OpenCV (core, imgproc)", "LAPACK, BLAS"
        # As CMake names it, and its row; the C library and a tool have none.
        row_of = {"bullet": "Bullet", "bzip2": "bzip2", "cli11": "CLI11", "edgescan_blas": lapack, "edgescan_glx": "GLX of libglvnd",
                  "edgescan_lapack": lapack, "edgescan_opencv_": opencv, "edgescan_pcl_": "PCL", "eigen3": "Eigen", "laszip": "LASzip",
                  "lz4": "LZ4", "lzf": "LibLZF", "nlohmann_json": "JSON for Modern C++", "opencv": opencv, "openssl": "OpenSSL (libcrypto)",
                  "pkgconfig": None, "png": "libpng", "proj": "PROJ", "pugixml": "pugixml", "pybind11": "pybind11", "python3": "Python",
                  "qt": "Qt (Core, Gui, Widgets)", "sqlite3": "SQLite", "tbb": "oneTBB", "threads": None, "tiff": "LibTIFF", "vtk": "VTK",
                  "zlib": "zlib", "zstd": "zstd"}
        found = set()
        for folder, kind in ((folder, kind) for folder in ("core", "ui", "app") for kind in ("CMakeLists.txt", "*.cmake")):
            for path in (SOURCE / "CMakeLists.txt", *(SOURCE / folder).rglob(kind)):
                text = re.sub(r"#.*", "", path.read_text())
                found |= {name.lower() for name in re.findall(r"(?:find_package|pkg_check_modules|find_library)\((\w+)", text)}
                found |= {name.lower() for names in re.findall(r"foreach\(library ([A-Z0-9 ]+)\)", text) for name in names.split()}
        found = {name.removesuffix("_library") for name in found}
        self.assertEqual(found, set(row_of), "a library of CMake without a row in this table, or a row without a library")
        self.assertLessEqual({row for row in row_of.values() if row}, rows)

    def test_the_citation_has_the_version(self):
        version = re.search(r"project\(EdgeScan VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text())
        assert version
        self.assertIn(f"\nversion: {version[1]}\n", (SOURCE / "CITATION.cff").read_text())

    def mypy(self, *arguments):
        if importlib.util.find_spec("mypy") is None:
            self.skipTest("needs mypy, which is not installed")
        run = subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, check=False, cwd=HERE,
                             env=dict(os.environ, MYPYPATH=str(pathlib.Path(edgescan.__file__).parent.parent)))
        return run.returncode, run.stdout + run.stderr

    def test_mypy_accepts_the_page(self):
        for number, script in enumerate(self.page(runs=False)):
            path = HERE / f"typed{number}.py"
            path.write_text(script)
            code, said = self.mypy("mypy", "--strict", "--ignore-missing-imports", str(path))
            self.assertEqual(code, 0, said)

    def test_mypy_refuses_mistakes(self):
        user = HERE / "user.py"
        lines = ["edgescan.open(5)", "edgescan.open('x', axis='spun')", "edgescan.detect('x')", "edgescan.detect(scan, jumps=3)",
                 "edgescan.Scan([[1.0]], [1.0], [1.0])", "scan.xyz('moon')", "scan.lines = 3", "edgescan.connect('host', timeout=None)",
                 "edgescan.why(result, 1.5, 2)", "edgescan.compare(result, result)['edge']", "edgescan.Result()", "result.report()['edges'] + 'x'"]
        user.write_text("import edgescan\nscan = edgescan.open('x')\nresult = edgescan.detect(scan)\n" + "\n".join(lines) + "\n")
        _, said = self.mypy("mypy", "--strict", str(user))
        wrong = {int(n) - 3 for n in re.findall(r"user\.py:(\d+): error", said)}
        self.assertEqual(wrong, set(range(1, len(lines) + 1)), said)

    def test_the_stubs_are_those_of_the_module(self):
        allowed = HERE / "allowed"
        classes = "|".join(name for name in edgescan.__all__ if inspect.isclass(getattr(edgescan, name)))  # their metaclass is the binding's
        allowed.write_text("edgescan\\._.*\nedgescan\\.Path\nedgescan\\.reports\\..*\nedgescan\\.(" + classes + ")(\\.__init__|\\.__signature__)?\n")
        code, said = self.mypy("mypy.stubtest", "edgescan", "--allowlist", str(allowed), "--ignore-unused-allowlist")
        self.assertEqual(code, 0, said)

    def test_stubs_name_everything(self):
        stubs = pathlib.Path(edgescan.__file__).with_suffix(".pyi").read_text()
        tree = {node.name: node for node in ast.parse(stubs).body if hasattr(node, "name")}
        self.assertEqual(set(tree), set(edgescan.__all__))
        for name, node in tree.items():
            if isinstance(node, ast.FunctionDef):
                shown = [a.arg for a in node.args.args + node.args.kwonlyargs]
                self.assertEqual(shown, list(inspect.signature(getattr(edgescan, name)).parameters))
            elif not name.endswith("Error"):
                methods = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
                made = [a.arg for a in methods["__init__"].args.args[1:] + methods["__init__"].args.kwonlyargs]
                self.assertEqual(made, list(inspect.signature(edgescan.Scan).parameters) if name == "Scan" else ["made_by_functions"])
                for own in dir(getattr(edgescan, name)):
                    if not own.startswith("_"):
                        self.assertIn(own, methods, name)

    def test_stubs_have_the_docstrings(self):
        stubs = pathlib.Path(edgescan.__file__).with_suffix(".pyi").read_text()
        for node in ast.parse(stubs).body:
            if not isinstance(node, (ast.ClassDef, ast.FunctionDef)) or node.name.endswith("Error"):
                continue
            thing = getattr(edgescan, node.name)
            self.assertEqual(ast.get_docstring(node), inspect.cleandoc(thing.__doc__), node.name)
            for own in node.body if isinstance(node, ast.ClassDef) else []:
                if isinstance(own, ast.FunctionDef) and not own.name.startswith("_"):
                    self.assertEqual(ast.get_docstring(own), inspect.cleandoc(getattr(thing, own.name).__doc__), f"{node.name}.{own.name}")

    def test_the_dicts_have_the_keys_of_their_types(self):
        bell = edgescan.simulate(seed=7, lines=120, beams=161)
        opened = edgescan.open(bell_file())
        result = edgescan.detect(bell.scan)
        line, beam = divmod(int(result.edges[0]), 161)
        after = edgescan.detect(edgescan.simulate(seed=7, lines=120, beams=161, after_blast=True).scan)
        change = edgescan.compare(result, after, by_surfaces=True)
        self.assertTrue(change["regions"])
        for kind, report in ((reports.Info, bell.scan.info()), (reports.Info, opened.info()), (reports.Detected, result.report()),
                             (reports.Detected, edgescan.detect(opened, fill=3).report()),
                             (reports.Detected, edgescan.detect(opened, method="canny").report()), (reports.Why, edgescan.why(result, line, beam)),
                             (reports.Why, edgescan.why(edgescan.detect(opened, method="sobel"), 0, 0)), (reports.Compared, change),
                             (reports.Compared, edgescan.compare(result, result)), (reports.Region, change["regions"][0]),
                             (reports.Limits, result.report()["range_mm"]), (reports.Roughness, edgescan.detect(bell.scan, preset="default-4").report()["roughness"]),
                             (reports.RockBorders, result.report()["rock_borders"]),
                             (reports.Rock, edgescan.rocks(result).table[0]), (reports.Rock, edgescan.rocks(result).table_in("scanner")[0]),
                             (reports.RockRegion, edgescan.rocks(result).region_table[0]), (reports.Parameter, edgescan.parameters()[0])):
            self.assertLessEqual(kind.__required_keys__, set(report), kind)
            self.assertLessEqual(set(report), set(kind.__annotations__), kind)

    def test_everything_has_a_docstring(self):
        for name in edgescan.__all__:
            thing = getattr(edgescan, name)
            self.assertTrue(thing.__doc__, name)
            if inspect.isclass(thing) and not issubclass(thing, Exception):
                for own, value in vars(thing).items():
                    if isinstance(value, property):
                        self.assertTrue(value.__doc__, f"{name}.{own}")


if __name__ == "__main__":
    unittest.main(verbosity=1)
