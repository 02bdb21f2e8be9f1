"""The Python module against the command line, numpy and the documents.

Run by ctest (python.module) with PYTHONPATH, EDGESCAN_CLI, EDGESCAN_SOURCE and EDGESCAN_SHARED_DIR (EDGESCAN_SHARED before it).
"""
import ast
import contextlib
import copy
import doctest
import fractions
import gc
import hashlib
import importlib.util
import inspect
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import edgescan

CLI = os.environ["EDGESCAN_CLI"]
SOURCE = pathlib.Path(os.environ["EDGESCAN_SOURCE"])
SHARED = pathlib.Path(os.environ.get("EDGESCAN_SHARED") or os.environ["EDGESCAN_SHARED_DIR"])
FOLDER = tempfile.TemporaryDirectory(prefix="edgescan-python-")
HERE = pathlib.Path(FOLDER.name)


def cli(*arguments, code=0):
    run = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert run.returncode == code, (arguments, run.returncode, run.stderr)
    return run


def bell_file(name="bell.json", seed=7, lines=150, beams=191):
    path = HERE / name
    if not path.exists():
        cli("simulate", "-o", path, "--truth", HERE / (path.stem + "-truth"), "--seed", seed, "--lines", lines, "--beams", beams)
    return path


def recording_file():
    path = HERE / "bell.mcap"
    if not path.exists():
        small = bell_file("small.json", 5, 40, 96)
        cli("convert", small, path)
    return path


@contextlib.contextmanager
def served(path, *arguments):
    """HOST:PORT of an emulated scanner that sends this scan."""
    process = subprocess.Popen([CLI, "serve", str(path), "--port", "0", *map(str, arguments)], stdout=subprocess.PIPE, text=True)
    try:
        said = json.loads(process.stdout.readline())
        yield f"{said['host']}:{said['port']}"
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


class SameAsTheCommandLine(unittest.TestCase):
    def cases(self):
        methods = next(row for row in edgescan.parameters() if row["key"] == "method")["choices"]
        self.assertGreater(len(methods), 10)
        yield {}
        for method in methods:
            yield {"method": method}
        for preset in edgescan.presets():
            yield {"preset": preset}
        yield {"lower": 10}
        yield {"lower": "5 %"}
        yield {"jump": 45.5, "min_length": 9, "classes": ["jump", "concave"], "slips": False}
        yield {"preset": "thesis", "lower": 7.25, "kernel": 5, "mask_missing": True}
        yield {"method": "canny", "near": 2500, "far": np.float64(9000), "aperture": np.int64(5), "norm": "l2"}

    def compare(self, path):
        scan = edgescan.open(path)
        for case in self.cases():
            with self.subTest(path=path.name, **{k: str(v) for k, v in case.items()}):
                flags = []
                for name, value in case.items():
                    text = {True: "on", False: "off"}.get(value) if isinstance(value, bool) else None
                    text = text or (",".join(value) if isinstance(value, list) else str(value))
                    flags += ["--" + name.replace("_", "-"), text]
                said = json.loads(cli("detect", path, "--json", "-", *flags).stdout)
                result = edgescan.detect(scan, **case)
                own = hashlib.sha256(np.ascontiguousarray(result.mask).tobytes()).hexdigest()
                self.assertEqual(own, said["edge_mask_sha256"])
                self.assertEqual(result.mask_sha256, own)
                self.assertEqual(result.settings, said["settings"])
                self.assertEqual(np.count_nonzero(result.mask), said["edges"])

    def test_masks_of_a_bell(self):
        self.compare(bell_file())

    def test_masks_of_a_real_scan(self):
        real = SHARED / "data" / "lms200_corridor"
        scans = sorted(real.glob("*.3d"))
        if not scans:
            self.skipTest(f"needs {real}, which is not there")
        self.compare(scans[0])

    def test_files_are_the_same_bytes(self):
        path = bell_file()
        result = edgescan.detect(edgescan.open(path), jump=50)
        for flag, content, name in (("--edges", "edges", "e.pcd"), ("--cloud", "cloud", "c.ply"), ("--mask", "mask", "m.png"),
                                    ("--gray", "gray", "g.png"), ("--range", "range", "r.png")):
            cli("detect", path, "--jump", 50, flag, HERE / ("cli-" + name))
            (HERE / "python").mkdir(exist_ok=True)
            edgescan.save(result, HERE / "python" / name, content)
            self.assertEqual((HERE / "python" / name).read_bytes(), (HERE / ("cli-" + name)).read_bytes(), name)
        cli("convert", path, HERE / "cli-whole.pcd")
        edgescan.save(result.scan, HERE / "python" / "whole.pcd")
        self.assertEqual((HERE / "python" / "whole.pcd").read_bytes(), (HERE / "cli-whole.pcd").read_bytes())
        said = cli("verify", HERE / "python" / "e.pcd", "--scans", HERE).stdout
        self.assertIn("identical", said)

    def test_simulation_and_truth(self):
        path = bell_file()
        bell = edgescan.simulate(seed=7, lines=150, beams=191, truth=True)
        opened = edgescan.open(path)
        np.testing.assert_array_equal(bell.scan.range_mm, opened.range_mm)
        np.testing.assert_array_equal(bell.scan.state, opened.state)
        bell.save_truth(str(HERE / "again-truth"))
        for name in ("gt_class.png", "gt_ignore.png", "rocks.json", "scene.json"):
            self.assertEqual((HERE / "again-truth" / name).read_bytes(), (HERE / "bell-truth" / name).read_bytes(), name)


