"""REPORT.md, which keeps the rows of all mutants, and PENDING.txt, the mutants that have no row of today's sources yet."""
import re

from .lists import FOLDER, ROOT
from .rows import UNKNOWN, Row
from .trial import COMPILER

REPORT, PENDING = FOLDER / "REPORT.md", FOLDER / "PENDING.txt"
HEAD = """# What catches the planted faults

Written by `fuzz/mutants/report --write`, which keeps the rows of mutants that were not run again. {current} of {total} mutants
have a row that is current; `PENDING.txt` names the others. The checks of a list run in its order, and the first that fails is
named; *all that fail* is filled in by `fuzz/mutants/run --all-checks`. A campaign is asked about every mutant: its column says
how much it had checked when it saw the fault, and by which check.

A row is current if its digest is still that of its mutant: of the code of the function around it, or of the declaration that
is in no function, and of the mutant's own text, as words and signs, without comments and blanks ([more](README.md)). A change
elsewhere, in what the function calls or in the check, leaves the row current: the commit says what else the run had. The
commit ends with `+` if the sources differed from it. A row with `-` for both is older than these columns, and not current."""
PENDING_HEAD = """# Mutants without a current row in REPORT.md, and why. Written by fuzz/mutants/report --write.
# The limit may only be lowered: a mutant that is new, or whose function changes, is run before it lands.
"""


def escaped(text):
    return text.replace("|", "&#124;")


def read_rows(text):
    """The rows of a report by the names of their mutants."""
    rows = {}
    for line in text.splitlines():
        found = re.fullmatch(r"\| (\w+) \| ([^|]*) \| ([^|]*) \| (\S+) \| (\S+) \| ([^|]*) \|(.*)\|", line)
        if not found or found[1] == "mutant" or found[4] == "---":
            continue
        *said, _ = [cell.strip() for cell in found[7].split(" | ")]
        caught = "" if found[3] == "SURVIVED" or found[3].startswith("nothing: ") else found[3].replace("&#124;", "|")
        failed = None if not found[6].strip() else [] if found[6] == "none" else found[6].split("; ")
        rows[found[1]] = Row(found[1], found[5], found[4], caught, said, failed)
    return rows


def why_pending(mutant, mutants, row, root=ROOT):
    """Why the mutant has to be run or seen to; empty if its row is current and shows it caught, or excused."""
    if row is None:
        return "no row"
    if row.digest == UNKNOWN:
        return "row without a commit"
    if row.digest != mutant.digest(root):
        return f"changed since {row.commit}"
    names = [check.name for check in mutants.checks_of(mutant) + mutants.campaigns] + [COMPILER]
    if row.caught and not any(row.caught == name or row.caught.startswith(f"{name} (") for name in names):
        return "caught by a check that is gone"
    if not row.caught and not mutant.excuse:
        return "survived"
    return ""


def is_current(mutant, mutants, row, root=ROOT):
    """Whether the mutant need not be run again."""
    return why_pending(mutant, mutants, row, root) in ("", "survived")


def join(lists, *sources, root=ROOT):
    """One row of each mutant: a current one where there is one, with all checks asked if possible; of equals the last."""
    found = {}
    for each in lists:
        for mutant in each.mutants:
            rows = [rows[mutant.name] for rows in sources if mutant.name in rows]
            if rows:
                found[mutant.name] = max(enumerate(rows), key=lambda item: (
                    is_current(mutant, each, item[1], root), item[1].failed is not None, item[0]))[1]
    return found


def row_of(mutant, mutants, row):
    verdict = row.caught or (f"nothing: {mutant.excuse}" if mutant.excuse else "SURVIVED")
    failed = "" if row.failed is None else "; ".join(row.failed) or "none"
    said = row.said if len(row.said) == len(mutants.campaigns) else ["-"] * len(mutants.campaigns)
    cells = [mutant.name, mutant.file.removeprefix("src/"), escaped(verdict), row.commit, row.digest, failed, *said,
             escaped(mutant.why)]
    return f"| {' | '.join(cells)} |"


def report_text(lists, rows, root=ROOT):
    """All mutants that have a row, in the order of the lists."""
    text, current = [], 0
    for each in lists:
        known = [m for m in each.mutants if m.name in rows]
        survived = [m for m in known if not rows[m.name].caught and not m.excuse]
        harmless = [m for m in known if not rows[m.name].caught and m.excuse]
        now = sum(is_current(m, each, rows[m.name], root) for m in known)
        current += now
        text += ["", f"## {each.name}.list", "",
                 f"{len(known) - len(survived) - len(harmless)} caught, {len(harmless)} change no answer, "
                 f"{len(survived)} survived; "
                 f"{now} of {len(each.mutants)} rows are current.", "",
                 "| mutant | file | caught by | commit | digest | all that fail | " +
                 "".join(f"{c.name} (`{' '.join(c.args)}`) | " for c in each.campaigns) + "what it does |",
                 "| --- | --- | --- | --- | --- | --- | " + "--- | " * len(each.campaigns) + "--- |",
                 *(row_of(m, each, rows[m.name]) for m in known)]
    total = sum(len(each.mutants) for each in lists)
    return "\n".join([HEAD.format(current=current, total=total), *text]) + "\n"


def reasons(lists, rows, root=ROOT):
    """Why each pending mutant is."""
    found = {m.name: why_pending(m, each, rows.get(m.name), root) for each in lists for m in each.mutants}
    return {name: why for name, why in found.items() if why}


def read_pending(text):
    """The limit of how many may be pending, and their names."""
    limit = re.search(r"^at most (\d+)$", text, re.MULTILINE)
    names = [line.split(":")[0] for line in text.splitlines() if ":" in line and not line.startswith("#")]
    return int(limit[1]) if limit else 0, names


def pending_text(limit, why):
    return PENDING_HEAD + f"at most {limit}\n\n" + "".join(f"{name}: {reason}\n" for name, reason in why.items())


def wrong_things(lists, report, pending, root=ROOT):
    """What keeps the report from being evidence, or the list of pending mutants from shrinking."""
    rows = read_rows(report)
    why = reasons(lists, rows, root)
    limit, allowed = read_pending(pending)
    known = {m.name for each in lists for m in each.mutants}
    for name, reason in why.items():
        if name not in allowed:
            yield f"{name}: {reason}"
    for name in allowed:
        if name not in why:
            yield f"{name}: in PENDING.txt, but {'its row is current' if name in known else 'no mutant of a list'}"
    for name in rows:
        if name not in known:
            yield f"{name}: has a row, but is no mutant of a list"
    if len(allowed) > limit:
        yield f"PENDING.txt: {len(allowed)} mutants are pending, at most {limit} may be"
    if len(set(allowed)) != len(allowed):
        yield "PENDING.txt: a mutant is named twice"


def write(lists, rows, report=REPORT, pending=PENDING, root=ROOT):
    """Writes both files. The limit of the pending ones never grows."""
    why = reasons(lists, rows, root)
    limit, _ = read_pending(pending.read_text()) if pending.exists() else (len(why), [])
    report.write_text(report_text(lists, rows, root))
    pending.write_text(pending_text(min(limit, len(why)), why))
