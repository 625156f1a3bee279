"""A check of a mutant: a program that runs with limits of time and memory."""
import json
import os
import re
import signal
import subprocess
import time

# A mutant may take five times as long as the sources did, and half a minute more: after that it hangs, which is a catch.
SLOWER_MAX, SECONDS_MORE = 5, 30
SECONDS_MAX = 300  # of the sources as they are
KIBIBYTES_MAX = 8 << 20  # of addresses: a mutant that allocates for ever must not take the machine's memory


class Outcome:
    def __init__(self, passed, out, errors, seconds):
        self.passed, self.out, self.errors, self.seconds = passed, out, errors, seconds


def run(program, args, folder, seconds_max=SECONDS_MAX):
    """Files that it leaves go to the folder. Children that it leaves are ended with it."""
    begin = time.monotonic()
    limited = ["sh", "-c", f'ulimit -v {KIBIBYTES_MAX}; exec "$@"', "sh", program, *args]
    with subprocess.Popen(limited, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          errors="replace", start_new_session=True) as process:
        try:
            out, errors = process.communicate(timeout=seconds_max)
            passed = process.returncode == 0
        except subprocess.TimeoutExpired:
            passed, out, errors = False, "", "it hung"
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
    return Outcome(passed, out, errors, time.monotonic() - begin)


def failed_test(outcome):
    """The test that failed, as the report names it after the check."""
    output = outcome.out + outcome.errors
    found = re.search(r"\[  FAILED  \] (\S+)", output)
    if found:
        return f" ({found[1].rstrip(',')})"
    if outcome.errors == "it hung":
        return " (hang)"
    return "" if "mismatch" in output else " (crash)"


def seen_by(outcome):
    """How far a campaign came before it saw the mutant: pairs of triangles, or frames; and by which check."""
    try:
        report = json.loads(outcome.out)
        failure = report["failures"][0]
    except (ValueError, LookupError):
        return "crash or hang"
    where = re.search(r"\((.*?)\)", failure["where"]) if failure["profile"] in ("pairs", "distances") else None
    amount = report.get("frames") or report.get("triangle pairs") or "the first run"
    return f"{amount} ({where[1] if where else failure['check']})"