class Arrays(unittest.TestCase):
    def setUp(self):
        self.scan = edgescan.open(bell_file())

    def test_no_copies(self):
        result = edgescan.detect(self.scan)
        for owner, name in ((self.scan, "range_mm"), (self.scan, "state"), (self.scan, "line_deg"), (result, "mask"), (result, "classes"),
                            (result, "strength"), (result, "edges")):
            first, second = getattr(owner, name), getattr(owner, name)
            self.assertEqual(first.__array_interface__["data"], second.__array_interface__["data"], name)
            self.assertFalse(first.flags.writeable or first.flags.owndata, name)
            with self.assertRaises(ValueError):
                first[...] = 1
        self.assertIs(type(self.scan.range_mm), np.ndarray)
        self.assertIsNone(self.scan.intensity)
        self.assertEqual(self.scan.range_mm.dtype, np.float32)
        self.assertEqual((result.mask.dtype, result.strength.dtype), (np.uint8, np.float64))

    def test_arrays_outlive_the_scan(self):
        scan = edgescan.simulate(seed=2, lines=60, beams=70).scan
        ranges = scan.range_mm
        before = ranges.copy()
        del scan
        gc.collect()
        edgescan.simulate(seed=3, lines=60, beams=70)
        np.testing.assert_array_equal(ranges, before)

    def test_points_by_the_formula_of_the_documents(self):
        for axis in ("sweep", "spin"):
            scan = edgescan.simulate(seed=4, lines=50, beams=61, axis=axis).scan
            r = np.where(scan.state == 0, scan.range_mm.astype(np.float64) / 1000, np.nan)
            a, p = np.radians(scan.beam_deg)[None, :], np.radians(scan.line_deg)[:, None]
            wanted = (np.stack([r * np.cos(a), -r * np.sin(a) * np.sin(p), r * np.sin(a) * np.cos(p)], -1) if axis == "sweep" else
                      np.stack([r * np.cos(a) * np.cos(p), r * np.cos(a) * np.sin(p), r * np.sin(a) + 0 * p], -1))
            found = scan.xyz()
            self.assertEqual((found.dtype, found.shape), (np.float64, (50, 61, 3)))
            np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12)
            self.assertEqual(scan.axis, axis)

    def test_the_mine(self):
        self.assertIsNone(self.scan.origin)
        with self.assertRaisesRegex(edgescan.Error, "no place in the mine"):
            self.scan.xyz("mine")
        pose, calibration = HERE / "pose.json", HERE / "robot.json"
        blocks = re.findall(r"```json\n(.*?)```", (SOURCE / "docs/coordinates.md").read_text(), re.S)
        calibration.write_text(next(b for b in blocks if "edgescan-calibration/1" in b))
        pose.write_text(next(b for b in blocks if "edgescan-pose/1" in b))
        spun = HERE / "spun.json"
        cli("simulate", "-o", spun, "--axis", "spin", "--lines", 90, "--beams", 120)
        scan = edgescan.open(spun, pose=pose, calibration=calibration)
        self.assertEqual(scan.origin.shape, (3,))
        np.testing.assert_allclose(scan.xyz("local") + scan.origin, scan.xyz("mine"), rtol=0, atol=1e-6)
        distances = np.linalg.norm(scan.xyz("local")[40, 50] - scan.xyz("local")[41, 60])
        np.testing.assert_allclose(distances, np.linalg.norm(scan.xyz()[40, 50] - scan.xyz()[41, 60]), atol=5e-3)

    def test_strength_is_the_threshold(self):
        for settings in ({}, {"method": "canny", "lower": 9}, {"method": "sobel", "lower": 60}, {"method": "log-range"}):
            result = edgescan.detect(self.scan, **settings)
            value = result.settings[result.threshold]
            own = result.strength > value if settings.get("method") == "sobel" else result.strength >= value
            np.testing.assert_array_equal(own, result.mask > 0, str(settings))

    def test_classes(self):
        result = edgescan.detect(self.scan)
        np.testing.assert_array_equal(result.classes > 0, result.mask > 0)
        np.testing.assert_array_equal(np.flatnonzero(result.mask), result.edges)
        self.assertIsNone(edgescan.detect(self.scan, preset="thesis").classes)
        self.assertEqual({key: int(np.count_nonzero(result.classes == k)) for k, key in enumerate(("jump", "convex", "concave"), 1)},
                         {k: result.report()["classes"][k] for k in ("jump", "convex", "concave")})


