"""The programs of src/python/README.md print what stands below them."""
import contextlib
import io
import os
import pathlib
import re

import pytest

import ecods


@pytest.mark.parametrize("i", range(2))
def test_the_programs_print_what_the_readme_says(i):
    text = (pathlib.Path(os.environ["ECODS_SOURCE_DIR"]) / "src/python/README.md").read_text()
    programs = re.findall(r"```python\n(.*?)```.*?```\n(.*?)```", text, re.S)
    assert len(programs) == 2
    program, output = programs[i]
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(program, "README.md", "exec"), {})
    assert out.getvalue() == output


def test_the_version_is_that_of_the_library():
    text = (pathlib.Path(os.environ["ECODS_SOURCE_DIR"]) / "include/ecods/export.hpp").read_text()
    assert ecods.__version__ == ".".join(re.findall(r"#define ECODS_VERSION_\w+ (\d+)", text))
