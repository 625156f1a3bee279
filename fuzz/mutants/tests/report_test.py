"""The report: rows that are stale, missing or of survivors, and the list of pending mutants, which only shrinks."""
import pathlib
import re
import tempfile
import unittest
from dataclasses import replace

from mutation import report
from mutation.lists import Broken, MutantList
from mutation.rows import Row, RowFile

SOURCE = "int f(int x) {\n    return x + 1;\n}\n\nint g(int x) {\n    return x || 2;\n}\n"
LIST = """# A list.

check unit tests = f_tests
check src/: other tests = g_tests
campaign campaign = fuzz --runs 1

plus_is_minus src/f.cpp
  the sum is a difference
- x + 1
+ x - 1

or_is_and src/f.cpp
  a || is an &&
- x || 2
+ x && 2

harmless src/f.cpp
  the type is another
- int f
+ long f
= an int is as good | or better
"""


class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "src").mkdir()
        self.source(SOURCE)
        (self.root / "some.list").write_text(LIST)
        self.lists = [MutantList(self.root / "some.list")]
        self.mutants = {m.name: m for m in self.lists[0].mutants}
        self.rows = {name: Row(name, m.digest(self.root), "abc123", "unit tests (A.B)", ["no"])
                     for name, m in self.mutants.items()}
        self.rows["harmless"] = replace(self.rows["harmless"], caught="")

    def source(self, text):
        (self.root / "src/f.cpp").write_text(text)

    def wrong(self, *pending, limit=0):
        text = report.report_text(self.lists, self.rows, self.root)
        pending = report.pending_text(limit, {name: "why" for name in pending})
        return list(report.wrong_things(self.lists, text, pending, self.root))

    def test_current_rows_are_right(self):
        self.assertEqual(self.wrong(), [])

    def test_rows_come_back_as_they_were_written(self):
        self.rows["or_is_and"] = replace(self.rows["or_is_and"], failed=["unit tests", "src/: other tests"])
        self.rows["plus_is_minus"] = replace(self.rows["plus_is_minus"], failed=[], caught="")
        self.assertEqual(report.read_rows(report.report_text(self.lists, self.rows, self.root)), self.rows)

    def test_a_mutant_without_a_row_fails(self):
        del self.rows["or_is_and"]
        self.assertEqual(self.wrong(), ["or_is_and: no row"])
        self.assertEqual(self.wrong("or_is_and", limit=1), [])

    def test_a_stale_row_fails(self):
        self.source(SOURCE.replace("return x + 1", "x = x; return x + 1"))
        self.assertEqual(self.wrong(), ["plus_is_minus: changed since abc123", "harmless: changed since abc123"])
        self.assertEqual(self.wrong("plus_is_minus", "harmless", limit=2), [])

    def test_a_changed_mutant_fails(self):
        self.mutants["or_is_and"].replace = "x & 2"
        self.assertEqual(self.wrong(), ["or_is_and: changed since abc123"])

    def test_comments_formatting_and_other_functions_leave_rows_current(self):
        self.source("// New.\nint h() { return 3; }\n" + SOURCE.replace("    return x + 1", "    // Adds.\n  return x + 1"))
        self.assertEqual(self.wrong(), [])

    def test_rows_without_a_commit_are_not_current(self):
        self.rows["or_is_and"] = replace(self.rows["or_is_and"], digest="-", commit="-")
        self.assertEqual(self.wrong(), ["or_is_and: row without a commit"])

    def test_a_survivor_fails_unless_it_is_excused(self):
        self.rows["or_is_and"] = replace(self.rows["or_is_and"], caught="")
        self.assertEqual(self.wrong(), ["or_is_and: survived"])

    def test_the_check_that_caught_it_must_exist(self):
        self.rows["or_is_and"] = replace(self.rows["or_is_and"], caught="gone tests (A.B)")
        self.assertEqual(self.wrong(), ["or_is_and: caught by a check that is gone"])

    def test_the_list_of_pending_mutants_only_shrinks(self):
        self.assertEqual(self.wrong("or_is_and", limit=1), ["or_is_and: in PENDING.txt, but its row is current"])
        self.assertEqual(self.wrong("no_mutant", limit=1), ["no_mutant: in PENDING.txt, but no mutant of a list"])
        del self.rows["or_is_and"]
        self.assertEqual(self.wrong("or_is_and", limit=0), ["PENDING.txt: 1 mutants are pending, at most 0 may be"])

    def test_a_row_of_no_mutant_fails(self):
        text = report.report_text(self.lists, self.rows, self.root).replace("| or_is_and |", "| or_is_gone |")
        self.assertEqual(list(report.wrong_things(self.lists, text, report.pending_text(0, {}), self.root)),
                         ["or_is_and: no row", "or_is_gone: has a row, but is no mutant of a list"])

    def test_writing_lowers_the_limit_and_never_raises_it(self):
        files = self.root / "REPORT.md", self.root / "PENDING.txt"
        for known, limit, pending in ((2, 1, 1), (3, 0, 0), (1, 0, 2)):
            report.write(self.lists, dict(list(self.rows.items())[:known]), *files, self.root)
            found = report.read_pending(files[1].read_text())
            self.assertEqual((found[0], len(found[1])), (limit, pending))
            self.assertIn(f"{known} of 3 mutants\nhave a row", files[0].read_text())
        self.assertIn("at most 0 may be", "".join(report.wrong_things(self.lists, *(f.read_text() for f in files), self.root)))

    def test_joined_rows_are_the_current_ones(self):
        stale = {name: replace(row, digest="0", commit="old") for name, row in self.rows.items()}
        asked_all = {"or_is_and": replace(self.rows["or_is_and"], failed=["unit tests"])}
        for sources in ((stale, self.rows, asked_all), (asked_all, self.rows, stale)):
            joined = report.join(self.lists, *sources, root=self.root)
            self.assertEqual(joined, self.rows | asked_all)

    def test_a_mutant_that_does_not_apply_is_named(self):
        self.source("int f() { return 0; }\n")
        with self.assertRaisesRegex(Broken, "plus_is_minus: found 0 times in src/f.cpp"):
            self.wrong()

    def test_lists_of_nonsense_are_refused(self):
        path = self.root / "other.list"
        for text, said in ((LIST.replace("campaign campaign", "champagne campaign"), "no directive"),
                           (LIST.replace("- x + 1\n", ""), "no text to find"),
                           (LIST.replace("src/: other tests", "unit tests"), "two checks")):
            path.write_text(text)
            with self.assertRaisesRegex(Broken, re.escape(said)):
                MutantList(path)


class Rows(unittest.TestCase):
    def test_rows_are_saved_one_by_one_and_half_a_row_is_dropped(self):
        with tempfile.TemporaryDirectory() as folder:
            file = RowFile(pathlib.Path(folder) / "new/rows.jsonl")
            self.assertEqual(file.read(), {})
            rows = [Row("a", "1", "c", "", []), Row("b", "2", "c", "x", ["no"], ["x"]), Row("a", "3", "d", "y", [])]
            file.add(rows[0])
            file.path.write_text(file.path.read_text() + '{"name": "z", "dig')  # the run was killed here
            file.add(rows[1])
            file.add(rows[2])
            self.assertEqual(file.read(), {"a": rows[2], "b": rows[1]})
