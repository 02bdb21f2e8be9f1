"""What every function, method and constructor does with arguments that are wrong, and how objects show themselves."""
import copy
import fractions
import inspect
import unittest

import numpy as np

import edgescan
from support import HERE, bell_file, recording_file


class Types(unittest.TestCase):
    def classes(self):
        return [getattr(edgescan, name) for name in edgescan.__all__ if inspect.isclass(getattr(edgescan, name)) and not issubclass(getattr(edgescan, name), Exception)]

    def test_a_missing_file_is_a_file_not_found(self):
        for call in (edgescan.open, edgescan.replay):
            with self.subTest(call=call.__name__), self.assertRaises(FileNotFoundError) as raised:
                call("/nowhere/bell.pcd")
            self.assertIsInstance(raised.exception, edgescan.Error)
            self.assertIn("bell.pcd", str(raised.exception))
            self.assertTrue(raised.exception.what and raised.exception.hint)
        with self.assertRaises(edgescan.Error) as raised:
            edgescan.open(__file__)
        self.assertNotIsInstance(raised.exception, FileNotFoundError)

    def test_no_object_without_content(self):
        self.assertGreaterEqual(len(self.classes()), 7)
        for bound in self.classes():
            derived = type("Derived", (bound,), {})
            one = self.objects().get(bound)
            calls = [lambda: bound.__new__(bound), lambda: bound(), lambda: object.__new__(bound), lambda: derived.__new__(derived),
                     lambda: derived(np.ones((2, 2)), [1, 2], [1, 2], axis="spin"), lambda: bound.__mro__[1].__new__(bound),
                     lambda: bound() if bound in (edgescan.Scan, edgescan.Result) else copy.copy(one) if one is not None else bound()]
            for call in calls:
                with self.subTest(bound=bound, call=inspect.getsource(calls[0])), self.assertRaises(TypeError):
                    call()
        for bound in self.classes():
            if bound is not edgescan.Scan:
                with self.assertRaisesRegex(TypeError, rf"^{bound.__name__}\(\): objects of this class are made by"):
                    bound()

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
                     lambda v: edgescan.replay(recording_file(), speed=v), lambda v: edgescan.connect("127.0.0.1:1", line_start=v),
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
                     lambda v: edgescan.save(scan, HERE / "types.pcd", comments=v), lambda v: edgescan.connect("127.0.0.1:1", stop_and_go=v)):
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


    def test_numbers_that_are_texts_too(self):
        path = bell_file()
        for value in (25.4, 304.8, 10):
            self.assertEqual(edgescan.open(path, unit=value).warnings, edgescan.open(path, unit=repr(value)).warnings)
        with self.assertRaisesRegex(edgescan.Error, "^unit: 0 is out of reason .*give a number from "):
            edgescan.open(path, unit=0)
        with self.assertRaisesRegex(edgescan.Error, "^sensor: \"1,2\" is not three numbers; give three numbers"):
            edgescan.open(path, sensor=(1, 2))
        with self.assertRaisesRegex(TypeError, "jump must be a number, not the bool True"):
            edgescan.detect(self.objects()[edgescan.Scan], jump=True)

    def test_empty_paths(self):
        scan = self.objects()[edgescan.Scan]
        for call in (lambda: edgescan.open(""), lambda: edgescan.save(scan, ""), lambda: edgescan.detect(scan, preset=""),
                     lambda: edgescan.open(bell_file(), pose=""), lambda: edgescan.replay("")):
            with self.assertRaisesRegex(edgescan.Error, r"\(\): (path|preset|pose): the path is empty; give"):
                call()

    def test_units_that_are_seldom_meant(self):
        metres, beams, lines = np.full((20, 90), 4.2), np.linspace(10, 170, 90), np.linspace(0, 20, 20)
        self.assertIn("may be metres", edgescan.Scan(metres, beams, lines, axis="sweep").warnings[0])
        self.assertIn("may be radians", edgescan.Scan(metres * 1000, np.radians(beams), np.radians(lines), axis="sweep").warnings[0])
        self.assertEqual(edgescan.Scan(metres, beams, lines, axis="sweep", unit="m").warnings, [])
        few = edgescan.Scan(metres[:, :30] * 1000, np.radians(np.arange(30)), np.radians(np.arange(20)), axis="sweep")
        self.assertIn("The beams span 0.51 degrees", few.warnings[0])
        bell = edgescan.simulate(lines=60, beams=80).scan
        far = edgescan.Scan.from_points(bell.xyz() * 1000, unit="m")
        self.assertIn("km: check unit.", " ".join(far.warnings))

    def test_what_is_nearly_right(self):
        bell = edgescan.simulate(lines=60, beams=80).scan
        result = edgescan.detect(bell)
        for call, error, part in ((lambda: bell.range, AttributeError, "did you mean 'range_mm'"), (lambda: result.edge, AttributeError, "did you mean 'edges'"),
                                  (lambda: edgescan.save(edgescan.rocks(result), "x.csv"), TypeError, "rocks.table has its rows")):
            with self.assertRaisesRegex(error, part):
                call()
        self.assertFalse(hasattr(bell, "__array_interface__"))

    def test_the_file_of_an_open_scan_is_not_replaced(self):
        path = HERE / "open.json"
        edgescan.save(edgescan.simulate(lines=60, beams=80).scan, path)
        scan = edgescan.open(path)
        with self.assertRaisesRegex(edgescan.Error, "this file was read as an input"):
            edgescan.save(edgescan.simulate(lines=60, beams=80, seed=2).scan, path)
        del scan
        edgescan.save(edgescan.simulate(lines=60, beams=80, seed=2).scan, path)

    def test_arrays_that_are_seldom_meant(self):
        ranges, beams, lines = np.full((20, 90), 4200.0), np.linspace(10, 170, 90), np.linspace(0, 20, 20)
        self.assertEqual(edgescan.Scan(np.full((20, 90), np.nan), beams, lines, axis="sweep").warnings, ["No cell of this scan has a range."])
        for one, other, name in ((np.random.default_rng(1).permutation(beams), lines, "beam_deg"), (beams, lines[[1, 0, *range(2, 20)]], "line_deg")):
            warnings = edgescan.Scan(ranges, one, other, axis="sweep").warnings
            self.assertEqual([warning.split(" ", 1)[0] for warning in warnings], [name])
            self.assertIn("neither rises nor falls", warnings[0])
        self.assertEqual(edgescan.Scan(ranges, beams[::-1], lines[::-1], axis="sweep").warnings, [])
        self.assertEqual(edgescan.Scan(ranges, beams, (lines + 350) % 360, axis="spin").warnings, [])
        beams[5] = np.nan
        with self.assertRaisesRegex(edgescan.Error, r"^beam_deg\[5\]: nan is not a number; give a finite number for each\.$"):
            edgescan.Scan(ranges, beams, lines, axis="sweep")
        with self.assertRaisesRegex(edgescan.Error, r"^xyz: it is empty, of shape \(0, 3\); give one point"):
            edgescan.Scan.from_points(np.zeros((0, 3)))

    def test_keywords_without_effect(self):
        scan, result = self.objects()[edgescan.Scan], self.objects()[edgescan.Result]
        for of, name, keywords, keyword in ((result, "e.png", {"ascii": True}, "ascii"), (result, "e.png", {"include_attached": True}, "include_attached"),
                                            (result, "e.pcd", {"dxf_2000": True}, "dxf_2000"), (result, "e.las", {"ascii": True}, "ascii"),
                                            (result, "e.dxf", {"comments": True}, "comments"), (scan, "e.pcd", {"with_filled": True}, "with_filled"),
                                            (scan, "e.json", {"include_attached": True}, "include_attached")):
            with self.subTest(name=name, keyword=keyword), self.assertRaisesRegex(
                    edgescan.Error, f"^{keyword}: this keyword changes nothing in this file; leave it out"):
                edgescan.save(of, HERE / name, **keywords)
        for content in ("mask", "gray", "range"):
            with self.assertRaisesRegex(edgescan.Error, "m.pcd: the extension names no format for this; use .png"):
                edgescan.save(result, HERE / "m.pcd", content=content)
        self.assertFalse([name for name in ("e.png", "e.pcd", "e.las", "e.dxf", "e.json", "m.pcd") if (HERE / name).exists()])
        edgescan.save(result, HERE / "e.dxf", dxf_2000=True, short_lines=True)
        edgescan.save(scan, HERE / "e.csv", comments=True)
        for call, part in ((lambda: edgescan.simulate(scene="wall", rock_count=5), "^rock_count: the scene wall does not use this keyword"),
                           (lambda: edgescan.simulate(scene="hangup", surface=scan), "^surface: the scene hangup does not"),
                           (lambda: edgescan.simulate(scene="wall", wall_kind="brows"), "^wall_kind: "),
                           (lambda: edgescan.simulate(scene="pile", after_blast=True), "^after_blast: "),
                           (lambda: edgescan.simulate(scene="wall", hole_shape="none", hole_count=2), "^hole_shape none: a wall without holes")):
            with self.assertRaisesRegex(edgescan.Error, part):
                call()

    def test_keywords_are_named_and_not_flags(self):
        scan, result = self.objects()[edgescan.Scan], self.objects()[edgescan.Result]
        odd = HERE / "a--jump.b --jump.pcd"
        for call, said in ((lambda: edgescan.rocks(result, region=[(1, 2)]), "region: .* as \\[\\(line, beam\\), "),
                           (lambda: edgescan.rocks(result, min_cells=0), "^min_cells: "), (lambda: edgescan.rocks(result, min_cells=60.5), "^min_cells: "),
                           (lambda: edgescan.detect(scan, method="canny", jump=80), "^jump: the method canny does not use this keyword"),
                           (lambda: edgescan.simulate(scene="rescan"), "give a cloud of points with surface"),
                           (lambda: edgescan.simulate(rock_count=1e9), "^rock_count: "), (lambda: edgescan.simulate(wall_kind="x"), "use one of"),
                           (lambda: edgescan.save(result, HERE / "x.xyz", with_confidence=True), "with_confidence"),
                           (lambda: edgescan.open(odd), "a--jump.b --jump.pcd: there is no such file")):
            with self.subTest(said=said), self.assertRaisesRegex(edgescan.Error, said) as raised:
                call()
            self.assertNotRegex(str(raised.exception).replace(str(odd), ""), "--[a-z]|LINE|this flag")
        for warning in edgescan.open(bell_file(), topic="/scan", unit="cm").warnings:
            self.assertNotIn("--", warning)
        self.assertIn("unit cm replaces mm", " ".join(edgescan.open(bell_file(), unit="cm").info()["warnings"]))

    def test_points_in_memory_are_an_argument(self):
        with self.assertRaises(edgescan.Error) as raised:
            edgescan.Scan.from_points(np.random.default_rng(1).normal(size=(5, 3)))
        self.assertIn("xyz: ", str(raised.exception))
        for other in ("memory", "--"):
            self.assertNotIn(other, str(raised.exception))


