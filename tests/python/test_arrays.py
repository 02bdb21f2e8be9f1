"""Scans from arrays of numpy, and scans and results that are pickled."""
import copy
import hashlib
import multiprocessing
import pickle
import re
import unittest

import numpy as np

import edgescan
from support import HERE, SHARED, SOURCE, bell_file, cli, lab, recording_file


def again(scan, **more):
    """The scan made from its own arrays."""
    given = dict(axis=scan.axis, state=scan.state, intensity=scan.intensity, line_skew_deg=scan.line_skew_deg if scan.line_skew_deg.size else None,
                 line_direction=scan.line_direction, line_times_s=scan.line_times_s)
    return edgescan.Scan(scan.range_mm, scan.beam_deg, scan.line_deg, **{**given, **more})


def place_files():
    """A pose and a calibration for a spin mounting, from the document."""
    pose, calibration = HERE / "pose.json", HERE / "robot.json"
    blocks = re.findall(r"```json\n(.*?)```", (SOURCE / "docs/reference/coordinates.md").read_text(), re.S)
    calibration.write_text(next(b for b in blocks if "edgescan-calibration/1" in b))
    pose.write_text(next(b for b in blocks if "edgescan-pose/1" in b))
    return pose, calibration


class FromArrays(unittest.TestCase):
    BEAMS, LINES = np.linspace(60, 120, 7), np.linspace(0, 20, 5)

    def make(self, ranges=None, **more):
        ranges = np.full((5, 7), 4000.0) if ranges is None else ranges
        given = dict(beam_deg=self.BEAMS, line_deg=self.LINES, axis="spin")
        return edgescan.Scan(ranges, **{**given, **more})

    def test_the_same_edges_as_the_file(self):
        files = [bell_file(), recording_file()] + sorted((SHARED / "data" / "lms200_corridor").glob("*.json"))[:1]
        for path in files:
            scan = edgescan.open(path)
            made = again(scan)
            for name in ("range_mm", "state", "beam_deg", "line_deg", "line_skew_deg"):
                np.testing.assert_array_equal(getattr(made, name), getattr(scan, name), f"{path.name} {name}")
            for settings in ({}, {"method": "canny"}):
                self.assertEqual(edgescan.detect(made, **settings).mask_sha256, edgescan.detect(scan, **settings).mask_sha256, path.name)
            np.testing.assert_array_equal(made.xyz(), scan.xyz())

    def test_ranges_are_exact_in_every_type_and_unit(self):
        mm = np.arange(1, 36, dtype=np.float64).reshape(5, 7) * 467
        for kind in (np.uint16, np.int16, np.int64, np.uint32, np.float32, np.float64, ">u2", ">f4"):
            scan = self.make(mm.astype(kind))
            self.assertEqual(scan.range_mm.dtype, np.float32)
            np.testing.assert_array_equal(scan.range_mm, mm, str(kind))
            np.testing.assert_array_equal(scan.state, 0)
        for unit, factor in (("m", 1000), ("cm", 10), ("mm", 1), (0.25, 0.25), (1000, 1000), (np.float32(0.5), 0.5)):
            np.testing.assert_array_equal(self.make(mm / factor, unit=unit).range_mm, mm, str(unit))
        np.testing.assert_array_equal(self.make((mm * 4).astype(np.uint16), unit=0.25).range_mm, mm)
        for view in (np.asfortranarray(mm), mm[::-1, ::-1], np.repeat(mm, 2, 1)[:, ::2], mm.tolist(), tuple(map(tuple, mm))):
            np.testing.assert_array_equal(self.make(view).range_mm, np.asarray(view))
        self.assertEqual(self.make(mm).warnings, [])
        self.assertIn("35 ranges above 16,777 m", self.make(mm + 2.0**25 + 0.5).warnings[0])

    def test_the_array_is_copied(self):
        mm = np.full((5, 7), 4000.0)
        scan = self.make(mm)
        mm[:] = 1
        np.testing.assert_array_equal(scan.range_mm, 4000)

    def test_no_return(self):
        mm = np.full((5, 7), 4000.0)
        mm[1, 2], mm[3, 4] = np.nan, 0
        scan = self.make(mm)
        self.assertEqual(np.argwhere(scan.state == 1).tolist(), [[1, 2], [3, 4]])
        self.assertEqual((scan.range_mm[1, 2], scan.range_mm[3, 4]), (0, 0))
        for wrong in (-1, -5000, np.inf, -np.inf, 1e10):
            mm[3, 4] = wrong
            with self.assertRaisesRegex(edgescan.Error, r"range_mm\[3, 4\].*is not a range.*NaN or 0"):
                self.make(mm)

    def test_states(self):
        mm = np.full((5, 7), 4000.0)
        state = np.zeros((5, 7), int)
        state[0, 1:6] = [1, 2, 3, 4, 5]
        mm[0, 1:6] = [0, 8191, np.nan, 0, np.nan]
        scan = self.make(mm, state=state)
        np.testing.assert_array_equal(scan.state, state)
        self.assertEqual(scan.range_mm[0, 2], 8191)
        for where, value, number in (((2, 2), 1, 4000), ((0, 0), 0, np.nan), ((2, 2), 2, -3)):
            bad_state, bad = state.copy(), mm.copy()
            bad_state[where], bad[where] = value, number
            with self.assertRaisesRegex(edgescan.Error, rf"range_mm\[{where[0]}, {where[1]}\]"):
                self.make(bad, state=bad_state)
        for value in (6, -1, 256):
            bad_state = state.copy()
            bad_state[4, 6] = value
            with self.assertRaisesRegex(edgescan.Error, r"state\[4, 6\].*0 to 5"):
                self.make(mm, state=bad_state)

    def test_intensity_and_times(self):
        intensity = np.full((5, 7), 0.5)
        intensity[2, 2] = np.nan
        times = 1.7e9 + np.arange(5) * 0.5
        scan = self.make(intensity=intensity, line_times_s=times, name="mine")
        np.testing.assert_array_equal(scan.intensity, intensity.astype(np.float32))
        np.testing.assert_array_equal(scan.line_times_s, times)
        self.assertEqual((scan.name, scan.path, scan.format), ("mine", "", "array"))
        self.assertTrue(scan.info()["acquisition"]["start_utc"].startswith("2023-11-14T22:13:20"), scan.info()["acquisition"])
        intensity[1, 1] = np.inf
        for wrong, part in ((dict(intensity=intensity), r"intensity\[1, 1\]"), (dict(line_times_s=times[::-1]), r"line_times_s\[1\]"),
                            (dict(line_times_s=times * np.nan), r"line_times_s\[0\]"), (dict(line_times_s=times - 2e9), r"line_times_s\[0\]")):
            with self.assertRaisesRegex(edgescan.Error, part):
                self.make(**wrong)

    def test_wrong_shapes(self):
        for wrong, part in ((dict(ranges=np.ones(7)), "range_mm"), (dict(ranges=np.ones((5, 7, 3))), "range_mm"), (dict(ranges=np.ones((0, 7))), "range_mm"),
                            (dict(ranges=np.ones((7, 5))), "beam_deg"), (dict(beam_deg=self.BEAMS[:6]), "beam_deg"), (dict(beam_deg=3.0), "beam_deg"),
                            (dict(line_deg=self.BEAMS), "line_deg"), (dict(state=np.zeros((7, 5), int)), "state"),
                            (dict(intensity=np.zeros(35)), "intensity"), (dict(line_times_s=[1.0]), "line_times_s"), (dict(line_skew_deg=[1.0]), "line_skew_deg")):
            with self.subTest(part=part), self.assertRaisesRegex(edgescan.Error, f"{part}: its shape is"):
                self.make(**wrong)

    def test_wrong_types(self):
        for wrong in ("1 2", None, [[1, 2], [3]], np.ones((5, 7), complex), np.ones((5, 7), bool), np.full((5, 7), "1"), np.full((5, 7), None),
                      np.ma.masked_less(np.ones((5, 7)), 2), {}, object()):
            for name in ("ranges", "beam_deg", "line_deg"):
                with self.subTest(name=name, wrong=wrong), self.assertRaisesRegex(TypeError, "must be an array" if wrong is not None or name != "ranges" else ""):
                    if name == "ranges":
                        edgescan.Scan(wrong, self.BEAMS, self.LINES, axis="spin")
                    else:
                        self.make(**{name: wrong})
        with self.assertRaisesRegex(TypeError, "state must be an array of whole numbers"):
            self.make(state=np.zeros((5, 7)))
        for wrong in (True, b"mm", None, [1]):
            with self.assertRaisesRegex(TypeError, "unit must be 'mm', 'cm', 'm' or the millimetres"):
                self.make(unit=wrong)
        with self.assertRaisesRegex(TypeError, "missing a required (keyword-only )?argument: 'axis'"):
            edgescan.Scan(np.ones((5, 7)), self.BEAMS, self.LINES)
        for wrong, part in ((dict(axis="turn"), "spin or sweep"), (dict(unit="inch"), "mm, cm, m, in, ft or usft"), (dict(unit=0), "unit"), (dict(unit=float("nan")), "unit"),
                            (dict(line_direction=0.5), "1 or -1"), (dict(pose="p.json"), "both"), (dict(calibration="c.json"), "both"),
                            (dict(beam_deg=self.BEAMS * np.nan), r"beam_deg\[0\]"), (dict(beam_deg=self.BEAMS * 0), "same way"),
                            (dict(line_deg=self.LINES + 1e9), "line 0"), (dict(beam_deg=self.BEAMS + 400), "beam 0")):
            with self.subTest(**{k: str(v) for k, v in wrong.items()}), self.assertRaisesRegex(edgescan.Error, part):
                self.make(**wrong)

    def test_a_place(self):
        pose, calibration = place_files()
        spun = HERE / "spun.json"
        lab("simulate", "-o", spun, "--axis", "spin", "--lines", 90, "--beams", 120)
        scan = edgescan.open(spun, pose=pose, calibration=calibration)
        made = again(scan, pose=pose, calibration=calibration)
        np.testing.assert_array_equal(made.origin, scan.origin)
        np.testing.assert_array_equal(made.xyz("mine"), scan.xyz("mine"))
        with self.assertRaises(edgescan.Error):
            again(scan, pose=HERE / "none.json", calibration=calibration)

    def test_saved_and_opened(self):
        scan = edgescan.open(bell_file())
        made = again(scan)
        for name in ("made.json", "made.pcd", "made.csv"):
            edgescan.save(made, HERE / name)
            opened = edgescan.open(HERE / name)
            np.testing.assert_array_equal(opened.range_mm, scan.range_mm, name)
            self.assertEqual(edgescan.detect(opened).mask_sha256, edgescan.detect(scan).mask_sha256)
        self.assertEqual(edgescan.save(edgescan.detect(made), HERE / "made_edges.ply"), len(edgescan.detect(made).edges))


