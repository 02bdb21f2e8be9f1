"""why, compare, report and benchmark against the programs."""
import json
import os
import pathlib
import pickle
import re
import subprocess
import unittest

import edgescan
from support import HERE, LAB, bell_file, cli, lab


def document(text):
    said = json.loads(text)
    del said["schema"]
    return said


class SameAsThePrograms(unittest.TestCase):
    def test_why(self):
        path = bell_file()
        for settings, flags in (({}, []), ({"method": "canny", "lower": 9}, ["--method", "canny", "--lower", 9])):
            result = edgescan.detect(edgescan.open(path), **settings)
            for cell in (0, int(result.edges[3]), int(result.edges[-1]), 5000):
                line, beam = divmod(cell, result.scan.beams)
                said = cli("why", path, "--cell", f"{line},{beam}", *flags).stdout
                self.assertEqual(edgescan.why(result, line, beam), document(said))
        with self.assertRaises(edgescan.Error) as raised:
            edgescan.why(result, result.scan.lines, 0)
        self.assertIn("lines run from 0 to 149", raised.exception.hint)

    def test_compare(self):
        before, now = bell_file(), HERE / "after.json"
        lab("simulate", "-o", now, "--after-blast", "--seed", 7, "--lines", 150, "--beams", 191)
        cli("compare", before, now, "--by-surfaces", "--json", HERE / "change.json", "--picture", HERE / "cli-change.png")
        change = edgescan.compare(edgescan.detect(edgescan.open(before)), edgescan.detect(edgescan.open(now)), by_surfaces=True,
                                  picture=HERE / "change.png")
        self.assertEqual(change, document((HERE / "change.json").read_text()))
        self.assertEqual((HERE / "change.png").read_bytes(), (HERE / "cli-change.png").read_bytes())
        self.assertTrue(change["regions"])

    def test_compare_with_poses(self):
        one = edgescan.detect(edgescan.open(bell_file()))
        still, moved = HERE / "still.pose", HERE / "moved.pose"
        still.write_text("0 0 0\n0 0 0\n")
        moved.write_text("0 0 5\n0 0 0\n")
        other = edgescan.detect(edgescan.open(bell_file("other.json", 8)))
        cli("compare", bell_file(), bell_file("other.json", 8), "--poses-3dtk", still, moved, "--json", HERE / "posed.json")
        self.assertEqual(edgescan.compare(one, other, poses=(still, moved)), document((HERE / "posed.json").read_text()))
        with self.assertRaises(edgescan.Error):
            edgescan.compare(one, other, poses=(still, HERE / "none.pose"))

    def test_a_picture_never_replaces_an_input(self):
        cli("convert", bell_file(), HERE / "input.pcd")
        before = (HERE / "input.pcd").read_bytes()
        for name, call in (("input.png", lambda r, p: edgescan.compare(r, r, picture=p)), ("input.html", edgescan.report)):
            path = HERE / name  # what a file is, its content says
            path.write_bytes(before)
            result = edgescan.detect(edgescan.open(path))
            with self.assertRaisesRegex(edgescan.Error, "read as an input"):
                call(result, path)
            self.assertEqual(path.read_bytes(), before)

    def test_names_of_other_formats(self):
        result = edgescan.detect(edgescan.simulate(lines=60, beams=80).scan)
        for call, part in ((lambda: edgescan.compare(result, result, picture=HERE / "c.jpg"), "ends with .png"),
                           (lambda: edgescan.report(result, HERE / "r.pdf"), "ends with .html; a browser prints")):
            with self.assertRaisesRegex(edgescan.Error, part):
                call()
        self.assertFalse((HERE / "c.jpg").exists() or (HERE / "r.pdf").exists())

    def test_two_methods(self):
        scan = edgescan.simulate(lines=60, beams=80).scan
        warnings = edgescan.compare(edgescan.detect(scan, method="canny"), edgescan.detect(scan))["warnings"]
        self.assertTrue(any("other settings, before with method canny and now with method edgescan+: " in warning for warning in warnings), warnings)
        warnings = edgescan.compare(edgescan.detect(scan), edgescan.detect(scan, jump=80, min_length=9))["warnings"]
        self.assertTrue(any("and now with jump 80, min_length 9: " in warning for warning in warnings), warnings)
        self.assertEqual(edgescan.compare(edgescan.detect(scan), edgescan.detect(scan))["warnings"], [])

    def test_rocks_of_another_scan(self):
        result, other = (edgescan.detect(edgescan.simulate(lines=60, beams=80, seed=seed).scan) for seed in (1, 2))
        rocks = edgescan.rocks(other)
        for call in (lambda: result.to_dict(rocks=rocks), lambda: result.save_npz(HERE / "mixed.npz", rocks=rocks),
                     lambda: edgescan.report(result, HERE / "mixed.html", rocks=rocks)):
            with self.assertRaisesRegex(edgescan.Error, "the rocks are of another scan; give those that"):
                call()
        self.assertFalse((HERE / "mixed.npz").exists() or (HERE / "mixed.html").exists())
        again = pickle.loads(pickle.dumps(other))
        self.assertIn("labels", again.to_dict(rocks=rocks))

    def test_a_folder_that_does_not_exist(self):
        with self.assertRaisesRegex(edgescan.Error, "nofolder.*: the folder to write into does not exist; make the folder"):
            edgescan.detect(edgescan.simulate(lines=60, beams=80).scan).save_npz(HERE / "nofolder" / "x.npz")

    def test_a_part_of_the_region(self):
        result = edgescan.detect(edgescan.simulate(lines=60, beams=80).scan)
        rocks = edgescan.rocks(result, region=[(10, 10), (500, 20)])
        self.assertEqual(rocks.warnings, ["A part of the region is outside of the scan; the rest counts."])
        self.assertEqual(rocks.at(1).warnings, rocks.warnings)
        self.assertEqual(edgescan.rocks(result).warnings, [])

    def page(self, path):
        """Without what differs from run to run: the time and the milliseconds."""
        return re.sub(r"\d{4}-\d\d-\d\d[T ][\d:.]+ ?(UTC|Z)|\d+(\.\d+)? ms", "", path.read_text())

    def test_report(self):
        path, out = bell_file(), HERE / "page.html"
        result = edgescan.detect(edgescan.open(path), jump=45)
        for more, flags in (({}, []), ({"rocks": edgescan.rocks(result, level=0.5)}, ["--rocks", "--level", 0.5]),
                            ({"before": edgescan.open(bell_file("other.json", 8)), "operator": "A. Miner", "role": "surveyor"},
                             ["--before", bell_file("other.json", 8), "--operator", "A. Miner", "--role", "surveyor"])):
            with self.subTest(flags=flags):
                self.assertEqual(edgescan.report(result, out, **more), out.stat().st_size)
                ours = self.page(out)
                command = re.search(r'<pre id="command">(.*?)</pre>', ours, re.S).group(1)
                out.unlink()
                cli("report", path, "-o", out, "--jump", 45, *flags)
                theirs = self.page(out)
                other = re.search(r'<pre id="command">(.*?)</pre>', theirs, re.S).group(1)
                self.assertEqual(ours.replace(command, ""), theirs.replace(other, ""))
                for flag in flags:
                    self.assertIn(getattr(flag, "name", str(flag)), command.replace("&#39;", "'"))
        with self.assertRaises(edgescan.Error):
            edgescan.report(result, HERE / "nowhere" / "x.html")

    def test_report_of_a_scan_in_memory(self):
        result = edgescan.detect(edgescan.simulate(lines=60, beams=80).scan)
        edgescan.report(result, HERE / "memory.html")
        self.assertIn("edgescan.save(scan, FILE)", (HERE / "memory.html").read_text())


