// The page's style sheet, but for its colours, which are those of engine_style.hpp.
#pragma once

namespace ecods::bench {

// Wide tables scroll in their own box, so that the page itself never does; on paper nothing is cut off.
constexpr const char* page_style = R"(
:root { color-scheme: light dark; }
* { box-sizing: border-box; }
body { font: 16px/1.5 Georgia, "Times New Roman", serif; color: var(--ink); background: var(--paper); margin: 0 auto;
       max-width: 70rem; padding: 1.2rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0 1rem; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; border-top: 1px solid var(--soft); padding-top: 1rem; }
a { color: var(--ecods); }
p { margin: .5rem 0; max-width: 46rem; }
nav ol { columns: 18rem; column-gap: 2rem; margin: .3rem 0; padding-left: 1.6rem; }
nav li { break-inside: avoid; }
.verdict { font-size: 1.1rem; font-weight: bold; }
.table { overflow-x: auto; margin: 1rem 0 .3rem; }
table { border-collapse: collapse; font: 14px/1.4 "DejaVu Sans", Verdana, sans-serif;
        font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: bold; padding-bottom: .35rem; }
th, td { padding: .22rem .75rem; text-align: right; border-bottom: 1px solid var(--grid); vertical-align: top; }
td { white-space: nowrap; }
thead th { border-bottom: 1.5px solid var(--ink); vertical-align: bottom; }
th:first-child, td:first-child { padding-left: 0; position: sticky; left: 0; background: var(--paper); }
.text { text-align: left; }
.group td { border-top: 2px solid var(--soft); }
.words td + td { white-space: normal; }
.loud { font-weight: bold; color: var(--fcl); }
.note { font-size: .85rem; color: var(--soft-ink); margin: .15rem 0; }
figure { margin: 1.2rem 0; }
.picture img { width: 100%; height: auto; display: block; border: 1px solid var(--soft); }
.panels { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(20rem, 100%), 1fr)); gap: .4rem 1rem; }
.panels.two { grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); }
.panels.one { display: block; max-width: 46rem; }
.panels svg { width: 100%; height: auto; display: block; overflow: visible; }
.mark:hover use { stroke: var(--ink); stroke-width: .5; }
.mark { pointer-events: bounding-box; }
.key { display: flex; flex-wrap: wrap; gap: .1rem 1.1rem; list-style: none; margin: .2rem 0 .6rem; padding: 0;
       font: 13px/1.6 "DejaVu Sans", Verdana, sans-serif; }
.key svg { width: 2.2em; height: 1em; vertical-align: -.12em; margin-right: .3em; overflow: visible; }
details { margin: .6rem 0; } summary { cursor: pointer; color: var(--soft-ink); }
figcaption { font-size: .9rem; margin-top: .4rem; max-width: 46rem; }
.origin { display: block; font: 11px/1.4 "DejaVu Sans", Verdana, sans-serif; color: var(--soft-ink);
          overflow-wrap: anywhere; }
@media screen and (max-width: 44rem) {
  body { font-size: 15px; padding: .7rem; } table { font-size: 12px; } th, td { padding: .2rem .45rem; }
  td:first-child, th:first-child { max-width: 9.5rem; white-space: normal; }
}
@media print { body { max-width: none; padding: 0; font-size: 10.5pt; } table { font-size: 7.5pt; }
               .table { overflow: visible; } figcaption, tr, .panels svg, .picture { break-inside: avoid; }
               .key { break-after: avoid; break-inside: avoid; } h2, caption { break-after: avoid; } td { white-space: normal; }
               th, td { padding: .15rem .35rem; } th:first-child, td:first-child { position: static; }
               .panels { display: block; font-size: 0; } .panels svg { display: inline-block; width: 32.6%; }
               .panels.two svg { width: 49%; } .panels.one svg { width: 70%; } .picture img { max-height: 24cm;
               object-fit: contain; } }
)";

}  // namespace ecods::bench
