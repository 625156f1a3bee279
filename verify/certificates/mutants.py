"""Mistakes made on purpose in the Python checker: each must be caught by the cases made by hand, false claims or tampering.

usage: mutants.py CHECKER [LIST]       CHECKER: the C++ one, which is right

A mutant of LIST is two lines, `- TEXT` as it stands in check.py, once at least, and `+ TEXT` in its place, after a line `# WHY`.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
SUITES = [
    ["checker/cases.py", None, "0"],
    ["false_claims.py", "--claims", "150", "--python", None],
    ["tamper.py", "--changes", "1500", "--sources", "60", "--python", None],
]


def read_list(path):
    why = old = ""
    for line in path.read_text().splitlines():
        kind, text = line[:2], line[2:]
        if kind == "# ":
            why = text
        elif kind == "- ":
            old = text
        elif kind == "+ ":
            yield why, old, text


def catcher(checker, mutant):
    """The first suite that fails for a mutant, or None."""
    for name, *arguments in SUITES:
        words = [str(mutant) if word is None else word for word in arguments]
        command = [sys.executable, HERE / name, *([] if name.startswith("checker/") else [checker]), *words]
        if subprocess.run(command, capture_output=True, timeout=900, check=False).returncode != 0:
            return name
    return None


def main():
    source = (HERE / "check.py").read_text()
    mutants = list(read_list(Path(sys.argv[2]) if len(sys.argv) > 2 else HERE / "mutants_python.txt"))
    survivors = 0
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "reading.py").write_text((HERE / "reading.py").read_text())
        mutant = Path(folder) / "check.py"
        for why, old, new in mutants:
            if old not in source:
                sys.exit(f"not in check.py: {old}")
            mutant.write_text(source.replace(old, new, 1))
            mutant.chmod(0o755)
            name = catcher(sys.argv[1], mutant)
            survivors += name is None
            print(f"{name or 'NOT CAUGHT':18} {why}", flush=True)
    print(f"{len(mutants)} mutants: {survivors} not caught")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
