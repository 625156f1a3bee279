"""The rules by which mutants are drawn: each finds its sites in a file's code, and says what to write there."""
import re
from dataclasses import dataclass

from . import code


@dataclass(frozen=True)
class Site:
    begin: int
    end: int
    text: str  # in the place of what is there
    rule: str


# Binary operators have blanks around them, as .clang-format puts them; template brackets and references have not.
COMPARISON = re.compile(r"(?<= )(<=|>=|==|!=|<|>)(?= )")
COMPARED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
LOGIC = re.compile(r"(?<= )(&&|\|\|)(?= )")
SIGN = re.compile(r"(?<= )([+-]=?)(?= )")
UNARY_MINUS = re.compile(r"(?:(?<=[(\[{])|(?<=[=,?:<>|&*/+-] )|(?<=\breturn ))-(?=[\w(])")
NUMBER = re.compile(r"(?<![\w.'])(?:0[xX][\da-fA-F'.]+(?:[pP][+-]?\d+)?|\d[\d'.]*(?:[eE][+-]?\d+)?)(?=[uUlLzZfF]*\b|(?=\W))")
EXTREME = re.compile(r"\b(min|max)(?=\()")
ANSWER = re.compile(r"\breturn (true|false)(?=;)")
GUARD = re.compile(r"\bif \(")
LOOP = re.compile(r"\bfor \(")
SKIPPED = re.compile(r"\b(?:static_assert|ECODS_ASSERT|assert|noexcept|alignas|requires)\s*\(")
TERM_END = re.compile(r" (?:[+-]|<=|>=|==|!=|<|>|&&|\|\||\?|:|=) |[;,]")


def matching(text, begin):
    """The place after the parenthesis that closes the one at `begin`."""
    depth = 0
    for at in range(begin, len(text)):
        depth += (text[at] in "([{") - (text[at] in ")]}")
        if depth == 0:
            return at + 1
    return len(text)


def comparisons(text):
    return [Site(m.start(1), m.end(1), COMPARED[m[1]], "comparison") for m in COMPARISON.finditer(text)]


def logic(text):
    return [Site(m.start(1), m.end(1), "||" if m[1] == "&&" else "&&", "logic") for m in LOGIC.finditer(text)]


def signs(text):
    turned = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
    found = [Site(m.start(1), m.end(1), turned[m[1]], "sign") for m in SIGN.finditer(text)]
    return found + [Site(m.start(), m.end(), "", "sign") for m in UNARY_MINUS.finditer(text)]


def next_numbers(number):
    """Those beside it: the exponent of a power of two, or else an integer or the integral part, by one."""
    power = re.fullmatch(r"(0[xX][\da-fA-F.']+[pP])([+-]?\d+)", number)
    if power:
        return [f"{power[1]}{int(power[2]) + step}" for step in (1, -1)]
    if number[:2] in ("0x", "0X"):
        value = int(number.replace("'", ""), 16) if "." not in number else None
        return [] if value is None else [hex(value + step) for step in (1, -1) if value + step >= 0]
    if re.fullmatch(r"\d[\d']*", number):
        if len(number) > 1 and number[0] == "0":
            return []
        value = int(number.replace("'", ""))
        return [str(value + step) for step in (1, -1) if value + step >= 0]
    part = re.fullmatch(r"(\d[\d']*)(\..*)", number)  # 4.25
    return [f"{int(part[1].replace(chr(39), '')) + step}{part[2]}" for step in (1, -1)
            if int(part[1].replace("'", "")) + step >= 0] if part else []


def constants(text):
    return [Site(m.start(), m.end(), value, "constant") for m in NUMBER.finditer(text) for value in next_numbers(m[0])]


def end_of_term(text, begin):
    """Where the term of a sum that begins there ends: at the next operator that binds less, or at the closing bracket."""
    at = begin
    while at < len(text):
        if text[at] in "([{":
            at = matching(text, at)
        elif text[at] in ")]}" or TERM_END.match(text, at):
            return at
        else:
            at += 1
    return at


def begin_of_term(text, end):
    """Where the term that ends there begins, if it is the first of its sum; or None."""
    at = end
    while at > 0:
        if text[at - 1] in ")]}":
            depth = 0
            while at > 0:
                at -= 1
                depth += (text[at] in ")]}") - (text[at] in "([{")
                if depth == 0:
                    break
        elif text[at - 1] in "([{,;" or re.search(r"(?:= |return |[<>?:] )$", text[max(0, at - 8):at]):
            return at
        elif re.search(r" [+-] $", text[max(0, at - 3):at]):
            return None
        else:
            at -= 1
    return at


def dropped_terms(text):
    """Terms of sums in what computes a bound: in a unit, or a statement, that has the word."""
    found = []
    for m in re.finditer(r" \+ ", text):
        begin, end = m.start(), end_of_term(text, m.end())
        found.append(Site(begin, end, "", "dropped term"))
        first = begin_of_term(text, begin)
        if first is not None and text[first:begin].strip():
            blanks = len(text[first:begin]) - len(text[first:begin].lstrip())
            found.append(Site(first + blanks, m.end(), "", "dropped term"))
    return [site for site in found if is_of_a_bound(text, site)]


BOUND = re.compile(r"bound|margin|error|slack|widen|outward|radius", re.IGNORECASE)


def is_of_a_bound(text, site):
    unit = next((u for u in code.units(text) or [] if u.begin <= site.begin < u.end), None)
    head = text[unit.begin:unit.end].split("{")[0] if unit else ""
    begin = max(text.rfind(sign, 0, site.begin) for sign in ";{}") + 1
    end = text.find(";", site.end)
    return bool(BOUND.search(head) or BOUND.search(text[begin:end]))


def extremes(text):
    return [Site(m.start(1), m.end(1), "max" if m[1] == "min" else "min", "min and max") for m in EXTREME.finditer(text)]


def answers(text):
    return [Site(m.start(1), m.end(1), "false" if m[1] == "true" else "true", "returned truth") for m in ANSWER.finditer(text)]


def guards(text):
    """Conditions that always hold, or never; those that declare what the branch uses are left alone."""
    found = []
    for m in GUARD.finditer(text):
        begin, end = m.end(), matching(text, m.end() - 1) - 1
        if not re.search(r";|(?<![=!<>])=(?!=)", text[begin:end]):
            found += [Site(begin, end, value, "guard") for value in ("false", "true") if text[begin:end].strip() != value]
    return found


def loops(text):
    """Loops that begin one later, or end one earlier or later."""
    found = []
    for m in LOOP.finditer(text):
        parts = re.match(r"([^;]*);([^;]*);", text[m.end():matching(text, m.end() - 1)])
        if not parts:
            continue
        start = re.search(r"= 0(?=$|,)", parts[1])
        if start:
            found.append(Site(m.end() + start.start() + 2, m.end() + start.end(), "1", "loop"))
        compared = re.search(r" (<|!=|<=) ", parts[2])
        if compared:
            at = m.end() + parts.start(2) + compared.start(1)
            found.append(Site(at, at, "+ 1 ", "loop"))
    return found


RULES = (comparisons, signs, constants, dropped_terms, extremes, logic, answers, guards, loops)


def sites(text):
    """All sites of a file in its order, each with text that differs from what is there."""
    plain = code.structure(text)
    skipped = [(m.start(), matching(plain, m.end() - 1)) for m in SKIPPED.finditer(plain)]
    found = {site for rule in RULES for site in rule(plain)
             if not any(begin <= site.begin < end for begin, end in skipped)}
    return sorted((s for s in found if text[s.begin:s.end] != s.text), key=lambda s: (s.begin, s.end, s.rule, s.text))
