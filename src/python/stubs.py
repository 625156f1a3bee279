#!/usr/bin/env python3
"""Writes stubs for editors and type checkers, from the signatures of the module: OUT, and _ecods.pyi beside it.

usage: PYTHONPATH=FOLDER_OF_THE_PACKAGE stubs.py OUT
"""
import enum
import pathlib
import re
import sys

sys.path.pop(0)  # this file's folder, where the package lacks its module

import ecods  # noqa: E402
from ecods.refusals import split  # noqa: E402

TAKEN = {"numpy.ndarray": "ArrayLike", "object": "ArrayLike",
         "tuple[float, float, float, float]": "ArrayLike", "Posed": "Posed | Mesh",
         "PosedRounded": "PosedRounded | Rounded", "PosedHalfSpace": "PosedHalfSpace | HalfSpace",
         "int | Posed | PosedRounded | PosedHalfSpace":
             "int | Posed | Mesh | PosedRounded | Rounded | PosedHalfSpace | HalfSpace"}
PYTHON = ["CollisionManager", "ContactData", "DistanceData"]
GIVEN = {"object": "Any", "dict": "dict[str, Any]"}


def plain(text):
    """Returns a type without the names of modules that pybind11 writes."""
    text = text.replace("ecods._ecods.", "").replace("ecods.", "").replace("ecods::", "")
    text = re.sub(r"\bUnion\[([^\[\]]*)\]", lambda match: match.group(1).replace(", ", " | "), text)
    text = re.sub(r"numpy\.ndarray\[[^\]]*\]", "numpy.ndarray", text)
    return re.sub(r"\b(List|Tuple|Dict)\b", lambda match: match.group(1).lower(), text)


def taken(name, text, default):
    kind = plain(text)
    kind = TAKEN.get(kind, kind)
    if isinstance(getattr(ecods, kind, None), enum.EnumMeta):
        kind += " | str"
    if default == "None" and not kind.startswith("Optional"):
        kind += " | None"
    return f"{name}: {kind}" + ("" if default is None else " = ...")


def signatures(doc):
    """Yields (arguments, result, text) of each overload."""
    lines = (doc or "").splitlines()
    pattern = re.compile(r"^(?:\d+\. )?\w+\((.*)\) -> (.*)$")
    found = [(i, pattern.match(line)) for i, line in enumerate(lines)]
    found = [(i, match) for i, match in found if match]
    for (i, match), after in zip(found, [i for i, _ in found[1:]] + [len(lines)]):
        text = " ".join(line.strip() for line in lines[i + 1:after] if line.strip())
        yield match.group(1), match.group(2), text.replace("Overloaded function.", "").strip()


def function(name, doc, indent="", is_static=False):
    made = []
    for arguments, result, text in signatures(doc):
        parts = []
        for i, argument in enumerate(split(arguments)):
            match = re.match(r"^(\w+): (.*?)(?: = (.*))?$", argument)
            if i == 0 and indent and not is_static:
                parts.append("self")
            elif match is None:
                parts.append(argument)
            else:
                parts.append(taken(match.group(1), match.group(2), match.group(3)))
        kind = plain(result)
        head = f"{indent}def {name}({', '.join(parts)}) -> {GIVEN.get(kind, kind)}:"
        body = f'\n{indent}    """{text}"""' if text else " ..."
        made.append((f"{indent}@staticmethod\n" if is_static else "") + head + body)
    if len(made) > 1:
        made = [f"{indent}@overload\n{each}" for each in made]
    return made


def members(kind):
    for name, member in vars(kind).items():
        if isinstance(member, property):
            result = next(signatures("x" + (member.fget.__doc__ or "").strip()), (None, "Any", ""))[1]
            yield f"    @property\n    def {name}(self) -> {plain(result)}:" + (
                f'\n        """{member.__doc__}"""' if member.__doc__ else " ...")
        elif name in ("__init__", "__len__") or (callable(member) or isinstance(member, staticmethod)) and name[0] != "_":
            static = isinstance(member, staticmethod)
            yield from function(name, getattr(kind, name).__doc__, "    ", static)


def class_of(name, kind):
    base = kind.__bases__[0].__name__
    if issubclass(kind, enum.Enum):
        return "\n".join([f"class {name}(IntEnum):", f'    """{kind.__doc__}"""', *[f"    {each.name} = {each.value}" for each in kind]])
    bases = "" if base in ("object", "pybind11_object") else f"({base})"
    lines = [f"class {name}{bases}:"]
    if kind.__doc__:
        lines.append(f'    """{kind.__doc__}"""')
    if issubclass(kind, Exception) and kind is not ecods.Error:
        lines.append("    def __getattr__(self, name: str) -> Any: ...")
    return "\n".join([*lines, *members(kind), "    ..."])


def main(out):
    made = ["# Written by stubs.py.", "from enum import IntEnum", "from typing import Any, Optional, overload", "",
            "import numpy", "from numpy.typing import ArrayLike", "",
            *[f"from .collision_manager import {name} as {name}" for name in PYTHON], "", "__version__: str", ""]
    for name in ecods.__all__:
        thing = getattr(ecods, name)
        if isinstance(thing, type) and thing.__module__ == "ecods":
            made += [class_of(name, thing), ""]
        elif callable(thing) and not isinstance(thing, type):
            made += function(name, thing.__doc__) + [""]
    with open(out, "w", encoding="utf-8") as file:
        file.write("\n".join(made))
    # Writes the stub of _ecods, from which the package's own files import.
    names = [name for name in ecods.__all__ if hasattr(ecods._ecods, name)]
    with open(pathlib.Path(out).with_name("_ecods.pyi"), "w", encoding="utf-8") as file:
        file.write("\n".join(["# Written by stubs.py.", *[f"from . import {name} as {name}" for name in names], ""]))


if __name__ == "__main__":
    main(sys.argv[1])
