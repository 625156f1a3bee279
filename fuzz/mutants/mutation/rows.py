"""Rows: what a run found out about mutants. Each is saved as its mutant ends, so that a later run goes on from there."""
import json
import subprocess
import threading
from dataclasses import asdict, dataclass

from .lists import ROOT

UNKNOWN = "-"  # the commit and digest of a row from before rows had them


@dataclass(frozen=True)
class Row:
    name: str
    digest: str
    commit: str
    caught: str  # empty: nothing
    said: list   # by each campaign
    failed: list | None = None  # the names of all checks that fail, if all were asked


@dataclass(frozen=True)
class DrawnRow:
    """What became of a mutant that was drawn: its name changes with its function."""
    name: str
    commit: str
    outcome: str  # a stage, not compiled, or survived
    program: str  # that caught it


class RowFile:
    """One row a line; of two of a mutant the last counts. A line that a killed run left unfinished is dropped."""

    def __init__(self, path, kind=Row):
        self.path, self.kind, self.lock = path, kind, threading.Lock()

    def read(self):
        found = {}
        for line in self.path.read_text().splitlines() if self.path.exists() else []:
            try:
                row = self.kind(**json.loads(line))
            except (ValueError, TypeError):
                continue
            found[row.name] = row
        return found

    def add(self, row):
        with self.lock:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            old = self.path.read_bytes()[-1:] if self.path.exists() else b""
            with open(self.path, "a", encoding="utf-8") as file:
                file.write(("\n" if old not in (b"", b"\n") else "") + json.dumps(asdict(row)) + "\n")


def commit(root=ROOT):
    """The commit, with a plus sign if the sources differ from it; `unknown` without git."""
    def git(*args):
        return subprocess.run(["git", *args], check=True, text=True, stdout=subprocess.PIPE, cwd=root).stdout.strip()

    if not (root / ".git").exists():
        return "unknown"
    changed = git("status", "--porcelain", "--", "src", "include", "fuzz", "verify", ":!fuzz/campaign", ":!fuzz/mutants")
    return git("rev-parse", "--short=9", "HEAD") + ("+" if changed else "")
