"""C++ text: what a digest sees of it."""
import unittest

from mutation import code
from mutation.lists import ROOT

FILE = """// A file.
#include <vector>

namespace a {

constexpr double limit = 0x1p-52;  // of one operation

class Box : public Base<int> {
public:
    Box() : low_{1}, high_{2} { check(); }
    int low() const { return low_; }

private:
    int low_ = 0, high_ = 1;
};

template <class T>
int larger(T x) {
    const auto by = [](int y) { return y + 1; };
    return by(x);  // { is no brace
}

const char* text() { return "}{ // no comment"; }

enum class Kind { first, second };

}  // namespace a
"""


class Code(unittest.TestCase):
    def around(self, what, text=FILE):
        begin = text.index(what)
        return " ".join(code.text_around(text, begin, begin + len(what)).split())

    def test_text_around_is_the_function_alone(self):
        self.assertTrue(self.around("y + 1").startswith("template <class T> int larger(T x) {"))
        self.assertTrue(self.around("y + 1").endswith("return by(x); }"))
        self.assertEqual(self.around("return low_"), "int low() const { return low_; }")
        self.assertTrue(self.around("check").endswith("Box() : low_{1}, high_{2} { check(); }"))
        self.assertEqual(self.around("no comment"), 'const char* text() { return "}{ // no comment"; }')

    def test_text_around_is_the_declaration_outside_functions(self):
        self.assertEqual(self.around("-52"), "constexpr double limit = 0x1p-52;")
        self.assertTrue(self.around("high_ = 1").endswith("int low_ = 0, high_ = 1;"))
        self.assertEqual(self.around("second"), "enum class Kind { first, second };")
        self.assertEqual(self.around("<vector"), "#include <vector>")

    def test_text_around_more_than_one_function_is_all_of_them(self):
        self.assertEqual(self.around("check(); }\n    int low() const"),
                         "public: Box() : low_{1}, high_{2} { check(); } int low() const { return low_; }")

    def test_text_around_is_lines_where_braces_do_not_match(self):
        lines = [f"int x{i};" for i in range(100)]
        text = "\n".join([*lines, "#if A", "void f() {", "#else", "void f(int x) {", "#endif", "}"])
        self.assertIsNone(code.units(text))
        self.assertEqual(self.around("x50", text), " ".join(lines[30:71]))

    def test_no_comment_or_formatting_changes_a_digest(self):
        self.assertEqual(code.digest("int f() { return a+b; }"),
                         code.digest("int f()\n{\n  // sum\n  return a + b; /* of two */\n}"))
        self.assertNotEqual(code.digest("return a + b;"), code.digest("return a - b;"))
        self.assertNotEqual(code.digest('"a // b"'), code.digest('"a // c"'))
        self.assertNotEqual(code.digest("a", "b c"), code.digest("a b", "c"))

    def test_digits_may_be_separated(self):
        self.assertEqual(code.structure("x = 1'000; // y"), "x = 1'000;     ")

    def test_braces_of_all_sources_match(self):
        files = [path for top in ("include", "src", "verify", "fuzz", "bench") for path in (ROOT / top).rglob("*.[ch]pp")]
        self.assertGreater(len(files), 500)
        self.assertEqual([path for path in files if code.units(path.read_text()) is None], [])