class Rocks(unittest.TestCase):
    def test_labels_and_table(self):
        result = edgescan.detect(edgescan.open(bell_file()))
        rocks = edgescan.rocks(result)
        self.assertGreater(rocks.count, 5)
        self.assertEqual(len(rocks.table), rocks.count)
        cells = np.bincount(rocks.regions.ravel(), (result.scan.state == 0).ravel(), len(rocks.region_table) + 1)
        for row in rocks.region_table:
            self.assertLessEqual(row["cells"], cells[row["region"]])  # spikes are measured but not counted
            self.assertEqual(row["kind"] == "rock", row["region"] <= rocks.count)
        apart = []
        for row in rocks.table:
            self.assertGreaterEqual(row["cells"], 0.9 * cells[row["rock"]])
            self.assertEqual(rocks.labels[row["line"], row["beam"]], row["rock"])
            middle = np.nanmean(result.scan.xyz()[rocks.labels == row["rock"]], axis=0)
            apart.append(np.linalg.norm(middle - [row["x_m"], row["y_m"], row["z_m"]]))
        self.assertLess(np.median(apart), 0.02)  # a spike, which is measured but not counted, moves the mean of some rocks
        areas = [row["visible_area_m2"] for row in rocks.table]
        self.assertEqual(areas, sorted(areas, reverse=True))
        np.testing.assert_array_equal(rocks.labels, np.where(rocks.regions <= rocks.count, rocks.regions, 0))
        np.testing.assert_array_equal(rocks.at(1.5).labels, edgescan.rocks(result, level=1.5).labels)

    def test_the_table_is_that_of_the_command_line(self):
        result = edgescan.detect(edgescan.open(bell_file()))
        rocks = edgescan.rocks(result)
        rows = json.loads(cli("rocks", bell_file(), "--json", "-").stdout)["rocks"]
        self.assertEqual(rocks.table, rows)
        self.assertEqual(rocks.table_in("scanner"), rows)
        header = cli("rocks", bell_file(), "--csv", "-").stdout.splitlines()[0].split(",")
        self.assertEqual(list(rocks.table[0]), header)
        self.assertFalse(set(rocks.region_table[0]) - {"region", "kind", "four_sd_m", "evidence"} - set(header))
        with self.assertRaises(edgescan.Error):
            rocks.table_in("mine")

    def test_refused(self):
        result = edgescan.detect(edgescan.open(bell_file()))
        for wrong in ({"level": 99}, {"level": float("nan")}, {"region": [(1, 2)]}, {"region": "all"}):
            with self.subTest(**wrong), self.assertRaises(edgescan.Error):
                edgescan.rocks(result, **wrong)


