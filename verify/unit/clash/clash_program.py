"""Runs ecods_clash for the readers of what it writes."""

import subprocess
import sys


def run(*arguments):
    """What the program prints. Ends the test as skipped where the program was built without what it is asked for."""
    done = subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if b"was built without" in done.stderr:
        print(done.stderr.decode())
        sys.exit(77)
    assert done.returncode == 0, (arguments, done.stderr.decode())
    return done.stdout
