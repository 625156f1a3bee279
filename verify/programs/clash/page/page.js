"use strict";
// The page's data are lists by position, as write_html.cpp writes them; rows are made when they come into sight.
const data = JSON.parse(document.getElementById("data").textContent);
const kinds = ["equal", "inside", "overlapping", "crossing", "touching", "clearance"];
const about = {
  equal: "the same solid twice (of surfaces: the same triangles)",
  inside: "one part lies wholly within the other",
  overlapping: "both solids have inner points in common",
  crossing: "a surface that bounds no solid goes through the other part",
  touching: "the parts touch and do not enter each other",
  clearance: "closer than the clearance",
};
const rowsAtOnce = 40;
const rowsInPrint = 1000;

const clashes = data.clashes.map((row, index) => {
  const [kind, relation, a, b, distance, depth, box, points, lineCount, lines] = row;
  const names = [data.parts[a][0], data.parts[b][0]];
  const size = Math.hypot(box[3] - box[0], box[4] - box[1], box[5] - box[2]);
  const text = [...names, data.parts[a][1], data.parts[b][1], kinds[kind], relation].join("\n").toLowerCase();
  return { index, kind: kinds[kind], relation, a, b, names, distance, depth, box, points, lineCount, lines, size, text };
});

// The list as the controls want it.
const orders = {
  kind: (x, y) => x.index - y.index,
  a: (x, y) => compareText(x.names[0], y.names[0]) || compareText(x.names[1], y.names[1]) || x.index - y.index,
  b: (x, y) => compareText(x.names[1], y.names[1]) || compareText(x.names[0], y.names[0]) || x.index - y.index,
  depth: (x, y) => depthKey(y) - depthKey(x) || x.index - y.index,
  distance: (x, y) => distanceKey(x) - distanceKey(y) || x.index - y.index,
  size: (x, y) => y.size - x.size || x.index - y.index,
};
function compareText(x, y) { return x < y ? -1 : x > y ? 1 : 0; }
function depthKey(clash) { return clash.depth ? clash.depth[0] : -1; }
function distanceKey(clash) { return clash.distance === null ? (clash.kind === "clearance" ? 1e308 : 0) : clash.distance; }

const hidden = new Set();
let found = clashes;
let made = 0;

function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) made.setAttribute(name, value);
  made.append(...children.filter((child) => child !== null));
  return made;
}
const byId = (id) => document.getElementById(id);
const short = (value) => String(Number(value.toPrecision(8)));
const many = (count, one, more) => count.toLocaleString("en") + " " + (count === 1 ? one : more);
const point = (values, at) => `(${values[at]}, ${values[at + 1]}, ${values[at + 2]})`;

function pictureOf(index) {
  const stored = byId("p" + index);
  return stored === null ? null : "data:image/png;base64," + stored.textContent;
}

function depthText(depth) {
  const [least, most] = depth;
  if (least === most) return String(least);
  if (most === null) return `at least ${least}`;
  return `from ${least} to ${most}`;
}

function partLine(index, color) {
  const [name, file, group] = data.parts[index];
  const rest = [group === "" ? "" : "group " + group.toUpperCase(), name === file ? "" : file].filter((text) => text !== "");
  return element("div", { class: "part", style: `--part: var(--${color})` },
                 element("span", {}, element("b", {}, name), " ",
                         element("span", { class: "quiet small" }, rest.join(" · "))));
}

function fact(list, name, ...value) {
  list.append(element("dt", {}, name), element("dd", {}, ...value));
}

function whereText(box) {
  return ["x", "y", "z"].map((axis, k) => {
    const text = box[k] === box[k + 3] ? short(box[k]) : `${short(box[k])} … ${short(box[k + 3])}`;
    return element("span", { title: `${box[k]} … ${box[k + 3]}` }, `${axis} ${text}`);
  });
}

function lists(clash) {
  const { points, lines, lineCount } = clash;
  if (points.length === 0 && lineCount === 0) return null;
  const title = [points.length > 0 ? many(points.length / 3, "point", "points") : "",
                 lineCount > 0 ? many(lineCount, "line", "lines") : ""].filter((text) => text !== "").join(", ");
  const details = element("details", { class: "lists" }, element("summary", {}, title));
  details.addEventListener("toggle", () => {
    if (details.childElementCount > 1) return;
    const list = element("ul", { class: "coordinates" });
    for (let i = 0; i < points.length; i += 3) list.append(element("li", {}, point(points, i)));
    for (let i = 0; i < lines.length; i += 6) list.append(element("li", {}, `${point(lines, i)} to ${point(lines, i + 3)}`));
    if (lines.length / 6 < lineCount)
      list.append(element("li", {}, `and ${many(lineCount - lines.length / 6, "line", "lines")} more, which are in the JSON`));
    details.append(list);
  });
  return details;
}