class Keywords(unittest.TestCase):
    def test_every_parameter_is_one(self):
        names = set(inspect.signature(edgescan.detect).parameters)
        for row in edgescan.parameters():
            self.assertIn(row["key"].replace("-", "_"), names)
            self.assertIn(row["help"], edgescan.detect.__doc__)
        shown = set(re.findall(r"--([a-z0-9-]+)", cli("detect", "--help").stdout))
        self.assertLessEqual({row["key"] for row in edgescan.parameters()}, shown)

    def test_a_word_that_is_none(self):
        scan = edgescan.open(bell_file())
        with self.assertRaisesRegex(TypeError, "did you mean 'jump'"):
            edgescan.detect(scan, jumps=3)
        with self.assertRaisesRegex(TypeError, "axes"):
            edgescan.open(bell_file(), axes="spin")

    def test_the_sentences_are_those_of_the_command_line(self):
        path = bell_file()
        scan = edgescan.open(path)
        broken = HERE / "broken.pcd"
        broken.write_bytes(b"# .PCD v0.7\nFIELDS x y z\nPOINTS 99\n")
        cases = [(lambda: edgescan.detect(scan, jump=9999), ["detect", path, "--jump", "9999"]),
                 (lambda: edgescan.detect(scan, jump="wide"), ["detect", path, "--jump", "wide"]),
                 (lambda: edgescan.detect(scan, min_length=2.5), ["detect", path, "--min-length", "2.5"]),
                 (lambda: edgescan.detect(scan, method="cany"), ["detect", path, "--method", "cany"]),
                 (lambda: edgescan.detect(scan, preset="nosuch"), ["detect", path, "--preset", "nosuch"]),
                 (lambda: edgescan.detect(scan, near=9000, far=100), ["detect", path, "--near", "9000", "--far", "100"]),
                 (lambda: edgescan.open(HERE / "none.pcd"), ["detect", HERE / "none.pcd"]),
                 (lambda: edgescan.open(broken), ["detect", broken])]
        for call, arguments in cases:
            with self.subTest(arguments=str(arguments[1:])):
                run = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, check=False)
                self.assertIn(run.returncode, (1, 2))
                with self.assertRaises(edgescan.Error) as raised:
                    call()
                self.assertEqual("edgescan-cli: " + str(raised.exception), run.stderr.strip())
                self.assertTrue(raised.exception.what and raised.exception.hint)

    def test_nothing_is_written_over_the_input(self):
        path = HERE / "own.pcd"
        cli("convert", bell_file(), path)
        before = path.read_bytes()
        with self.assertRaisesRegex(edgescan.Error, "read as an input"):
            edgescan.save(edgescan.open(path), path)
        self.assertEqual(path.read_bytes(), before)

    def test_wrong_things(self):
        scan = edgescan.open(bell_file())
        for call in (lambda: edgescan.simulate(lines=1e30), lambda: edgescan.simulate(lines=float("nan")),
                     lambda: edgescan.simulate(lines=2.5), lambda: edgescan.simulate(scene="moon"),
                     lambda: edgescan.save(edgescan.detect(scan), HERE / "x.doc"),
                     lambda: edgescan.save(edgescan.detect(scan), HERE / "x.pcd", "soup"),
                     lambda: edgescan.save(scan, HERE / "nowhere" / "x.pcd"),
                     lambda: edgescan.open(bell_file(), beam_step=float("inf")),
                     lambda: edgescan.replay(bell_file()), lambda: edgescan.replay(recording_file(), every=0),
                     lambda: edgescan.connect("host:99999")):
            with self.subTest(call=inspect.getsource(call).strip()), self.assertRaises(edgescan.Error):
                call()
        with self.assertRaisesRegex(AttributeError, "edgescan-lab evaluate"):
            edgescan.evaluate


