"""The program of src/python/README.md prints what stands below it."""
import contextlib
import io
import os
import pathlib
import re

import ecods


def test_the_program_prints_what_the_readme_says():
    text = (pathlib.Path(os.environ["ECODS_SOURCE_DIR"]) / "src/python/README.md").read_text()
    program, output = re.search(r"```python\n(.*?)```.*?```\n(.*?)```", text, re.S).groups()
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(program, "README.md", "exec"), {})
    assert out.getvalue() == output


def test_the_version_is_that_of_the_library():
    text = (pathlib.Path(os.environ["ECODS_SOURCE_DIR"]) / "include/ecods/export.hpp").read_text()
    assert ecods.__version__ == ".".join(re.findall(r"#define ECODS_VERSION_\w+ (\d+)", text))
