"""Reads the page of ecods_clash back, and uses it in headless Chromium.

usage: read_page.py ECODS_CLASH ECODS_CLASH_BUILDING

Exit status 77 if there is no Chromium, when the page was only parsed, or no libpng in the program.
"""

import base64
import html.parser
import json
import os
import re
import shutil
import sys
import tempfile

from clash_program import run
from png import read_png

KINDS = ["equal", "inside", "overlapping", "crossing", "touching", "clearance"]
OPTIONS = ["--touching", "--clearance", "0.01", "--lines", "30"]

# Uses the page as a person does, and leaves what it saw as text.
PROBE = """
<script>
const seen = {};
const rows = () => byId("list").childElementCount;
const type = (text) => { byId("search").value = text; byId("search").dispatchEvent(new Event("input")); };
const order = (name) => { byId("order").value = name; byId("order").dispatchEvent(new Event("change")); };
const numbers = () => [...byId("list").children].map((row) => Number(row.id.slice(1)));
seen.width = [document.documentElement.scrollWidth, window.innerWidth];
seen.rows = rows();
seen.pictures = document.querySelectorAll("#list img").length;
seen.notSolid = byId("not-solid").querySelectorAll("tbody tr").length;
type("chair SLAB"); seen.found = numbers(); type("");
for (const name of ["a", "b", "depth", "distance", "size"]) { order(name); seen[name] = numbers(); }
order("kind");
const chip = document.querySelector("#kinds button");
chip.click(); seen.withoutFirst = byId("shown").textContent; chip.click(); seen.withAll = byId("shown").textContent;
const picture = document.querySelector("#list .picture");
if (picture !== null) {
  picture.click(); seen.isOpen = byId("viewer").open; byId("after").click();
  seen.caption = byId("caption").textContent; byId("close").click(); seen.isClosed = !byId("viewer").open;
}
for (const list of document.querySelectorAll("#list details")) list.open = true;
window.dispatchEvent(new Event("beforeprint")); seen.printed = rows();
setTimeout(() => {
  seen.items = document.querySelectorAll("#list details li").length;
  window.parent.postMessage(JSON.stringify(seen), "*");
}, 300);
</script>
"""

# A frame, which may be narrower than Chromium's least window, and what the page in it saw.
FRAME = """<!DOCTYPE html><meta charset="utf-8"><body style="margin: 0">
<script>
window.addEventListener("message", (event) => {
  const text = document.createElement("pre");
  text.id = "seen";
  text.append(event.data);
  document.body.append(text);
});
</script>
<iframe style="width: %dpx; height: 900px; border: 0" src="%s"></iframe>
"""


class Page(html.parser.HTMLParser):
    """The page's scripts by id, and all that it refers to."""

    def __init__(self, text):
        super().__init__()
        self.scripts, self.references, self.inside = {}, [], None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.references += [attributes[name] for name in ("src", "href") if name in attributes]
        self.inside = attributes.get("id", "script") if tag == "script" else None
        if tag == "script":
            self.scripts[self.inside] = ""

    def handle_data(self, data):
        if self.inside is not None:
            self.scripts[self.inside] += data

    def handle_endtag(self, tag):
        self.inside = None


def flat(lists):
    return [number for each in lists for number in each]


def check_data(page, report, picture_count):
    assert all(each.startswith(("data:", "#")) for each in page.references), page.references
    data = json.loads(page.scripts["data"])
    assert data["counts"] == [report["counts"][kind] for kind in KINDS]
    assert [part[0] for part in data["parts"]] == [part["name"] for part in report["parts"]]
    assert [part[4] for part in data["parts"]] == [part.get("not_solid_because", "") for part in report["parts"]]
    assert len(data["clashes"]) == len(report["clashes"])
    for row, clash in zip(data["clashes"], report["clashes"]):
        kind, relation, a, b, distance, depth, box, points, line_count, lines = row
        assert (KINDS[kind], relation, distance) == (clash["kind"], clash["relation"], clash["distance"])
        assert (data["parts"][a][0], data["parts"][b][0]) == (clash["a"], clash["b"])
        assert depth == (clash["depth"] and [clash["depth"]["lower"], clash["depth"]["upper"]])
        assert box == flat(clash["box"]) and points == flat(clash["points"]) and line_count == clash["line_count"]
        assert lines == flat(flat(line for line in clash["lines"][:24]))
    pictures = [name for name in page.scripts if re.fullmatch(r"p\d+", name)]
    assert pictures == ["p%d" % i for i in range(picture_count)]
    if pictures:
        assert read_png(base64.b64decode(page.scripts[pictures[-1]], validate=True))[:2] == tuple(data["size"])
    return data


def chromium(*arguments):
    program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if program is None:
        print("no Chromium is installed: the page was parsed, and not used")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as profile:
        return run(program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                   "--hide-scrollbars", "--virtual-time-budget=5000", "--user-data-dir=" + profile, *arguments)


def probe(path, width):
    with open(path, encoding="utf-8") as file:
        text = file.read().replace("</body>", PROBE + "</body>")
    with open(path + ".probe.html", "w", encoding="utf-8") as file:
        file.write(text)
    with open(path + ".frame.html", "w", encoding="utf-8") as file:
        file.write(FRAME % (width, os.path.basename(path) + ".probe.html"))
    dom = chromium("--window-size=1400,1000", "--dump-dom", "file://" + path + ".frame.html").decode()
    found = re.search(r'<pre id="seen">(.*?)</pre>', dom, re.DOTALL)
    assert found, "the page's script did not come to its end"
    return json.loads(html.unescape(found.group(1)))