class Threads(unittest.TestCase):
    def test_others_run_while_edges_are_found(self):
        scan = edgescan.simulate(seed=1, lines=500, beams=571).scan
        ticks, stop = [], threading.Event()

        def tick():
            while not stop.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.0005)

        ticker = threading.Thread(target=tick)
        ticker.start()
        try:
            for _ in range(50):  # a loaded machine may not schedule the other thread at once
                start = time.monotonic()
                edgescan.detect(scan)
                end = time.monotonic()
                if sum(start < t < end for t in ticks) >= 5:  # with the lock held it would be at most 1, before the call
                    return
            self.fail("no other thread ran while edges were found")
        finally:
            stop.set()
            ticker.join()

    def test_opening_waits_without_the_lock(self):
        fifo = HERE / "pipe.csv"
        os.mkfifo(fifo)
        rows = "\n".join(",".join(str(2000 + 10 * i + j) for j in range(181)) for i in range(20))
        opened = []
        opener = threading.Thread(target=lambda: opened.append(edgescan.open(
            fifo, beam_start=0, beam_step=1, line_start=0, line_step=1, axis="spin")))
        opener.start()
        with open(fifo, "w", encoding="ascii") as pipe:  # blocks here for ever if the opener holds the lock
            pipe.write(rows)
        opener.join()
        self.assertEqual(opened[0].range_mm.shape, (20, 181))

    def test_several_at_once_give_the_same(self):
        scan = edgescan.open(bell_file())
        wanted = edgescan.detect(scan).mask_sha256
        found = []
        threads = [threading.Thread(target=lambda: found.append(edgescan.detect(scan).mask_sha256)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [wanted] * 4)

    def test_interrupt(self):
        code = "import edgescan\nprint('now', flush=True)\nedgescan.simulate(lines=4000, beams=4000, threads=1)"
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "now\n")
        process.send_signal(signal.SIGINT)
        said = process.communicate()[1]
        self.assertIn("KeyboardInterrupt", said)
        self.assertNotEqual(process.returncode, 0)


