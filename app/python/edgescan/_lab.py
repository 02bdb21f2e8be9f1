"""benchmark(): runs the program edgescan-lab, because the module has no code of the laboratory."""
# mypy: ignore-errors
from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
from typing import Any, Dict, Iterable, Optional, Union

from ._edgescan import Scan, save_scan
from ._values import Path, each, path as path_of, public, refuse, word


def arguments(truth, pictures, tolerance, best, repeats, only, peers, peer_seconds):
    typed = {"--truth": truth, "--pictures": pictures, "--tolerance": tolerance, "--repeats": repeats, "--peer-seconds": peer_seconds}
    flags = [os.fsencode(str(part)) if not isinstance(part, bytes) else part
             for flag, value in typed.items() if value is not None for part in (flag, value)]
    if only is not None:
        names = [only] if isinstance(only, str) else each("benchmark(): only", "a str or a list of them", only)
        flags += [b"--only", ",".join(word("benchmark(): only", name) for name in names).encode()]
    return flags + [b"--best"] * best + [b"--no-peers"] * (not peers)


def run(program, file, flags):
    found = shutil.which(os.fsdecode(program))
    if found is None:
        refuse("this program is not installed", os.fsdecode(program), "build it with packaging/build release, or give program=PATH")
    done = subprocess.run([found, "benchmark", file, "--json", "-", *flags], capture_output=True, check=False)
    if done.returncode:
        said = os.fsdecode(done.stderr).strip().splitlines()
        refuse(said[-1].split(": ", 1)[-1].rstrip(".") if said else f"it ended with {done.returncode}", "edgescan-lab benchmark", "")
    return json.loads(done.stdout)


@public
def benchmark(what: Union[Path, Scan], *, truth: Optional[Path] = None, pictures: Optional[Path] = None, tolerance: Optional[float] = None,
              best: bool = False, repeats: Optional[int] = None, only: Union[None, str, Iterable[str]] = None, peers: bool = True,
              peer_seconds: Optional[float] = None, program: Path = "edgescan-lab") -> Dict[str, Any]:
    """Every method, and PCL's peers, on one scan: the JSON of `edgescan-lab benchmark --json` as a dict. Times are of this machine.

    what: a file, or a Scan, which is saved to a temporary file. truth: the folder of Simulation.save_truth(); then each method has scores.
    pictures: new folder for the masks. tolerance: cells between a detection and a true edge. best: also the score at each method's best
    threshold. repeats: runs of each method, for the times. only: keys of methods. peers, peer_seconds: PCL's methods, and their time.
    program: edgescan-lab is started as a process of its own; it is in no package: packaging/build release makes it.

    >>> edgescan.benchmark(bell.scan, only="edgescan+", program=lab)["schema"]
    'edgescan-benchmark/1'
    """
    flags = arguments(truth, pictures, tolerance, best, repeats, only, peers, peer_seconds)
    if not isinstance(what, Scan):
        return run(program, path_of("benchmark(): what", what), flags)
    with tempfile.TemporaryDirectory(prefix="edgescan-") as folder:
        file = os.path.join(os.fsencode(folder), b"scan.pcd") # holds every kind of scan, with every range as it is
        save_scan(what, file, {"frame": "scanner"})
        return run(program, file, flags)
