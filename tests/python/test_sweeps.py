"""Recordings and scanners as iterators."""
import inspect
import socket
import time
import unittest

import numpy as np

import edgescan
from support import HERE, bell_file, recording_file, served


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
        with served(small, "--rate", 400) as address, edgescan.connect(address, expected_lines=40, axis="sweep", record=record, timeout=60) as scanner:
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

    def test_a_peer_that_says_nothing(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            with self.assertRaises(edgescan.Error):
                edgescan.connect(f"127.0.0.1:{silent.getsockname()[1]}", timeout=1)

    def test_a_scanner_that_falls_silent(self):
        small = bell_file("small.json", 5, 40, 96)
        with served(small, "--rate", 400) as address, edgescan.connect(address, expected_lines=40, timeout=5) as scanner:
            with self.assertRaises(edgescan.Error):
                for _ in scanner:  # the emulated scanner stops after the last line
                    pass

    def test_waiting_is_not_silent(self):
        with self.assertLogs("edgescan", "WARNING") as logged, self.assertRaises(edgescan.Error) as refused:
            edgescan.connect("127.0.0.1:1", timeout=1)
        self.assertIn("127.0.0.1", logged.output[0])
        self.assertTrue(refused.exception.hint)

    def test_it_ends_after_its_time(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            started = time.monotonic()
            with self.assertRaises(edgescan.Error):
                edgescan.connect(f"127.0.0.1:{silent.getsockname()[1]}", timeout=0.5)
            self.assertLess(time.monotonic() - started, 30)  # a loaded machine; without a time-out it would be forever
        default = inspect.signature(edgescan.connect).parameters["timeout"].default
        self.assertTrue(0 < default <= 30)
        with self.assertRaisesRegex(TypeError, "timeout must be a number, not None"):
            edgescan.connect("127.0.0.1:1", timeout=None)

    def test_next_has_its_own_time(self):
        small = bell_file("small.json", 5, 40, 96)
        with served(small, "--rate", 400) as address, edgescan.connect(address, expected_lines=40, timeout=60) as scanner:
            while not scanner.next(timeout=60).finished:
                pass
            with self.assertRaises(edgescan.Error):
                while True:
                    scanner.next(timeout=0.2)
            scanner.stop()
        for use in (list, lambda closed: next(iter(closed)), lambda closed: closed.next(timeout=1)):
            with self.assertRaisesRegex(edgescan.Error, "the connection is closed; connect"):
                use(scanner)

    def test_a_loop_ends_where_the_connection_is_closed(self):
        small = bell_file("small.json", 5, 40, 96)
        with served(small, "--rate", 400) as address:
            scanner = edgescan.connect(address, expected_lines=40, timeout=60)
            sweeps = 0
            for _ in scanner:
                sweeps += 1
                scanner.stop()
            self.assertEqual(sweeps, 1)

    def test_a_recording_has_its_name(self):
        with self.assertRaisesRegex(edgescan.Error, "x_rec.pcd: the recording is an MCAP file; give a name that ends with .mcap"):
            edgescan.connect("127.0.0.1:1", timeout=1, record=HERE / "x_rec.pcd")
        self.assertFalse((HERE / "x_rec.pcd").exists())

    def test_the_names_are_those_of_open(self):
        names = {"axis", "line_start", "line_step", "calibration"}
        for function in (edgescan.open, edgescan.connect):
            self.assertLessEqual(names, set(inspect.signature(function).parameters))
        with self.assertRaisesRegex(TypeError, "did you mean 'line_start'"):
            edgescan.connect("127.0.0.1:1", first_line=3)


if __name__ == "__main__":
    unittest.main(verbosity=1)