class Types(unittest.TestCase):
    def classes(self):
        return [getattr(edgescan, name) for name in edgescan.__all__ if inspect.isclass(getattr(edgescan, name)) and name != "Error"]

    def test_no_object_without_content(self):
        self.assertGreaterEqual(len(self.classes()), 7)
        for bound in self.classes():
            derived = type("Derived", (bound,), {})
            calls = [lambda: bound.__new__(bound), lambda: bound(), lambda: object.__new__(bound), lambda: derived.__new__(derived),
                     lambda: bound.__mro__[1].__new__(bound), lambda: copy.copy(self.objects()[bound]) if bound in self.objects() else bound()]
            for call in calls:
                with self.subTest(bound=bound, call=inspect.getsource(calls[0])), self.assertRaises(TypeError):
                    call()

    def objects(self):
        if not hasattr(Types, "made"):
            bell = edgescan.simulate(lines=60, beams=80)
            result = edgescan.detect(bell.scan)
            Types.made = {edgescan.Simulation: bell, edgescan.Scan: bell.scan, edgescan.Result: result, edgescan.Rocks: edgescan.rocks(result),
                          edgescan.Replay: edgescan.replay(recording_file())}
        return Types.made

    def test_values_of_other_types(self):
        scan, result = self.objects()[edgescan.Scan], self.objects()[edgescan.Result]
        path = bell_file()
        for call in (lambda v: edgescan.detect(scan, jump=v), lambda v: edgescan.rocks(result, level=v), lambda v: self.objects()[edgescan.Rocks].at(v),
                     lambda v: edgescan.simulate(lines=v, beams=80), lambda v: edgescan.open(path, line_step=v),
                     lambda v: edgescan.replay(recording_file(), speed=v), lambda v: edgescan.connect("127.0.0.1:1", first_line=v),
                     lambda v: edgescan.connect("127.0.0.1:1", timeout=v)):
            for value in (b"x", b"12", bytearray(b"12"), memoryview(b"12"), True, False, np.True_, 1j, object(), {}, [b"12"]):
                with self.subTest(call=inspect.getsource(call).strip(), value=value), self.assertRaises(TypeError):
                    call(value)
        for call in (lambda v: edgescan.replay(recording_file(), every=v), lambda v: edgescan.simulate(seed=v, lines=60, beams=80),
                     lambda v: edgescan.connect("127.0.0.1:1", expected_lines=v), lambda v: edgescan.rocks(result, region=[(v, 1), (2, 2)])):
            for value in (b"1", "1", 1.5, True, None, np.float64(1)):
                with self.subTest(call=inspect.getsource(call).strip(), value=value), self.assertRaises(TypeError):
                    call(value)
        for call in (lambda v: edgescan.detect(scan, slips=v), lambda v: edgescan.open(path, straighten=v),
                     lambda v: edgescan.save(scan, HERE / "types.pcd", ascii=v), lambda v: edgescan.simulate(lines=60, beams=80, truth=v),
                     lambda v: edgescan.save(scan, HERE / "types.pcd", comments=v), lambda v: edgescan.connect("127.0.0.1:1", standing=v)):
            for value in (b"on", 1, 0, 1.0, [], "yes"):
                with self.subTest(call=inspect.getsource(call).strip(), value=value), self.assertRaises(TypeError):
                    call(value)
        for call in (lambda v: edgescan.detect(scan, method=v), lambda v: edgescan.simulate(scene=v), lambda v: edgescan.connect(v),
                     lambda v: edgescan.save(scan, HERE / "types.pcd", role=v), lambda v: edgescan.save(scan, HERE / "types.pcd", frame=v),
                     lambda v: edgescan.detect(scan, classes=v)):
            for value in (b"x", 1, True, np.float64(1)):
                with self.subTest(call=inspect.getsource(call).strip(), value=value), self.assertRaises(TypeError):
                    call(value)
        for call in (edgescan.open, lambda v: edgescan.save(scan, v), edgescan.replay, lambda v: edgescan.detect(scan, preset=v),
                     lambda v: edgescan.open(path, pose=v), lambda v: edgescan.connect("127.0.0.1:1", record=v)):
            for value in (1, True, 1.5, [b"x"], object()):
                with self.subTest(call=str(call), value=value), self.assertRaises(TypeError):
                    call(value)

    def test_numbers_of_any_kind(self):
        scan = self.objects()[edgescan.Scan]
        wanted = edgescan.detect(scan, jump=40).mask_sha256
        for value in (40.0, "40", np.int8(40), np.uint64(40), np.float32(40), np.float64(40), fractions.Fraction(40)):
            self.assertEqual(edgescan.detect(scan, jump=value).mask_sha256, wanted, repr(value))
        for value in (float("nan"), float("inf"), -float("inf"), np.nan, np.float32("inf"), 10**400, -(10**400)):
            for call in (lambda v: edgescan.detect(scan, jump=v), lambda v: edgescan.rocks(edgescan.detect(scan), level=v),
                         lambda v: edgescan.replay(recording_file(), speed=v), lambda v: edgescan.connect("127.0.0.1:1", timeout=v)):
                with self.subTest(value=value), self.assertRaises(edgescan.Error):
                    call(value)
        self.assertEqual(edgescan.detect(scan, jump=None).mask_sha256, edgescan.detect(scan).mask_sha256)