function row(clash) {
  const facts = element("dl");
  if (clash.depth !== null) fact(facts, "Depth", depthText(clash.depth));
  if (clash.distance !== null) fact(facts, "Distance", String(clash.distance));
  fact(facts, "Where", ...whereText(clash.box));
  const words = element("div", { class: "words" },
    element("div", { class: "head" },
            element("span", { class: "kind", style: `--kind: var(--${clash.kind})`, title: about[clash.kind] }, clash.kind),
            clash.relation === clash.kind || clash.relation === "apart" ? null : element("span", { class: "quiet small" }, relationText(clash)),
            element("a", { class: "quiet small", href: "#c" + clash.index }, "#" + (clash.index + 1))),
    partLine(clash.a, "first"), partLine(clash.b, "second"), facts, lists(clash));
  const source = pictureOf(clash.index);
  const item = element("li", { class: source === null ? "clash bare" : "clash", id: "c" + clash.index });
  if (source !== null) {
    const alt = `${clash.names[0]} and ${clash.names[1]}: ${clash.kind}`;
    const button = element("button", { class: "picture", type: "button", title: "Larger" },
                           element("img", { src: source, alt, width: data.size[0], height: data.size[1] }));
    button.addEventListener("click", () => show(clash));
    item.append(button);
  }
  item.append(words);
  return item;
}

function relationText(clash) {
  if (clash.relation === "inside") return "the first in the second";
  if (clash.relation === "contains") return "the second in the first";
  if (clash.relation === "partly_inside") return "partly inside";
  return clash.relation;
}

function makeRows(count) {
  const end = Math.min(found.length, made + count);
  const rows = document.createDocumentFragment();
  for (; made < end; ++made) rows.append(row(found[made]));
  byId("list").append(rows);
  byId("more").hidden = made === found.length;
}

function update() {
  const words = byId("search").value.toLowerCase().split(/\s+/).filter((word) => word !== "");
  found = clashes.filter((clash) => !hidden.has(clash.kind) && words.every((word) => clash.text.includes(word)));
  found.sort(orders[byId("order").value]);
  byId("list").replaceChildren();
  made = 0;
  makeRows(rowsAtOnce);
  byId("shown").textContent = found.length === clashes.length ? many(found.length, "clash", "clashes")
                                                              : `${found.length.toLocaleString("en")} of ${many(clashes.length, "clash", "clashes")}`;
}

// A picture by itself, with the ones before and after it.
let shownAt = 0;
function show(clash) {
  shownAt = found.indexOf(clash);
  const source = pictureOf(clash.index);
  byId("large").src = source;
  byId("large").alt = `${clash.names[0]} and ${clash.names[1]}: ${clash.kind}`;
  byId("caption").textContent = `#${clash.index + 1} ${clash.kind}: ${clash.names[0]} and ${clash.names[1]}`;
  if (!byId("viewer").open) byId("viewer").showModal();
}
function step(by) {
  for (let i = shownAt + by; i >= 0 && i < found.length; i += by) {
    if (pictureOf(found[i].index) !== null) return show(found[i]);
  }
}

function makeKinds() {
  kinds.forEach((kind, index) => {
    if (data.counts[index] === 0) return;
    const chip = element("button", { class: "chip", type: "button", "aria-pressed": "true", title: about[kind],
                                     style: `--kind: var(--${kind})` }, kind, " ",
                         element("b", {}, data.counts[index].toLocaleString("en")));
    chip.addEventListener("click", () => {
      if (!hidden.delete(kind)) hidden.add(kind);
      chip.setAttribute("aria-pressed", String(!hidden.has(kind)));
      update();
    });
    byId("kinds").append(chip);
  });
}

function table(id, rows) {
  if (rows.length === 0) return;
  byId(id).hidden = false;
  const limit = 500;
  for (const cells of rows.slice(0, limit))
    byId(id).querySelector("tbody").append(element("tr", {}, ...cells.map((cell) => element("td", {}, cell))));
  if (rows.length > limit)
    byId(id).append(element("p", { class: "quiet" }, `and ${rows.length - limit} more, which are in the JSON`));
}

function start() {
  const options = data.options.map(([name, value]) => "--" + name + (value === "" ? "" : " " + value)).join(", ");
  byId("facts").textContent = many(data.parts.length, "part", "parts") + (options === "" ? "" : `, with ${options}`);
  makeKinds();
  byId("search").addEventListener("input", update);
  byId("order").addEventListener("change", update);
  byId("more").addEventListener("click", () => makeRows(rowsAtOnce));
  byId("before").addEventListener("click", () => step(-1));
  byId("after").addEventListener("click", () => step(1));
  byId("close").addEventListener("click", () => byId("viewer").close());
  byId("viewer").addEventListener("keydown", (event) => {
    if (event.key === "ArrowLeft") step(-1);
    if (event.key === "ArrowRight") step(1);
  });
  new IntersectionObserver((entries) => { if (entries[0].isIntersecting) makeRows(rowsAtOnce); }, { rootMargin: "1200px" })
    .observe(byId("more"));
  window.addEventListener("beforeprint", () => {
    makeRows(Math.max(0, rowsInPrint - made));
    byId("left-out").textContent = made < found.length ? `Printed: the first ${made} of ${found.length} clashes.` : "";
  });
  table("not-solid", data.parts.filter((part) => part[4] !== "").map((part) => [part[0], part[1], part[4]]));
  table("failed", data.failed);
  table("notes", data.notes.map((note) => [note]));
  update();
  const target = /^#c(\d+)$/.exec(location.hash);  // a row that may not be made yet
  if (target !== null && Number(target[1]) < found.length) {
    makeRows(Math.max(0, Number(target[1]) + 1 - made));
    byId("c" + target[1]).scrollIntoView();
  }
}
start();