class FromPoints(unittest.TestCase):
    def test_points_of_a_grid_are_the_scan(self):
        scan = edgescan.open(bell_file())
        made = edgescan.Scan.from_points(scan.xyz(), unit="m", name="mine")
        self.assertEqual((made.lines, made.beams, made.name), (scan.lines, scan.beams, "mine"))
        both = (made.state == 0) & (scan.state == 0)
        self.assertGreater(both.mean(), 0.9)
        np.testing.assert_allclose(made.range_mm[both], scan.range_mm[both], atol=1)

    def test_loose_points_are_projected(self):
        points = edgescan.open(bell_file()).xyz().reshape(-1, 3)
        points = np.random.default_rng(1).permutation(points[np.isfinite(points).all(axis=1)])
        made = edgescan.Scan.from_points(points, sensor=(0, 0, 0), project="always")
        self.assertTrue(any("projected" in warning for warning in made.warnings), made.warnings)

    def test_what_is_no_array_of_points_is_refused(self):
        for wrong, part in ((np.zeros((4, 2)), "n x 3"), (np.zeros(3), "n x 3"), (np.zeros((0, 3)), "it is empty")):
            with self.assertRaisesRegex(edgescan.Error, part):
                edgescan.Scan.from_points(wrong)
        with self.assertRaisesRegex(TypeError, r"Scan.from_points\(\): xyz must be an array of numbers"):
            edgescan.Scan.from_points([["a", "b", "c"]])

    def test_numpy_gets_every_array(self):
        result = edgescan.detect(edgescan.open(bell_file()))
        rocks = edgescan.rocks(result)
        count = result.save_npz(HERE / "all.npz", rocks=rocks)
        stored = np.load(HERE / "all.npz")
        self.assertEqual(count, len(stored.files))
        for name in ("range_mm", "state", "xyz", "mask", "classes", "edges", "strength", "labels"):
            self.assertIn(name, stored.files)
        np.testing.assert_array_equal(stored["mask"], result.mask)
        np.testing.assert_array_equal(stored["labels"], rocks.labels)
        with self.assertRaisesRegex(edgescan.Error, "ends with .npz"):
            result.save_npz(HERE / "all.npy")


