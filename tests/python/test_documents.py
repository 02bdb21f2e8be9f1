"""The page docs/reference/python.md, the docstrings, the type stubs and the types of the reports."""
import ast
import doctest
import importlib.util
import inspect
import os
import pathlib
import re
import subprocess
import sys
import unittest

import edgescan
from edgescan import reports
from support import HERE, LAB, SOURCE, bell_file, cli, recording_file, served


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
            absent = [name for name in set(re.findall(r"^(?:import|from) (\w+)", block, re.M)) if importlib.util.find_spec(name) is None]
            if absent and runs:
                print(f"left out, {', '.join(absent)} is not there:\n{block}", file=sys.stderr)
            else:
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
            elif name != "Error":
                methods = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
                made = [a.arg for a in methods["__init__"].args.args[1:] + methods["__init__"].args.kwonlyargs]
                self.assertEqual(made, list(inspect.signature(edgescan.Scan).parameters) if name == "Scan" else ["made_by_functions"])
                for own in dir(getattr(edgescan, name)):
                    if not own.startswith("_"):
                        self.assertIn(own, methods, name)

    def test_stubs_have_the_docstrings(self):
        stubs = pathlib.Path(edgescan.__file__).with_suffix(".pyi").read_text()
        for node in ast.parse(stubs).body:
            if not isinstance(node, (ast.ClassDef, ast.FunctionDef)) or node.name == "Error":
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
            if inspect.isclass(thing) and thing is not edgescan.Error:
                for own, value in vars(thing).items():
                    if isinstance(value, property):
                        self.assertTrue(value.__doc__, f"{name}.{own}")


if __name__ == "__main__":
    unittest.main(verbosity=1)
