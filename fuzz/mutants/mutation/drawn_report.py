"""DRAWN.md, the table of the mutants that were drawn, and DRAWN.rows, from which the campaign goes on elsewhere."""
from collections import Counter

from . import draw
from .lists import FOLDER, ROOT
from .rows import DrawnRow
from .trial import NOT_COMPILED, SURVIVED

TABLE, ROWS = FOLDER / "DRAWN.md", FOLDER / "DRAWN.rows"
ROWS_HEAD = """# Lists the mutants that were drawn: name, commit, program that caught it or -, outcome.
# Written by fuzz/mutants/drawn.
"""
HEAD = """# What catches mutants that are drawn by rule

Written by `fuzz/mutants/drawn --seed {seed} --count {count}`: mutants of the code of `src`, each folder's number in
proportion to its lines of code, in turn by each rule ({rules}).
`src/python` is left out: its module is not built with mutants. {run} of {drawn} were run. Each is asked by the checks that
`rooms.checks` has for its folder, until one fails. *Not compiled* counts as caught. Mutants that change no answer, such as one
of a heuristic, survive: survivors are questions to whoever reads them, not faults of tests. A row counts as long as the
function around its mutant stays as it was.

A first pass (`--stages`) leaves a mutant that it does not catch to a run that asks all checks, and such a mutant does not
count as run. So the share of survivors is known only once all are run.
"""


def read_rows(text):
    rows = {}
    for line in text.splitlines():
        if line and not line.startswith("#"):
            name, commit, program, outcome = line.split(" ", 3)
            rows[name] = DrawnRow(name, commit, outcome, "" if program == "-" else program)
    return rows


def rows_text(rows):
    return ROWS_HEAD + "".join(f"{row.name} {row.commit} {row.program or '-'} {row.outcome}\n"
                               for row in sorted(rows.values(), key=lambda row: row.name))


def table(title, keys, stages, drawn, rows, key_of):
    """A line for each key: how many were drawn and run, and what became of them."""
    lines = [f"| {title} | drawn | run | {NOT_COMPILED} | {' | '.join(stages)} | {SURVIVED} |",
             "| --- |" + " ---: |" * (len(stages) + 4)]
    for key in [*keys, None]:
        these = [m for m in drawn if key is None or key_of(m) == key]
        outcomes = Counter(rows[m.name].outcome for m in these if m.name in rows)
        figures = [len(these), sum(outcomes.values()), *(outcomes[each] for each in (NOT_COMPILED, *stages, SURVIVED))]
        lines.append(f"| {key or '**all**'} | {' | '.join(map(str, figures))} |")
    return lines


def report_text(seed, count, drawn, rows, stages, root=ROOT):
    rules = sorted({m.rule for m in drawn})
    run = sum(m.name in rows for m in drawn)
    text = [HEAD.format(seed=seed, count=count, rules=", ".join(rules), run=run, drawn=len(drawn))]
    text += table("folder", sorted({m.room() for m in drawn}), stages, drawn, rows, draw.Drawn.room)
    text += ["", *table("rule", rules, stages, drawn, rows, lambda m: m.rule)]
    survivors = [m for m in drawn if m.name in rows and rows[m.name].outcome == SURVIVED]
    text += ["", "## Survivors", "",
             "| place | rule | commit | code, and [what was -> what replaced it] |", "| --- | --- | --- | --- |"]
    for m in survivors:
        shown = m.shown(root).replace("|", "&#124;")
        text.append(f"| `{m.file}:{m.line}` | {m.rule} | {rows[m.name].commit} | <code>{shown.replace('<', '&lt;')}</code> |")
    return "\n".join(text) + "\n"


def write(seed, count, drawn, rows, stages):
    """Rows of mutants of other seeds or earlier functions are kept: they cost time, and may be drawn again."""
    ROWS.write_text(rows_text(rows))
    TABLE.write_text(report_text(seed, count, drawn, rows, stages))
