#!/usr/bin/env python3
"""What Doxygen sees of a file. usage: filter.py FILE

Of a header: each plain comment as one that Doxygen reads, the first as the file's, one behind code as that of what is
before it, and `// ---- TITLE` as the title of a group. Of a guide: links to files that have no page or within the page, and pictures, as their words.
"""
import os
import re
import sys

PAGES = os.environ.get("ECODS_PAGES", "").split()


def escaped(text):
    """Markdown of a comment: what Doxygen would take for commands or tags is escaped, but in code."""
    if text.startswith("    ") or text.startswith("     "):
        return text
    return re.sub(r"([\\@<>#])", r"\\\1", text)


def header(lines):
    is_first = True
    out = []
    group_is_open = False
    for number, line in enumerate(lines):
        match = re.match(r"^(\s*)//(?: (.*)|)$", line)
        if match:
            indent, text = match.group(1), match.group(2) or ""
            if text.startswith("clang-format"):
                out.append(line)
            elif text.startswith("---- "):
                close = indent + "///@}\n" if group_is_open else ""
                out.append(f"{close}{indent}/// @name {escaped(text[5:])}")
                group_is_open = True
                out.append(indent + "///@{")
            elif is_first:
                out.append(f"{indent}/// @file\n{indent}/// {escaped(text)}")
            else:
                out.append(f"{indent}/// {escaped(text)}")
            is_first = False
            continue
        if group_is_open and re.match(r"^  (private|protected):|^};", line):
            out.append("///@}")
            group_is_open = False
        match = re.match(r"^(.*\S.*?)\s+// (.*)$", line)
        if match and not line.lstrip().startswith("#") and not line.startswith("}"):
            line = f"{match.group(1)}  ///< {escaped(match.group(2))}"
        out.append(line)
    return out


def page(text, file):
    def link(match):
        bang, words, target = match.groups()
        if target.startswith("http"):
            return match.group(0)
        path = os.path.normpath(os.path.join(os.path.dirname(file), target.split("#")[0]))
        if path in PAGES and not bang and not target.startswith("#"):
            return f"[{words}]({path})"
        return words
    # A title of its own for each page: all of them are README.md, and one is the first page.
    name = "mainpage" if file == "README.md" else re.sub(r"\W", "_", file)
    text = re.sub(r"\A# (.*)", rf"# \1 {{#{name}}}", text)
    return re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)", link, text)


def main():
    file = os.path.relpath(sys.argv[1])
    with open(file, encoding="utf-8") as source:
        text = source.read()
    if file.endswith(".hpp"):
        print("\n".join(header(text.split("\n"))))
    else:
        print(page(text, file))


main()
