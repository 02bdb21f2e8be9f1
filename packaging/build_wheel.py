"""Build backend for pip: CMake builds the Python module, this file packs it as a wheel. Needs only Python and the system's packages."""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def _version():
    return re.search(r"project\(EdgeScan VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def _metadata():
    return (f"Metadata-Version: 2.1\nName: edgescan\nVersion: {_version()}\nSummary: Edges of rocks in laser range scans\n"
            f"License: BSD-3-Clause\nRequires-Python: =={sys.version_info[0]}.{sys.version_info[1]}.*\nRequires-Dist: numpy\n")


def _tag():
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _system():
    """The interpreter below the virtual environment, and an environment in which it sees the system's numpy: pip hides both."""
    hidden = ("PYTHONPATH", "PYTHONHOME", "PYTHONNOUSERSITE", "VIRTUAL_ENV")
    return os.path.realpath(sys.executable), {name: value for name, value in os.environ.items() if name not in hidden}


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = ROOT / "build" / "wheel"
    python, environment = _system()
    subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DEDGESCAN_VIEWER=OFF",
                    "-DEDGESCAN_TESTS=OFF", "-DEDGESCAN_UNITY=ON", f"-DPython3_EXECUTABLE={python}",
                    "-DEDGESCAN_PYTHON_INSTALL_DIR=."], check=True, env=environment)
    subprocess.run(["cmake", "--build", build, "--target", "edgescan_python_package"], check=True, env=environment)
    if not (build / "python" / "edgescan").is_dir():
        raise RuntimeError("the Python module was not built: install pybind11-dev, python3-dev and python3-numpy, or run packaging/install-packages")
    files = {f"edgescan/{path.name}": path.read_bytes() for path in sorted((build / "python" / "edgescan").iterdir()) if path.is_file()}
    info = f"edgescan-{_version()}.dist-info"
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: edgescan\nRoot-Is-Purelib: false\nTag: {_tag()}\n".encode()
    record = ""
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    name = f"edgescan-{_version()}-{_tag()}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, content)
    return name
