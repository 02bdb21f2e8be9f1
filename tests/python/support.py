"""What the tests of the module share. ctest gives PYTHONPATH, EDGESCAN_CLI, EDGESCAN_LAB, EDGESCAN_SOURCE and EDGESCAN_SHARED_DIR (EDGESCAN_SHARED
before it)."""
import contextlib
import json
import os
import pathlib
import subprocess
import tempfile

CLI = os.environ["EDGESCAN_CLI"]
LAB = os.environ["EDGESCAN_LAB"]
SOURCE = pathlib.Path(os.environ["EDGESCAN_SOURCE"])
SHARED = pathlib.Path(os.environ.get("EDGESCAN_SHARED") or os.environ["EDGESCAN_SHARED_DIR"])
FOLDER = tempfile.TemporaryDirectory(prefix="edgescan-python-")
HERE = pathlib.Path(FOLDER.name)


def cli(*arguments, code=0, program=CLI):
    run = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert run.returncode == code, (arguments, run.returncode, run.stderr)
    return run


def lab(*arguments):
    return cli(*arguments, program=LAB)


def bell_file(name="bell.json", seed=7, lines=150, beams=191):
    path = HERE / name
    if not path.exists():
        lab("simulate", "-o", path, "--truth", HERE / (path.stem + "-truth"), "--seed", seed, "--lines", lines, "--beams", beams)
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
    process = subprocess.Popen([LAB, "emulate", str(path), "--port", "0", *map(str, arguments)], stdout=subprocess.PIPE, text=True)
    try:
        said = json.loads(process.stdout.readline())
        yield f"{said['host']}:{said['port']}"
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


