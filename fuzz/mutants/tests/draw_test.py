"""Which mutants are drawn."""
import pathlib
import tempfile
import unittest

from mutation import draw

A = "bool a(int x) { return x < 1 && x > 2; }\n"
B = "bool b(int x) {\n    if (x == 3) return true;\n    return x != 4;\n}\n"


class Draw(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("src/one/a.cpp", A + B)
        self.write("src/two/b.cpp", B * 9)
        self.write("src/python/c.cpp", A)

    def write(self, file, text):
        path = self.root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def test_a_seed_draws_the_same_and_another_does_not(self):
        first = draw.draw(1, 20, self.root)
        self.assertEqual(first, draw.draw(1, 20, self.root))
        self.assertNotEqual({m.name for m in first}, {m.name for m in draw.draw(2, 20, self.root)})

    def test_names_are_of_one_mutant_each(self):
        mutants = draw.mutants_of("src/two/b.cpp", self.root)  # nine times the same function
        self.assertEqual(len({m.name for m in mutants}), len(mutants))

    def test_folders_have_their_share(self):
        self.assertEqual(draw.shares({"a": 30, "b": 10, "c": 10}, 6), {"a": 4, "b": 1, "c": 1})
        rooms = [m.room() for m in draw.draw(1, 20, self.root)]
        self.assertEqual({room: rooms.count(room) for room in set(rooms)}, {"src/one": 2, "src/two": 18})

    def test_a_change_renames_the_mutants_of_its_function_alone(self):
        before = {m.name for m in draw.mutants_of("src/one/a.cpp", self.root)}
        self.write("src/one/a.cpp", "// A comment.\n" + A + B.replace("4", "5"))
        after = draw.mutants_of("src/one/a.cpp", self.root)
        of_a = {m.name for m in after if m.line == 2}
        self.assertLessEqual(of_a, before)
        self.assertFalse(before & ({m.name for m in after} - of_a))

    def test_a_mutant_changes_its_place_alone(self):
        mutant = next(m for m in draw.mutants_of("src/one/a.cpp", self.root) if m.rule == "logic")
        self.assertEqual(mutant.apply(self.root), (A + B).replace("&&", "||"))
        self.assertEqual(mutant.shown(self.root), "bool a(int x) { return x < 1 [&& -> ||] x > 2; }")


class Sources(unittest.TestCase):
    """The sources of the project."""

    def test_two_thousand_are_drawn_from_all_folders_and_have_checks(self):
        drawn, checks = draw.draw(1, 2000), draw.read_checks()
        self.assertEqual(len({m.name for m in drawn}), 2000)
        self.assertEqual({m.room() for m in drawn}, set(draw.rooms_of()[0]))
        for mutant in drawn:
            self.assertIn("unit tests", [check.name for check in draw.checks_of(mutant, checks)], mutant.file)
        folders = [check.folder for check in checks]
        self.assertEqual([f for f in folders if not (draw.ROOT / f).is_dir()], [])
