"""C++ text as the tools for mutants see it: without comments, divided into functions and other declarations, and digested."""
import functools
import hashlib
import re
from dataclasses import dataclass

# A comment or a literal. A quote after a letter or digit separates digits, or ends a prefix such as u8.
COMMENT = r"//[^\n]*|/\*.*?(?:\*/|\Z)"
LITERAL = r'R"(?P<tag>[^\s()\\]*)\(.*?\)(?P=tag)"|"(?:[^"\\\n]|\\.)*"|(?<![0-9A-Za-z])\'(?:[^\'\\\n]|\\.)*\''
PART = re.compile(f"(?P<comment>{COMMENT})|{LITERAL}", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.)*", re.MULTILINE | re.DOTALL)
TOKEN = r"\w+|[^\w\s]"
LINES_AROUND = 20  # of a place in a file whose braces do not match


def blank(text):
    """The text as spaces and line ends: places in the file stay where they are."""
    return re.sub(r"[^\n]", " ", text)


@functools.lru_cache(maxsize=None)
def without_comments(text):
    return PART.sub(lambda found: blank(found[0]) if found["comment"] else found[0], text)


@functools.lru_cache(maxsize=None)
def structure(text):
    """The code alone: comments, literals and preprocessor directives are blanked."""
    code = PART.sub(lambda found: blank(found[0]), text)
    return DIRECTIVE.sub(lambda found: blank(found[0]), code)


def tokens(text):
    """The code as words and signs, which no formatting changes."""
    return " ".join(re.findall(TOKEN, without_comments(text)))


def digest(*texts):
    return hashlib.sha256("\0".join(tokens(text) for text in texts).encode()).hexdigest()[:12]


@dataclass(frozen=True)
class Unit:
    """A function or another declaration that no function or type encloses; or the head of a namespace or type."""
    begin: int
    end: int


HAS_MEMBERS = re.compile(r"(?:\s|\[\[.*?\]\]|\b(?:inline|export|typedef|public|private|protected)\b|:(?!:))*"
                         r"(?:namespace|class|struct|union|extern)\b", re.DOTALL)


def has_members(head):
    """Whether the block after `head` holds declarations. `enum` is a declaration as a whole."""
    head = head.lstrip()
    while head.startswith("template"):
        depth, at = 0, head.find("<")
        for at in range(max(at, 0), len(head)):
            depth += (head[at] == "<") - (head[at] == ">")
            if depth == 0:
                break
        head = head[at + 1:].lstrip()
    return HAS_MEMBERS.match(head) is not None


@functools.lru_cache(maxsize=None)
def units(text):
    """The units of a file in order, or None if its braces do not match."""
    code = structure(text)
    found, depth, parentheses, begin = [], 0, 0, 0  # depth: of blocks inside the present unit
    for sign in re.finditer(r"[{}();]", code):
        at, kind = sign.start(), sign[0]
        if kind in "()":
            parentheses += 1 if kind == "(" else -1
        elif parentheses > 0:
            continue
        elif kind == "{":
            if depth == 0 and has_members(code[begin:at]):
                found.append(Unit(begin, at + 1))
                begin = at + 1
            else:
                depth += 1
        elif kind == ";":
            if depth == 0:
                found.append(Unit(begin, at + 1))
                begin = at + 1
        elif depth == 0:  # the end of a namespace or type; what is left before it is an enumerator or nothing
            found.append(Unit(begin, at + 1))
            begin = at + 1
        else:
            depth -= 1
            # `}` ends a function's body, unless the declaration goes on: an initializer, or a type with a name after it.
            if depth == 0 and re.match(r"\s*(?:[\w~}#]|\[\[|::|\Z)", code[at + 1:at + 200]):
                found.append(Unit(begin, at + 1))
                begin = at + 1
    if depth != 0 or parentheses != 0:
        return None
    return [*found, Unit(begin, len(text))]


def text_around(text, begin, end):
    """The units that have a part of [begin, end) in them; in a directive the directive alone."""
    for found in DIRECTIVE.finditer(without_comments(text)):
        if found.start() <= begin and end <= found.end():
            return found[0]
    all_units = units(text)
    if all_units is not None:
        near = [unit for unit in all_units if unit.begin < end and begin < unit.end]
        return without_comments(text)[near[0].begin:near[-1].end]
    lines = without_comments(text).splitlines()
    first, last = text.count("\n", 0, begin), text.count("\n", 0, end)
    return "\n".join(lines[max(0, first - LINES_AROUND):last + LINES_AROUND + 1])