def check_use(path, clashes, picture_count, width):
    seen = probe(path, width)
    everything = list(range(len(clashes)))
    assert seen["width"][0] <= seen["width"][1] <= width, seen["width"]
    assert seen["rows"] == min(40, len(clashes)) and seen["pictures"] == min(40, picture_count)
    wanted = [i for i in everything if all(word in clashes[i]["a"] + "\n" + clashes[i]["b"] for word in ("chair", "slab"))]
    assert seen["found"] == wanted and wanted
    assert seen["a"] == sorted(everything, key=lambda i: (clashes[i]["a"], clashes[i]["b"]))
    assert seen["b"] == sorted(everything, key=lambda i: (clashes[i]["b"], clashes[i]["a"]))
    deep = lambda i: -clashes[i]["depth"]["lower"] if clashes[i]["depth"] else 1
    assert seen["depth"] == sorted(everything, key=deep)
    assert seen["distance"] == sorted(everything, key=lambda i: clashes[i]["distance"] or 0)
    first = sum(clash["kind"] == clashes[0]["kind"] for clash in clashes)
    assert seen["withoutFirst"] == "%d of %d clashes" % (len(clashes) - first, len(clashes)), seen["withoutFirst"]
    assert seen["withAll"] == "%d clashes" % len(clashes)
    assert seen["isOpen"] and seen["isClosed"] and seen["caption"].startswith("#2 "), seen["caption"]
    assert seen["printed"] == len(clashes) and seen["items"] > 0 and seen["notSolid"] == 4


def check_many(path, data):
    """20,000 clashes: rows are made as they are wanted, and at most 1,000 are printed."""
    data["clashes"] = [data["clashes"][i % len(data["clashes"])] for i in range(20000)]
    with open(path, encoding="utf-8") as file:
        text = file.read()
    begin = text.index('id="data">') + len('id="data">')
    text = text[:begin] + json.dumps(data).replace("<", "\\u003c") + text[text.index("</script>", begin):]
    with open(path + ".many.html", "w", encoding="utf-8") as file:
        file.write(text)
    seen = probe(path + ".many.html", 1280)
    assert seen["rows"] == 40 and seen["withAll"] == "20,000 clashes" and seen["printed"] == 1000, seen["printed"]


def check_looks(path, folder):
    picture = os.path.join(folder, "page.png")
    brightness = {}
    for scheme, number in (("dark", 0), ("light", 1)):
        chromium("--window-size=1280,400", "--blink-settings=preferredColorScheme=%d" % number,
                 "--screenshot=" + picture, "file://" + path)
        with open(picture, "rb") as file:
            brightness[scheme] = sum(read_png(file.read())[2][3][3])
    assert brightness["dark"] < 200 < 600 < brightness["light"], brightness
    printed = os.path.join(folder, "page.pdf")
    chromium("--no-pdf-header-footer", "--print-to-pdf=" + printed, "file://" + path)
    if shutil.which("pdftotext") is None:
        print("pdftotext is not installed: what is printed was not read")
        return
    text = run("pdftotext", printed, "-").decode()
    return [int(number) for number in re.findall(r"#(\d+)\b", text)]


def main():
    program, building = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        source, path, text = (os.path.join(folder, name) for name in ("a.obj", "page.html", "report.json"))
        with open(source, "wb") as file:
            file.write(run(building, "1", "1", "1"))
        run(program, source, "--quiet", "--pictures", "9", "--html", path, "--json", text, *OPTIONS)
        with open(path, encoding="utf-8") as file, open(text, encoding="utf-8") as json_file:
            bytes_of_page, report = file.read(), json.load(json_file)
        data = check_data(Page(bytes_of_page), report, 9)
        again = run(program, source, "--jobs", "1", "--quiet", "--pictures", "9", "--html", "-", *OPTIONS)
        assert again.decode() == bytes_of_page, "the same input gives another page"
        check_use(path, report["clashes"], 9, 1280)
        check_use(path, report["clashes"], 9, 420)
        numbers = check_looks(path, folder)
        assert numbers is None or numbers == list(range(1, len(report["clashes"]) + 1)), numbers
        check_many(path, data)

        names = "<script>alert(1)</script>", "</script><!-- &amp;", "\u2028 \U0001f600 'x' \"y\""
        with open(source, "w", encoding="utf-8", newline="\n") as file:
            for i, name in enumerate(names):
                file.write("o %s\nv %d 0 0\nv 9 %d 0\nv 0 9 0\nv 0 0 9\nf -1 -2 -3\nf -1 -2 -4\nf -1 -3 -4\nf -2 -3 -4\n"
                           % (name, i, i))
        run(program, source, "--quiet", "--html", path, "--json", text)
        with open(path, encoding="utf-8") as file, open(text, encoding="utf-8") as json_file:
            data = check_data(Page(file.read()), json.load(json_file), 0)
        assert sorted(part[0] for part in data["parts"]) == sorted(names), data["parts"]
    print("%d clashes: the page says what the JSON says, and can be used" % len(report["clashes"]))


if __name__ == "__main__":
    main()
