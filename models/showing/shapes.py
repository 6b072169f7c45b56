"""Shapes for an arm whose meshes are not there: rods from joint to joint."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import acos, atan2, hypot
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

SHOWN = (".obj", ".gltf", ".glb", ".vtk")  # the meshes that Drake shows


def with_shapes(text: str, folder: Path) -> str | None:
    """Return a URDF in which links without their meshes are rods from joint to joint; None where all meshes are there."""
    root = ElementTree.fromstring(text)
    absent = [link for link in root.findall("link") if any(not _is_there(name, folder) for name in _meshes(link))]
    if not absent:
        return None
    ends: dict[str, list[tuple[float, ...]]] = {}
    for joint in root.findall("joint"):
        ends.setdefault(_parent(joint), []).append(_origin(joint))
    reach = sum(hypot(*end) for found in ends.values() for end in found)
    for link in absent:
        for part in [part for part in link if part.tag in ("visual", "collision")]:
            link.remove(part)
        _add_rods(link, ends.get(str(link.get("name")), []), max(reach, 0.2) / 50)
    for mesh in root.iter("mesh"):
        mesh.set("filename", str(_file(str(mesh.get("filename")), folder)))
    return ElementTree.tostring(root, encoding="unicode")


def _add_rods(link: Element, ends: list[tuple[float, ...]], radius: float) -> None:
    SubElement(SubElement(SubElement(link, "visual"), "geometry"), "sphere", radius=f"{radius:g}")
    for end in ends:
        length = hypot(*end)
        if length > radius:
            visual = SubElement(link, "visual")
            rpy = (0.0, acos(end[2] / length), atan2(end[1], end[0]))
            SubElement(visual, "origin", xyz=_text(part / 2 for part in end), rpy=_text(rpy))
            SubElement(SubElement(visual, "geometry"), "cylinder", radius=f"{radius / 2:g}", length=f"{length:g}")


def _meshes(link: Element) -> Iterator[str]:
    return (str(mesh.get("filename")) for mesh in link.iter("mesh"))


def _is_there(name: str, folder: Path) -> bool:
    return name.endswith(SHOWN) and _file(name, folder).is_file()


def _file(name: str, folder: Path) -> Path:
    """Return the file of a mesh: beside the model, or in a package, whose folder is one of those above it or beside them."""
    package, _, rest = name.removeprefix("package://").partition("/")
    if not name.startswith("package://"):
        return (folder / name.removeprefix("file://")).resolve()
    places = [
        place for above in (folder, *folder.parents) for place in (above / package, above) if place.name == package
    ]
    return next((place / rest for place in places if (place / rest).is_file()), folder / rest)


def _parent(joint: Element) -> str:
    found = joint.find("parent")
    return "" if found is None else str(found.get("link"))


def _origin(joint: Element) -> tuple[float, ...]:
    found = joint.find("origin")
    return tuple(map(float, (found.get("xyz") or "0 0 0").split())) if found is not None else (0.0, 0.0, 0.0)


def _text(values: Iterable[float]) -> str:
    return " ".join(repr(value) for value in values)
