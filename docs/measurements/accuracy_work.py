"""The jobs of docs/measurements/make-accuracy and docs/measurements/make-rocks: scenes and results, two at a time, stored in build/accuracy and build/rocks.

A submitted job returns a future. A job that waits for other jobs is submitted after them, so that no job waits for ever."""
import concurrent.futures
import hashlib
import json
import os
import shutil
import subprocess
import sys
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CLI = os.environ.get("EDGESCAN_CLI") or os.path.join(ROOT, "build/release/bin/edgescan-cli")
CACHE = os.path.join(ROOT, "build", os.environ.get("EDGESCAN_KEEP", "accuracy"))
AT_ONCE = 2

POOL = concurrent.futures.ThreadPoolExecutor(AT_ONCE)
JOBS = {}
TELL = threading.Lock()
DONE = [0]


def hash_of(*files):
    total = hashlib.sha256()
    for name in files:
        with open(name, "rb") as file:
            total.update(file.read())
    return total.hexdigest()


def key(*parts):
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:16]


def simulator():
    sources = [os.path.join(ROOT, "app/lab/commands/simulate.cpp")]
    for folder in ("app/lab/sim", "app/lab/sim/truth"):
        folder = os.path.join(ROOT, folder)
        sources += [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith((".cpp", ".h"))]
    return hash_of(*sorted(sources))


def program():
    """A copy of edgescan-cli, edgescan-lab and edgescan-peers, which a later build cannot change; returns the path of edgescan-cli."""
    if not os.path.exists(CLI):
        sys.exit("%s: this program does not exist; build it with ./test, or name another in EDGESCAN_CLI." % CLI)
    others = [os.path.join(os.path.dirname(CLI), name) for name in ("edgescan-lab", "edgescan-peers")]
    parts = [CLI] + [other for other in others if os.path.exists(other)]
    digest = hash_of(*parts)
    folder = os.path.join(CACHE, "program-" + digest[:16])
    os.makedirs(folder, exist_ok=True)
    for part in parts:
        copy = os.path.join(folder, os.path.basename(part))
        if not os.path.exists(copy):
            shutil.copy2(part, copy + ".part")
            os.rename(copy + ".part", copy)
    return os.path.join(folder, os.path.basename(CLI))


os.makedirs(CACHE, exist_ok=True)
PROGRAM = program()
SIMULATOR = simulator()


def run(arguments):
    measures = arguments[0] in ("benchmark", "evaluate", "simulate", "stones")
    done = subprocess.run([os.path.join(os.path.dirname(PROGRAM), "edgescan-lab") if measures else PROGRAM] + arguments, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip())
    return done.stdout


def job(path, name, make):
    """Calls `make(new)`, which writes a file or folder to `new`; it is renamed to `path` when it is complete. Returns a future of `path`."""
    def work():
        start = time.time()
        if not os.path.exists(path):
            new = path + ".part"
            shutil.rmtree(new, ignore_errors=True)
            make(new)
            os.rename(new, path)
        with TELL:
            DONE[0] += 1
            print("[%d of %d] %s, %.1f s" % (DONE[0], len(JOBS), name, time.time() - start), file=sys.stderr, flush=True)
        return path
    if path not in JOBS:
        JOBS[path] = POOL.submit(work)
    return JOBS[path]


class Case:
    """A scan with its truth; either may still be a future."""

    def __init__(self, ready, scan, truth):
        self.ready, self.scan, self.truth = ready, scan, truth


def scene(name, seed, flags):
    folder = os.path.join(CACHE, "%s-%d-%s" % (name, seed, key(name, seed, flags, SIMULATOR)))

    def make(new):
        os.makedirs(new)
        run(["simulate", "-o", new + "/scan.json", "--truth", new + "/truth", "--scene", name, "--seed", str(seed), "--threads", "1"] + flags)
    return Case(job(folder, "scene %s, seed %d %s" % (name, seed, " ".join(flags[4:])), make), folder + "/scan.json", folder + "/truth")


STONES = os.path.join(os.path.dirname(ROOT), "shared/data/real_stones/stones")


def heap(kind, seed, view=0, flags=()):
    """A scan of a heap of real stones of the set that no weights learn from. The heaps that came to rest are stored."""
    sources = sorted(os.path.join(ROOT, "app/lab/stones", name) for name in os.listdir(os.path.join(ROOT, "app/lab/stones")))
    folder = os.path.join(CACHE, "stones-%s-%d-%d-%s" % (kind, seed, view, key(flags, SIMULATOR, hash_of(*sources))))

    def make(new):
        os.makedirs(new)
        run(["stones", "--stones", STONES, "--kind", kind, "--set", "lab", "--seed", str(seed), "--view", str(view), "--settled", os.path.join(CACHE, "heaps"),
             "-o", new + "/scan.json", "--truth", new + "/truth", "--threads", "1"] + list(flags))
    return Case(job(folder, "stones, %s, seed %d, view %d %s" % (kind, seed, view, " ".join(flags)), make), folder + "/scan.json", folder + "/truth")


def found(name, flags, arguments):
    """Future of a result from the program's JSON; `flags()` are known when earlier jobs are done."""
    arguments = list(arguments)
    path = os.path.join(CACHE, "result-" + key(arguments, name, PROGRAM) + ".json")

    def make(new):
        text = run(arguments + flags())
        with open(new, "w") as file:
            file.write(text)
    return job(path, name, make)


def read(future):
    with open(future.result()) as file:
        return json.load(file)


def evaluated(cases, method, tolerance=2, like=None):
    """Figures of a method on all cases together. With `like`: also at the threshold that was best there."""
    arguments = ["evaluate"] + [case.scan for case in cases]
    for case in cases:
        arguments += ["--truth", case.truth]
    arguments += method[1] + ["--tolerance", str(tolerance), "--json", "-", "--sweep"]

    def flags():
        for case in cases:
            case.ready.result()
        if like is None:
            return []
        return ["--thresholds", repr(read(like)["sweep"]["all"]["ods_threshold"])]
    return found("%s on %d scans, tolerance %d%s" % (method[0].strip("*"), len(cases), tolerance, " at one threshold" if like else ""), flags, arguments)


def stop():
    POOL.shutdown(wait=False, cancel_futures=True)