class Names(unittest.TestCase):
    def test_names_that_are_not_utf8(self):
        folder = os.fsencode(HERE) + b"/d\xfe"
        os.makedirs(folder, exist_ok=True)
        scans = {}
        for seed, name in enumerate((b"a\xfe.pcd", b"a\xff.pcd", b"a\xee\xbe\xbf.pcd", b"a\\xff.pcd")):
            path = folder + b"/" + name
            scan = edgescan.simulate(seed=seed + 1, lines=60, beams=80).scan
            edgescan.save(scan, path)
            for given in (path, os.fsdecode(path), pathlib.Path(os.fsdecode(path))):
                opened = edgescan.open(given)
                np.testing.assert_array_equal(opened.range_mm, scan.range_mm)
                self.assertEqual(os.fsencode(opened.path), path)
                self.assertEqual(os.fsencode(opened.info()["input"]), path)
                self.assertEqual(os.fsencode(edgescan.detect(opened).report()["input"]), path)
                repr(opened), repr(edgescan.detect(opened)), opened.warnings, opened.name
            scans[path] = opened.sha256
            mask = path[:-4] + b".png"
            edgescan.save(edgescan.detect(opened), mask)
            self.assertIn("identical", cli("verify", os.fsdecode(mask), "--scans", os.fsdecode(folder)).stdout)
        self.assertEqual(len(set(scans.values())), 4)
        with self.assertRaises(edgescan.Error) as caught:
            edgescan.open(folder + b"/nothing\xff")
        self.assertEqual(os.fsencode(caught.exception.where), folder + b"/nothing\xff")
        self.assertIn("\\xff", str(caught.exception))
        edgescan.simulate(lines=60, beams=80, truth=True).save_truth(folder + b"/truth\xff")
        self.assertTrue(os.path.exists(folder + b"/truth\xff/gt_class.png"))
        with self.assertRaises(edgescan.Error):
            edgescan.replay(folder + b"/a\xff.pcd")


