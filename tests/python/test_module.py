"""The Python module against the command line and numpy: masks, arrays, keywords, sentences, threads, names of files."""
import gc
import hashlib
import inspect
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import edgescan
from support import CLI, HERE, SHARED, SOURCE, bell_file, cli, lab, recording_file


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

        with self.assertRaisesRegex(edgescan.Error, "truth=True"):
            edgescan.simulate(seed=7, lines=60, beams=80).truth


class Arrays(unittest.TestCase):
    def setUp(self):
        self.scan = edgescan.open(bell_file())

    def test_no_copies(self):
        result = edgescan.detect(self.scan)
        for owner, name in ((self.scan, "range_mm"), (self.scan, "state"), (self.scan, "line_deg"), (result, "mask"), (result, "classes"), (result, "borders"),
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
        blocks = re.findall(r"```json\n(.*?)```", (SOURCE / "docs/reference/coordinates.md").read_text(), re.S)
        calibration.write_text(next(b for b in blocks if "edgescan-calibration/1" in b))
        pose.write_text(next(b for b in blocks if "edgescan-pose/1" in b))
        spun = HERE / "spun.json"
        lab("simulate", "-o", spun, "--axis", "spin", "--lines", 90, "--beams", 120)
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

    def test_borders(self):
        result = edgescan.detect(self.scan)
        self.assertEqual((result.borders.dtype, len(result.borders)), (np.uint8, len(result.edges)))
        known = result.borders[result.borders != 255]
        self.assertTrue(len(known) and known.max() <= 100)
        self.assertIsNone(edgescan.detect(self.scan, preset="thesis").borders)
        likely = edgescan.detect(self.scan, rock_borders=True, border_from=60)
        np.testing.assert_array_equal(likely.edges, result.edges[result.borders >= 60])
        counts = {"strong": (result.borders >= 70) & (result.borders <= 100), "weak": (result.borders >= 30) & (result.borders < 70),
                  "folds": result.borders < 30, "unknown": result.borders == 255}
        self.assertEqual(result.report()["rock_borders"], {key: int(np.count_nonzero(which)) for key, which in counts.items()})

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
                keywords = re.sub(r"--([a-z-]+)", lambda flag: flag[1].replace("-", "_"), run.stderr.strip())
                self.assertEqual("edgescan-cli: " + str(raised.exception), keywords)
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
        with self.assertRaisesRegex(AttributeError, "edgescan.compare"):
            edgescan.change


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
        end, pipe = time.monotonic() + 60, None
        while pipe is None and opener.is_alive() and time.monotonic() < end:
            try:
                pipe = os.open(fifo, os.O_WRONLY | os.O_NONBLOCK)  # refused until the opener reads
            except OSError:
                time.sleep(0.01)
        self.assertIsNotNone(pipe, "the opener did not open the pipe")  # this line is not reached if the opener holds the lock
        os.set_blocking(pipe, True)
        with open(pipe, "w", encoding="ascii") as writer:
            writer.write(rows)
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


if __name__ == "__main__":
    unittest.main(verbosity=1)
