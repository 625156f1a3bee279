"""Makes a one-line error for arguments that fit no signature: it names the argument, its value and what is accepted."""
import enum
import operator
import re

import numpy as np

from . import _ecods

MAKE_A_MESH = "make an ecods.Mesh of it, ecods.Mesh(vertices, faces)"
PLAIN = {"int": "a whole number", "float": "a number", "str": "a text", "Posed": "a Mesh or Posed",
         "PosedRounded": "a Rounded", "PosedHalfSpace": "a HalfSpace"}


def with_article(noun):
    return ("an " if noun[0] in "aeiouAEIOU" else "a ") + noun


def describe(value):
    """Returns the type of a value and its shape or length, or the value itself if that is short."""
    if isinstance(value, np.ndarray):
        return f"a numpy array of shape {value.shape}"
    if isinstance(value, (list, tuple, dict, set)):
        return f"{with_article(type(value).__name__)} of {len(value)}"
    is_short = type(value) in (bool, float, type(None)) or type(value) is int and abs(value) < 2**70
    if is_short or type(value) is str and len(value) <= 40:
        return repr(value)
    return with_article(type(value).__name__)


def is_index(value):
    try:
        operator.index(value)
    except TypeError:
        return False
    return True


def is_number(value):
    try:
        float(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return not isinstance(value, (str, bytes))


def alternatives(kind):
    """Returns the kinds in a Union; for any other kind, the kind alone."""
    return split(kind[len("Union["):-1]) if kind.startswith("Union[") else [kind]


def accepts(kind, value):
    """Returns True if a parameter of this kind, as in a signature, takes a value. Unknown kinds take any value."""
    if kind.startswith("Union["):
        return any(accepts(each, value) for each in alternatives(kind))
    if kind.startswith("Optional["):
        return value is None or accepts(kind[len("Optional["):-1], value)
    named = getattr(_ecods, kind, None)
    if isinstance(named, enum.EnumMeta):
        return isinstance(value, named) or isinstance(value, str) and value in named.__members__
    if kind == "Posed":
        return isinstance(value, (_ecods.Posed, _ecods.Mesh))
    if kind == "PosedRounded":
        return isinstance(value, (_ecods.PosedRounded, _ecods.Rounded))
    if kind == "PosedHalfSpace":
        return isinstance(value, (_ecods.PosedHalfSpace, _ecods.HalfSpace))
    if isinstance(named, type):
        return isinstance(value, named)
    check = {"int": is_index, "float": is_number, "str": lambda x: isinstance(x, (str, bytes))}.get(kind)
    return check is None or check(value)


def wanted(kind):
    if kind.startswith("Optional["):
        return wanted(kind[len("Optional["):-1]) + " or None"
    named = getattr(_ecods, kind, None)
    if isinstance(named, enum.EnumMeta):
        return "one of " + ", ".join(named.__members__)
    return PLAIN.get(kind) or with_article(kind)


def hint(kinds, value):
    """Returns a hint how to make a Mesh or Posed from arrays, or from another library's mesh; or to swap two bodies."""
    if kinds == ["PosedHalfSpace"] and isinstance(value, (_ecods.Mesh, _ecods.Posed, _ecods.Rounded, _ecods.PosedRounded)):
        return ": of two bodies, the half space comes second"
    if "Posed" not in kinds and "Mesh" not in kinds:
        return ""
    place = ", and place it with .at(pose)" if "Posed" in kinds else ""
    if hasattr(value, "vertices") and hasattr(value, "faces"):
        return f": make one, ecods.Mesh(mesh.vertices, mesh.faces){place}"
    return f": {MAKE_A_MESH}{place}" if isinstance(value, (np.ndarray, list, tuple)) else ""


def split(text):
    """Returns the parts between the commas that are outside brackets."""
    depth, part, parts = 0, "", []
    for c in text:
        depth += (c in "([{<") - (c in ")]}>")
        if c == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += c
    return [each.strip() for each in [*parts, part] if each.strip()]


class Parameter:
    def __init__(self, text, by_position):
        self.name, rest = text.split(":", 1)
        kind, _, default = rest.strip().partition(" = ")
        self.kind = kind.replace("ecods._ecods.", "").replace("ecods.", "").replace("ecods::", "")
        self.default = default or None
        self.by_position = by_position

    def takes(self, value):
        return self.default == "None" and value is None or accepts(self.kind, value)


def parameters_of(signature):
    made, by_position = [], True
    for text in split(signature[signature.index("(") + 1:signature.rindex(")")]):
        if text.startswith("*"):
            by_position = False
        else:
            made.append(Parameter(text, by_position))
    return made


def problem(parameters, args, kwargs):
    """Returns (position, text, (kind, value) or None) for the first argument that does not fit; None if all seem to fit."""
    by_position = [each for each in parameters if each.by_position]
    names = ", ".join(each.name for each in parameters) or "none"
    for i, parameter in enumerate(parameters):
        label = f"argument {i + 1} ({parameter.name})"
        if i < min(len(args), len(by_position)):
            if parameter.name in kwargs:
                return i, f"{label} is given twice", None
            value = args[i]
        elif parameter.name in kwargs:
            value = kwargs[parameter.name]
        elif parameter.default is None:
            return i, f"{label} is missing; the arguments are {names}", None
        else:
            continue
        if not parameter.takes(value):
            return i, f"{label} is {describe(value)}", (parameter.kind, value)
    unknown = [name for name in kwargs if name not in {each.name for each in parameters}]
    if unknown:
        return len(parameters), f"there is no argument {unknown[0]!r}; the arguments are {names}", None
    if len(args) > len(by_position):
        return len(parameters), f"{len(args)} arguments are given; the arguments are {names}", None
    return None


def out_of_range(parameters, args, kwargs):
    for i, parameter in enumerate(parameters):
        value = args[i] if i < len(args) else kwargs.get(parameter.name)
        if parameter.kind == "int" and is_index(value) and not 0 <= operator.index(value) < 2**31:
            return f"argument {i + 1} ({parameter.name}) is {describe(value)}, which is out of range"
    return None


def line(text, args, kwargs):
    """Returns the line for a call that pybind11 refused with this text."""
    name = text[:text.index("(")]
    signatures = re.findall(r"^ +\d+\. (.*)$", text, re.M)
    is_method = signatures[0].startswith("(self: ")
    if name == "__init__":
        name = type(args[0]).__name__
        args = args[1:]
    elif is_method:
        name = f"{type(args[0]).__name__}.{name}"
        args = args[1:]
    overloads = [parameters_of(re.sub(r" -> .*$", "", each))[is_method:] for each in signatures]
    problems = [problem(each, args, kwargs) for each in overloads]
    if None in problems:
        found = [out_of_range(each, args, kwargs) for each in overloads]
        kinds = ", ".join(type(each).__name__ for each in [*args, *kwargs.values()])
        return f"{name}: {next(filter(None, found), 'arguments of these types are not taken: ' + kinds)}"
    furthest = max(position for position, _, _ in problems)
    last = [each for each in problems if each[0] == furthest]
    refused = [each for each in last if each[2] is not None]
    if not refused:
        return f"{name}: {last[0][1]}"
    kinds = list(dict.fromkeys(each for _, _, (kind, _) in refused for each in alternatives(kind)))
    value = refused[0][2][1]
    return f"{name}: {refused[0][1]}; {' or '.join(map(wanted, kinds))} is expected{hint(kinds, value)}"