class Sentences(unittest.TestCase):
    """A TypeError is one sentence without the text of the binding."""

    def plain(self, call, *parts):
        with self.assertRaises(TypeError) as raised:
            call()
        said = str(raised.exception)
        for part in parts:
            self.assertIn(part, said)
        for ugly in ("incompatible function arguments", "Invoked with", "\n", "self:"):
            self.assertNotIn(ugly, said)

    def things(self):
        bell = edgescan.simulate(lines=60, beams=80)
        result = edgescan.detect(bell.scan)
        return bell, bell.scan, result, edgescan.rocks(result)

    def test_name_given_and_wanted(self):
        bell, scan, result, rocks = self.things()
        self.plain(lambda: edgescan.detect("bell.pcd"), "detect(): scan", "'bell.pcd'", "edgescan.open()")
        self.plain(lambda: edgescan.detect(None), "detect(): scan", "None")
        self.plain(lambda: edgescan.detect(result), "detect(): scan", "Result")
        self.plain(lambda: edgescan.detect(scan, jump=[1]), "detect(): jump", "a number", "list")
        self.plain(lambda: edgescan.rocks(scan), "rocks(): result", "edgescan.detect()", "Scan")
        self.plain(lambda: edgescan.rocks(result, region=[(1, 2, 3)]), "rocks(): region", "(line, beam)")
        self.plain(lambda: edgescan.save(7, "x.pcd"), "save(): what", "a Scan", "a Result", "7")
        self.plain(lambda: edgescan.save(scan, 7), "save(): path", "str, bytes or os.PathLike", "7")
        self.plain(lambda: edgescan.why(result, 1.5, 2), "why(): line", "a whole number", "1.5")
        self.plain(lambda: edgescan.why(scan, 1, 2), "why(): result")
        self.plain(lambda: edgescan.compare(result, scan), "compare(): now")
        self.plain(lambda: edgescan.compare(result, result, poses=["a"]), "compare(): poses", "two paths")
        self.plain(lambda: edgescan.compare(result, result, poses=5), "compare(): poses", "two paths")
        self.plain(lambda: edgescan.report(result, "x.html", rocks=True), "report(): rocks", "edgescan.rocks()", "True")
        self.plain(lambda: edgescan.report(result, "x.html", before=result), "report(): before")
        self.plain(lambda: edgescan.simulate(surface=5), "simulate(): surface", "a Scan")
        self.plain(lambda: edgescan.benchmark(5), "benchmark(): what", "5")
        self.plain(lambda: edgescan.connect(b"host"), "connect(): address", "a str")
        self.plain(lambda: scan.xyz(5), "Scan.xyz(): frame", "'scanner' or 'local' or 'mine'", "the int 5")
        self.plain(lambda: edgescan.open(bell_file(), axis=1), "open(): axis", "'spin' or 'sweep'", "the int 1")
        self.plain(lambda: rocks.at("coarse"), "Rocks.at(): level", "a number", "'coarse'")
        self.plain(lambda: bell.save_truth(3), "Simulation.save_truth(): folder", "3")
        self.plain(lambda: edgescan.Scan.info(5), "Scan.info(): self", "a Scan", "5")

    def test_too_few_and_too_many(self):
        _, scan, result, rocks = self.things()
        for call, part in ((edgescan.detect, "scan"), (edgescan.open, "path"), (lambda: edgescan.why(result, 1), "beam"), (rocks.at, "level"),
                           (lambda: edgescan.Scan([[1.0]]), "beam_deg"), (lambda: edgescan.save(scan), "path")):
            self.plain(call, "missing a required argument", repr(part))
        for call in (lambda: scan.info(1), lambda: result.report(1), lambda: scan.xyz("scanner", 1), lambda: edgescan.parameters(1),
                     lambda: edgescan.presets(1), lambda: edgescan.open("a", "b"), lambda: edgescan.connect("a", "b")):
            self.plain(call, "given by place, and it takes")
        self.plain(lambda: edgescan.detect(scan, "canny"), "2 arguments", "at most 1 (scan)", "by name")
        self.plain(lambda: scan.info(1), "1 argument was", "none")
        self.plain(lambda: edgescan.Scan(np.ones((2, 2)), [1, 2], [1, 2], "spin"), "4 arguments", "at most 3 (range_mm, beam_deg, line_deg)", "by name")
        for call in (lambda: scan.info(x=1), lambda: scan.xyz(frames="mine"), lambda: edgescan.why(result, 1, 2, deep=True),
                     lambda: edgescan.Scan(np.ones((2, 2)), [1, 2], [1, 2], axes="spin")):
            self.plain(call, "there is no keyword")
        self.plain(lambda: scan.xyz(fram="mine"), "did you mean 'frame'")

    def test_texts_that_are_none(self):
        _, scan, result, _ = self.things()
        for value in ("\udcff", "a\ud800b"):
            for call in (lambda v: edgescan.detect(scan, method=v), lambda v: edgescan.open(bell_file(), axis=v), lambda v: edgescan.connect(v),
                         lambda v: edgescan.save(scan, HERE / "x.pcd", operator=v), lambda v: edgescan.rocks(result, region=v), lambda v: scan.xyz(v),
                         lambda v: edgescan.report(result, HERE / "x.html", role=v), lambda v: edgescan.simulate(scene=v),
                         lambda v: edgescan.Scan(np.ones((2, 2)), [1, 2], [1, 2], axis="spin", name=v)):
                self.plain(lambda: call(value), "surrogate")
        for value in ("a\0b.pcd", b"a\0b.pcd"):
            for call in (edgescan.open, lambda v: edgescan.save(scan, v), edgescan.replay, lambda v: edgescan.report(result, v),
                         lambda v: edgescan.compare(result, result, picture=v), lambda v: edgescan.detect(scan, preset=v)):
                self.plain(lambda: call(value), "NUL")
        self.plain(lambda: edgescan.open("a\ud800"), "os.fsdecode()")
        with self.assertRaisesRegex(edgescan.Error, "use spin or sweep"):
            edgescan.open(bell_file(), axis="turn")

    def test_every_argument_of_every_function(self):
        """No type reaches the binding unchecked."""
        odd = type("Odd", (), {})()
        bell, scan, result, rocks = self.things()
        objects = {"scan": scan, "result": result, "what": result, "before": result, "now": result, "path": str(HERE / "x.pcd"), "line": 0, "beam": 0,
                   "address": "127.0.0.1:1"}
        called = 0
        for name in edgescan.__all__:
            function = getattr(edgescan, name)
            if not inspect.isfunction(function):
                continue
            needed = {p.name: objects[p.name] for p in inspect.signature(function).parameters.values() if p.default is p.empty}
            for parameter in inspect.signature(function).parameters:
                self.plain(lambda f=function, p=parameter, n=needed: f(**{**n, p: odd}), parameter, "Odd")
                called += 1
        for owner, name in ((scan, "xyz"), (rocks, "at"), (bell, "save_truth")):
            for parameter in inspect.signature(getattr(type(owner), name)).parameters:
                if parameter != "self":
                    self.plain(lambda: getattr(owner, name)(**{parameter: odd}), parameter, "Odd")
        self.assertGreater(called, 100)

    def test_numbers_beyond_the_machine(self):
        _, scan, result, _ = self.things()
        for value in (10**30, -(10**30), 2**63, -1):
            for call in (lambda v: edgescan.why(result, v, 0), lambda v: edgescan.why(result, 0, v),
                         lambda v: edgescan.connect("127.0.0.1:1", expected_lines=v)):
                with self.subTest(value=value), self.assertRaises(edgescan.Error):
                    call(value)
        for value in (-1, 2**64, 10**30):
            with self.assertRaises(edgescan.Error):
                edgescan.simulate(seed=value, lines=60, beams=80)
        with self.assertRaises(edgescan.Error):
            edgescan.replay(recording_file(), every=-(10**30))
        self.assertEqual(len(list(edgescan.replay(recording_file(), every=10**30))), 1)


class Shown(unittest.TestCase):
    def test_every_class_has_a_repr(self):
        bell = edgescan.simulate(seed=3, lines=60, beams=80)
        result = edgescan.detect(bell.scan)
        replay = edgescan.replay(recording_file(), every=10)
        texts = [repr(one) for one in (bell, bell.scan, result, edgescan.rocks(result), replay, next(replay))]
        self.assertIn("seed 3", texts[0])
        self.assertIn("60 lines x 80 beams", texts[1])
        self.assertIn("edge cells of 4800", texts[2])
        self.assertIn("rocks at level 0", texts[3])
        self.assertIn("bell.mcap: line 10 of 40", texts[4])
        self.assertIn("10", texts[5])
        for text in texts:
            self.assertRegex(text, r"^<edgescan\.[A-Z][a-z]+[ :]")
            self.assertNotIn(" object at 0x", text)
        for name in edgescan.__all__:
            if inspect.isclass(getattr(edgescan, name)):
                self.assertEqual(getattr(edgescan, name).__module__, "edgescan")
                self.assertIsNot(getattr(edgescan, name).__repr__, object.__repr__)


if __name__ == "__main__":
    unittest.main(verbosity=1)
