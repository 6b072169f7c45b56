"""The files that Python, Drake and matplotlib need, and that a submission may therefore read."""

from __future__ import annotations

import sys
import sysconfig
from importlib.util import find_spec
from pathlib import Path

_SYSTEM = (
    "/usr/lib", "/usr/lib64", "/usr/libexec", "/usr/local/lib", "/lib", "/lib64", "/bin", "/usr/bin", "/usr/share/fonts",
    "/usr/share/zoneinfo", "/etc/ld.so.cache", "/etc/localtime", "/etc/mime.types", "/etc/fonts", "/nix/store",
    "/sys/devices/system/cpu",
)  # fmt: skip
_PACKAGES = ("site-packages", "dist-packages")
DEVICES = tuple(Path("/dev") / name for name in ("null", "zero", "random", "urandom"))


def readable_places() -> tuple[Path, ...]:
    """Return the files and folders that are needed, each once; never the working folder, nor the whole of a home."""
    paths = sysconfig.get_paths()
    found = [paths[name] for name in ("stdlib", "platstdlib", "purelib", "platlib")]
    found += [str(Path(prefix) / part) for prefix in (sys.prefix, sys.base_prefix) for part in ("lib", "bin")]
    found += [str(Path(sys.prefix) / "pyvenv.cfg"), *(each for each in sys.path if Path(each).name in _PACKAGES)]
    for room in ("models", "verification", "course"):
        spec = find_spec(f"armproof.{room}")
        found += spec.submodule_search_locations or [] if spec is not None else []
    places = dict.fromkeys(Path(each).absolute() for each in (*found, *_SYSTEM) if Path(each).exists())
    return tuple(each for each in places if each.resolve() != Path("/"))


def lies_in_readable(path: Path) -> Path | None:
    """Return the readable place that a path lies in, which would show it to every submission; None if there is none."""
    real = path.resolve()
    return next((place for place in readable_places() if real.is_relative_to(place.resolve())), None)
