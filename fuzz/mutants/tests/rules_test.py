"""What each rule makes of a line."""
import unittest

from mutation import rules


def mutants(text, rule=None):
    return {text[:site.begin] + site.text + text[site.end:] for site in rules.sites(text) if rule in (None, site.rule)}


class Rules(unittest.TestCase):
    def expect(self, rule, text, *expected):
        self.assertEqual(mutants(text, rule), set(expected), text)

    def test_comparisons(self):
        self.expect("comparison", "a < b;", "a <= b;")
        self.expect("comparison", "a == b || c >= d;", "a != b || c >= d;", "a == b || c > d;")
        self.expect("comparison", "template <class T> std::vector<int> f(std::array<T, 3> x);")
        self.expect("comparison", "x << y;")

    def test_signs(self):
        self.expect("sign", "a + b;", "a - b;")
        self.expect("sign", "a -= -b;", "a += -b;", "a -= b;")
        self.expect("sign", "return -x;", "return x;")
        self.expect("sign", "++i; x->y; a - 1;", "++i; x->y; a + 1;")

    def test_constants(self):
        self.expect("constant", "x = 0;", "x = 1;")
        self.expect("constant", "x = 1'024u;", "x = 1025u;", "x = 1023u;")
        self.expect("constant", "x * 0x1p-53;", "x * 0x1p-52;", "x * 0x1p-54;")
        self.expect("constant", "x * 4.25;", "x * 5.25;", "x * 3.25;")
        self.expect("constant", "x * 7.1f;", "x * 8.1f;", "x * 6.1f;")
        self.expect("constant", "x1 + y2_3;")

    def test_dropped_terms(self):
        self.expect("dropped term", "double f_bound(double a) { return 2 * (a + 1) + b; }",
                    "double f_bound(double a) { return 2 * (a) + b; }", "double f_bound(double a) { return 2 * (1) + b; }",
                    "double f_bound(double a) { return 2 * (a + 1); }", "double f_bound(double a) { return b; }")
        self.expect("dropped term", "void f() { x = a + b; y = c; }")
        self.expect("dropped term", "void f() { margin = a - b + c; }", "void f() { margin = a - b; }")

    def test_minima_logic_and_answers(self):
        self.expect("min and max", "std::min(a, b) + min_;", "std::max(a, b) + min_;")
        self.expect("logic", "if (a && b) return f(T&& x);", "if (a || b) return f(T&& x);")
        self.expect("returned truth", "return true;", "return false;")

    def test_guards(self):
        self.expect("guard", "if (f(a) == b) return;", "if (false) return;", "if (true) return;")
        self.expect("guard", "if (const auto x = f()) return;")
        self.expect("guard", "if constexpr (a) return;")

    def test_loops(self):
        self.expect("loop", "for (int i = 0; i < n; ++i) f(i);",
                    "for (int i = 1; i < n; ++i) f(i);", "for (int i = 0; i + 1 < n; ++i) f(i);")
        self.expect("loop", "for (const auto& x : y) f(x);")

    def test_comments_literals_directives_and_assertions_stay(self):
        self.assertEqual(mutants('// a < b\n#if A < 2\n#endif\nf("a < b");\nstatic_assert(a < 3);\nECODS_ASSERT(a < 3);\n'),
                         set())