class Sweeps(unittest.TestCase):
    def test_replay_ends_with_what_open_gives(self):
        recording = recording_file()
        sweeps = list(edgescan.replay(recording, every=15))
        self.assertEqual([s.lines for s in sweeps], [15, 30, 40])
        self.assertEqual([s.finished for s in sweeps], [False, False, True])
        opened = edgescan.open(recording)
        np.testing.assert_array_equal(sweeps[-1].scan.range_mm, opened.range_mm)
        np.testing.assert_array_equal(sweeps[-1].scan.state, opened.state)
        np.testing.assert_array_equal(sweeps[-1].scan.line_deg, opened.line_deg)
        np.testing.assert_array_equal(sweeps[0].scan.range_mm, opened.range_mm[:15])
        self.assertEqual(len(list(edgescan.replay(recording))), 40)

    def test_connect(self):
        small = bell_file("small.json", 5, 40, 96)
        wanted = edgescan.open(small)
        record = HERE / "recorded.mcap"
        with served(small, "--rate", 400) as address, edgescan.connect(address, expected_lines=40, axis="sweep", record=record) as scanner:
            seen = []
            for sweep in scanner:
                seen.append(sweep.lines)
                if sweep.finished:
                    break
            self.assertEqual(scanner.status["phase"], "LIVE")
        self.assertEqual(seen, sorted(seen))
        self.assertTrue(sweep.complete)
        np.testing.assert_array_equal(sweep.scan.range_mm, wanted.range_mm)
        np.testing.assert_array_equal(edgescan.open(record).range_mm, wanted.range_mm)
        # The axis was given, the step was not.
        for scan in (sweep.scan, edgescan.open(record)):
            told = [w for w in scan.warnings if "ASSUMED" in w]
            self.assertEqual(len(told), 1, scan.warnings)
            self.assertIn("the step from line to line", told[0])
            self.assertNotIn("the axis", told[0])

    def test_nobody_there(self):
        record = HERE / "nobody.mcap"
        with self.assertRaisesRegex(edgescan.Error, "127.0.0.1"):
            edgescan.connect("127.0.0.1:1", timeout=1, record=record)
        self.assertFalse(record.exists())
        with edgescan.connect("127.0.0.1:1", timeout=None) as scanner, self.assertRaisesRegex(edgescan.Error, "127.0.0.1"):
            scanner.next(timeout=1)
        self.assertEqual(list(scanner), [])

    def test_a_peer_that_says_nothing(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            with self.assertRaises(edgescan.Error):
                edgescan.connect(f"127.0.0.1:{silent.getsockname()[1]}", timeout=1)

    def test_a_scanner_that_falls_silent(self):
        small = bell_file("small.json", 5, 40, 96)
        with served(small, "--rate", 400) as address, edgescan.connect(address, expected_lines=40, timeout=2) as scanner:
            with self.assertRaises(edgescan.Error):
                for _ in scanner:  # the emulated scanner stops after the last line
                    pass


class Documents(unittest.TestCase):
    def test_docstrings(self):
        bell = edgescan.simulate(seed=7, lines=120, beams=161, truth=True)
        result = edgescan.detect(bell.scan)
        with served(bell_file("small.json", 5, 40, 96), "--rate", 400) as address:
            names = {"edgescan": edgescan, "bell": bell, "scan": bell.scan, "result": result, "path": bell_file(), "folder": HERE,
                     "recording": recording_file(), "address": address}
            failed, tried = doctest.testmod(edgescan, extraglobs=names)
        self.assertEqual(failed, 0)
        self.assertGreaterEqual(tried, 15)

    def test_the_examples_of_the_document(self):
        text = (SOURCE / "docs/python.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreaterEqual(len(blocks), 5)
        names, home = {"edgescan": edgescan}, os.getcwd()
        os.chdir(HERE)
        try:
            pathlib.Path("BELL.mcap").write_bytes(recording_file().read_bytes())
            cli("convert", bell_file(), "BELL.pcd")
            with served(bell_file("small.json", 5, 40, 96), "--rate", 400) as address:
                for block in blocks:
                    used = set(re.findall(r"^(?:import|from) (\w+)", block, re.M))
                    absent = [name for name in used if importlib.util.find_spec(name) is None]
                    if absent:
                        print(f"not run, {', '.join(absent)} is not there:\n{block}", file=sys.stderr)
                        continue
                    with self.subTest(block=block):
                        exec(compile(block.replace("192.168.0.1", address), "docs/python.md", "exec"), names)
        finally:
            os.chdir(home)

    def test_stubs(self):
        stubs = pathlib.Path(edgescan.__file__).with_suffix(".pyi").read_text()
        tree = {node.name: node for node in ast.parse(stubs).body if hasattr(node, "name")}
        self.assertEqual(set(tree), set(edgescan.__all__))
        for name, node in tree.items():
            if isinstance(node, ast.FunctionDef):
                shown = [a.arg for a in node.args.args + node.args.kwonlyargs]
                self.assertEqual(shown, list(inspect.signature(getattr(edgescan, name)).parameters))
            elif name != "Error":
                methods = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
                for own in dir(getattr(edgescan, name)):
                    if not own.startswith("_"):
                        self.assertIn(own, methods, name)
        if importlib.util.find_spec("mypy") is not None:
            user = HERE / "user.py"
            user.write_text("import edgescan\nscan = edgescan.open('x', axis='spin')\nresult = edgescan.detect(scan, jump=3, norm='l2')\n"
                            "total: int = int(result.mask.sum()) + scan.lines\n")
            run = subprocess.run([sys.executable, "-m", "mypy", "--strict", str(user)], capture_output=True, text=True, check=False,
                                 env=dict(os.environ, MYPYPATH=str(pathlib.Path(edgescan.__file__).parent.parent)))
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

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