class Silent(unittest.TestCase):
    def test_what_has_no_effect_is_refused_or_warned_about(self):
        scan = edgescan.open("file://" + str(bell_file()), unit="m", topic="/scan")
        self.assertTrue(any(w.startswith("unit m replaces mm") for w in scan.warnings), scan.warnings)
        self.assertTrue(any(w.startswith("topic has no effect") for w in scan.warnings), scan.warnings)
        scan = edgescan.open(bell_file())
        with self.assertRaisesRegex(edgescan.Error, "the method canny does not use this keyword"):
            edgescan.detect(scan, method="canny", jump=200)
        self.assertEqual(edgescan.detect(scan, edge_strength=2).mask_sha256, edgescan.detect(scan, sensitivity=2).mask_sha256)
        with self.assertRaisesRegex(edgescan.Error, "two names of one setting"):
            edgescan.detect(scan, edge_strength=2, sensitivity=2)


class Pickled(unittest.TestCase):
    def same(self, one, other):
        for name in ("range_mm", "state", "intensity", "beam_deg", "line_deg", "line_skew_deg", "line_times_s", "origin"):
            np.testing.assert_array_equal(getattr(one, name), getattr(other, name), name)
        for name in ("name", "path", "format", "sha256", "warnings", "axis", "line_direction"):
            self.assertEqual(getattr(one, name), getattr(other, name), name)
        self.assertEqual(one.info(), other.info())
        np.testing.assert_array_equal(one.xyz(), other.xyz())

    def scans(self):
        cloud = HERE / "cloud.xyz"
        if not cloud.exists():
            angles = np.random.default_rng(1).uniform(-0.6, 0.6, (6000, 2))
            points = 5 * np.stack([np.sin(angles[:, 0]), np.sin(angles[:, 1]), np.cos(angles[:, 0]) * np.cos(angles[:, 1])], 1)
            np.savetxt(cloud, points, fmt="%.4f")
        pose, calibration = place_files()
        spun = HERE / "spun-too.json"
        lab("simulate", "-o", spun, "--axis", "spin", "--lines", 60, "--beams", 80)
        intensity = np.full((5, 7), 0.5)
        intensity[1, 1] = np.nan
        yield edgescan.open(bell_file())
        yield edgescan.open(recording_file())
        yield edgescan.open(spun, pose=pose, calibration=calibration)
        yield edgescan.open(cloud, project="always", sensor=(0, 0, 0))
        yield edgescan.Scan(np.full((5, 7), 4000), np.linspace(60, 120, 7), np.linspace(0, 20, 5), axis="sweep", intensity=intensity,
                            line_times_s=np.arange(5) + 1.7e9)
        yield edgescan.simulate(seed=4, lines=60, beams=80).scan

    def test_a_scan_is_the_same(self):
        for scan in self.scans():
            with self.subTest(scan=scan):
                other = pickle.loads(pickle.dumps(scan))
                self.assertIsNot(other, scan)
                self.same(scan, other)
                self.assertEqual(edgescan.detect(other).mask_sha256, edgescan.detect(scan).mask_sha256)
                if scan.origin is not None:
                    np.testing.assert_array_equal(other.xyz("mine"), scan.xyz("mine"))
                self.assertIs(copy.copy(scan), scan)
                self.assertIs(copy.deepcopy([scan])[0], scan)

    def test_a_result_is_the_same(self):
        scan = edgescan.open(bell_file())
        for settings in ({}, {"method": "canny", "lower": 9}, {"method": "sobel", "near": 2500}, {"fill": 4, "fill_edges": True, "slips": False}):
            result = edgescan.detect(scan, **settings)
            other = pickle.loads(pickle.dumps(result))
            self.same(result.scan, other.scan)
            for name in ("mask", "classes", "borders", "edges", "gray", "strength"):
                np.testing.assert_array_equal(getattr(result, name), getattr(other, name), name)
            for name in ("settings", "threshold", "times_ms", "mask_sha256"):
                self.assertEqual(getattr(result, name), getattr(other, name), name)
            without = {key: value for key, value in result.report().items() if key != "timings_ms"}
            self.assertEqual({key: value for key, value in other.report().items() if key != "timings_ms"}, without)
            np.testing.assert_array_equal(edgescan.rocks(result).labels, edgescan.rocks(other).labels)
            line, beam = divmod(int(result.edges[5]), scan.beams)
            self.assertEqual(edgescan.why(other, line, beam), edgescan.why(result, line, beam))
            edgescan.save(result, HERE / "first.pcd")
            edgescan.save(pickle.loads(pickle.dumps(result)), HERE / "second.pcd")
            self.assertEqual((HERE / "first.pcd").read_bytes(), (HERE / "second.pcd").read_bytes())
            self.assertIs(copy.deepcopy(result), result)

    def test_processes(self):
        scans = [edgescan.simulate(seed=seed, lines=60, beams=80).scan for seed in (1, 2, 3)]
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            results = pool.map(edgescan.detect, scans)
        for scan, result in zip(scans, results):
            self.assertEqual(hashlib.sha256(result.mask.tobytes()).hexdigest(), edgescan.detect(scan).mask_sha256)

    def test_damaged(self):
        whole = edgescan._edgescan.bytes_of_scan(edgescan.simulate(seed=4, lines=60, beams=80).scan)
        for part in (b"", whole[:7], whole[:40], whole[:1000], whole[:-1], b"\xff" * 100):
            with self.subTest(size=len(part)), self.assertRaises(edgescan.Error):
                edgescan._edgescan.scan_of_bytes(part)
        with self.assertRaisesRegex(edgescan.Error, "pickled by EdgeScan"):
            edgescan._edgescan.scan_of_bytes(whole.replace(edgescan.__version__.encode(), b"9" * len(edgescan.__version__), 1))

    def test_others_cannot(self):
        bell = edgescan.simulate(lines=60, beams=80)
        replay = edgescan.replay(recording_file())
        for one in (bell, replay, next(replay), edgescan.rocks(edgescan.detect(bell.scan))):
            with self.assertRaisesRegex(TypeError, f"a {type(one).__name__} cannot be pickled"):
                pickle.dumps(one)


if __name__ == "__main__":
    unittest.main(verbosity=1)