class Benchmark(unittest.TestCase):
    def test_the_json_of_the_program(self):
        path, truth = bell_file(), HERE / "bell-truth"
        figures = edgescan.benchmark(path, truth=truth, only=["edgescan+", "canny"], repeats=1, program=LAB)
        said = subprocess.run([LAB, "benchmark", path, "--truth", truth, "--only", "edgescan+,canny", "--repeats", "1", "--json", "-"],
                              capture_output=True, text=True, check=True)
        for one, other in zip(figures["methods"], json.loads(said.stdout)["methods"], strict=True):
            self.assertEqual((one["method"], one["score"], one.get("edges")), (other["method"], other["score"], other.get("edges")))
        scan = edgescan.benchmark(edgescan.open(path), only="edgescan+", program=pathlib.Path(LAB))
        self.assertEqual([row["edges"] for row in scan["methods"] if row["method"] == "edgescan+"],
                         [row["edges"] for row in figures["methods"] if row["method"] == "edgescan+"])

    def test_refused(self):
        for call, part in ((lambda: edgescan.benchmark(HERE / "none.pcd", program=LAB), "none.pcd"),
                           (lambda: edgescan.benchmark(bell_file(), only="magic", program=LAB), "magic"),
                           (lambda: edgescan.benchmark(bell_file(), program=HERE / "no-lab"), "build it with packaging/build release")):
            with self.assertRaisesRegex(edgescan.Error, part):
                call()

    def test_the_module_has_no_code_of_the_laboratory(self):
        binary = next(pathlib.Path(edgescan.__file__).parent.glob("_edgescan*.so"))
        needed = subprocess.run(["nm", "-C", "--defined-only", os.fspath(binary)], capture_output=True, text=True, check=False).stdout
        self.assertNotIn("edgescan::lab::", needed)


if __name__ == "__main__":
    unittest.main(verbosity=1)
