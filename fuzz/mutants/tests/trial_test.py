"""Mutants of a small project, compiled, linked and run."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest
from unittest import mock

from mutation import build, checks, draw, trial
from mutation.lists import Broken, Check, MutantList

CMAKE = """cmake_minimum_required(VERSION 3.20)
project(small CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(ECODS_UNITY OFF CACHE BOOL "")
set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON CACHE BOOL "")
add_library(part STATIC src/sum.cpp src/half.cpp)
target_include_directories(part PUBLIC src)
add_executable(sum_tests verify/sum_tests.cpp)
add_executable(half_tests verify/half_tests.cpp)
target_link_libraries(sum_tests PRIVATE part)
target_link_libraries(half_tests PRIVATE part)
"""
FILES = {
    "CMakeLists.txt": CMAKE,
    "src/step.hpp": "#pragma once\nconstexpr int step = 1;\nstatic_assert(step > 0);\n",
    "src/sum.cpp": '#include "step.hpp"\nint sum(int a, int b) {\n    while (a < 0) ++a;\n    return a + b * step;\n}\n',
    "src/half.cpp": '#include "step.hpp"\nint half(int a) { return a / (step + 1); }\n',
    "verify/sum_tests.cpp": "int sum(int, int);\n"
                            "int main(int n, char**) { return n == 1 && sum(1, 2) == 3 && sum(-1, 0) == 0 ? 0 : 1; }\n",
    "verify/half_tests.cpp": "int half(int);\nint main() { return half(5) == 2 ? 0 : 1; }\n",
    "some.list": """check src/: sums = sum_tests
check halves = half_tests

minus src/sum.cpp
  a difference
- a + b
+ a - b

hangs src/sum.cpp
  counts down
- ++a
+ --a, a |= -2

unseen src/sum.cpp
  more than is asked
- a < 0
+ a < 1 - 1

two src/step.hpp
  a step is 2
- step = 1
+ step = 2

three_halves src/half.cpp
  a half is less
- step + 1
+ step + 2

none src/step.hpp
  there is no step
- step = 1
+ step = 0

nonsense src/sum.cpp
  no program
- a + b
+ a +
""",
}


@unittest.skipUnless(shutil.which("cmake") and shutil.which("ninja"), "needs CMake and Ninja")
class Trial(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name).resolve()
        for name, text in FILES.items():
            (cls.root / name).parent.mkdir(exist_ok=True)
            (cls.root / name).write_text(text)
        subprocess.run(["cmake", "-G", "Ninja", "-S", cls.root, "-B", cls.root / "build"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.list = MutantList(cls.root / "some.list")
        cls.build = build.Build(build.prepare(cls.root / "build"), cls.list.programs(), jobs=2, root=cls.root)
        cls.addClassCleanup(cls.build.compilers.shutdown)
        for check in cls.list.checks:
            cls.build.check_without_mutant(check)

    def row(self, name, asks_all=False):
        mutant = next(m for m in self.list.mutants if m.name == name)
        with mock.patch.object(checks, "SECONDS_MORE", 2):
            return trial.try_mutant(self.build, self.list, mutant, self.root / "build/mutants/work", "abc", asks_all)

    def test_the_first_check_that_fails_has_caught_it(self):
        row = self.row("minus")
        self.assertEqual((row.caught, row.failed, row.commit), ("sums (crash)", None, "abc"))
        self.assertEqual(self.row("three_halves").caught, "halves (crash)")

    def test_a_header_changes_all_that_read_it(self):
        self.assertEqual(self.row("two", asks_all=True).failed, ["src/: sums", "halves"])
        self.assertEqual(self.row("minus", asks_all=True).failed, ["src/: sums"])

    def test_hangs_and_failed_assertions_are_catches(self):
        self.assertEqual(self.row("hangs").caught, "sums (hang)")
        self.assertEqual(self.row("none").caught, trial.COMPILER)

    def test_survivors_survive(self):
        self.assertEqual(self.row("unseen", asks_all=True).failed, [])
        self.assertEqual(self.row("unseen").caught, "")

    def test_nonsense_is_no_mutant(self):
        with self.assertRaisesRegex(Broken, "nonsense does not compile"):
            self.row("nonsense")

    def test_only_objects_of_the_program_are_compiled(self):
        planting = build.Planting(self.build, self.root / "build/mutants/work", "src/step.hpp", FILES["src/step.hpp"])
        planting.program("half_tests")
        self.assertEqual([pathlib.Path(o).name for o in planting.again], ["half.cpp.o"])

    def test_a_check_that_fails_without_a_mutant_is_refused(self):
        with self.assertRaisesRegex(Broken, "without any mutant, wrong"):
            self.build.check_without_mutant(Check("wrong = sum_tests argument"))

    def test_what_became_of_drawn_mutants(self):
        outcomes = {}
        with mock.patch.object(checks, "SECONDS_MORE", 2):
            for mutant in draw.mutants_of("src/half.cpp", self.root) + draw.mutants_of("src/step.hpp", self.root):
                row = trial.try_drawn(self.build, mutant, self.list.checks, self.root / "build/mutants/work", "abc")
                outcomes[mutant.shown(self.root)] = (row.outcome, row.program)
        self.assertEqual(outcomes, {"int half(int a) { return a / (step [+ -> -] 1); }": ("halves", "half_tests"),
                                    "int half(int a) { return a / (step + [1 -> 0]); }": ("halves", "half_tests"),
                                    "int half(int a) { return a / (step + [1 -> 2]); }": ("halves", "half_tests"),
                                    "constexpr int step = [1 -> 0];": ("not compiled", ""),
                                    "constexpr int step = [1 -> 2];": ("sums", "sum_tests")})

    def test_a_folder_that_is_not_configured_like_the_preset_is_refused(self):
        with self.assertRaisesRegex(Broken, "is not configured"):
            build.prepare(self.root / "verify")
