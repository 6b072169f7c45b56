"""Files that are imported as another code than stands on the disk, which stays as it is."""

from __future__ import annotations

import importlib.abc
import importlib.machinery
import importlib.util
from collections.abc import Mapping
from pathlib import Path
from types import CodeType, ModuleType


class Changed(importlib.machinery.SourceFileLoader):
    """Loads a file as another code, with names that this code calls."""

    code: CodeType
    names: Mapping[str, object]

    def get_code(self, fullname: str) -> CodeType:
        return self.code

    def exec_module(self, module: ModuleType) -> None:
        vars(module).update(self.names)
        super().exec_module(module)


class Finder(importlib.abc.MetaPathFinder):
    """Finds some files as other codes, by their resolved paths, and leaves all others to the importers behind it."""

    def __init__(self, codes: Mapping[Path, CodeType], names: Mapping[str, object] | None = None) -> None:
        self.codes, self.names = codes, names or {}
        self.stems = {stem for path in codes for stem in (path.stem, path.parent.name)}
        self.asked = False

    def find_spec(self, fullname, path, target=None):
        if fullname.rpartition(".")[2] not in self.stems or self.asked:
            return None
        self.asked = True
        try:
            spec = importlib.util.find_spec(fullname)
        finally:
            self.asked = False
        code = self.codes.get(Path(spec.origin).resolve()) if spec and spec.origin else None
        if spec is None or code is None:
            return None
        spec.loader = loader = Changed(fullname, str(spec.origin))
        loader.code, loader.names = code, self.names
        return spec
