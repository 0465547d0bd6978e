// SPDX-License-Identifier: Apache-2.0
// The style sheet of the report: one set of names for colours, with light and dark values.
#include "report_page.h"

namespace bench {

const char kReportStyle[] = R"(:root {
  --page: #fdfdfc; --ink: #1c2127; --soft: #5a636e; --rule: #d5d9de; --raised: #f2f3f5;
  --link: #1b5fc1;
  --c0: #1f66d0; --c1: #c2480a; --c2: #17803d; --c3: #8b36d6;
  --c4: #b5202f; --c5: #0b7285; --c6: #946200; --c7: #4b5563;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #15181c; --ink: #e4e7ea; --soft: #a3abb5; --rule: #3a4149; --raised: #20252b;
    --link: #82b4ff;
    --c0: #7ab0ff; --c1: #ff9d5c; --c2: #6bd18a; --c3: #c79bff;
    --c4: #ff8585; --c5: #5cd0e0; --c6: #e0bf4a; --c7: #b6bdc8;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body {
  margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.5 system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
}
main { max-width: 1200px; margin: 0 auto; padding: 1rem clamp(0.8rem, 3vw, 2rem) 4rem; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 1rem 0; }
h2 { font-size: 1.4rem; line-height: 1.25; margin: 0 0 0.8rem; }
h3 { font-size: 1.1rem; margin: 1.8rem 0 0.5rem; }
p, dl, nav, details { max-width: 46rem; }
p { overflow-wrap: anywhere; }
a { color: var(--link); }
section { margin-top: 2.5rem; padding-top: 1.5rem; border-top: 1px solid var(--rule); }
.when, caption, figcaption { color: var(--soft); font-size: 0.9rem; }
.when { margin-top: 1.2rem; }
dt { font-weight: 600; }
dd { margin: 0 0 0.5rem; overflow-wrap: anywhere; }
.facts {
  display: grid; grid-template-columns: auto 1fr; gap: 0.1rem 1rem; font-size: 0.9rem;
  padding: 0.7rem 0.9rem; background: var(--raised); border-radius: 6px;
}
.facts dt { font-weight: 400; color: var(--soft); }
.facts dd { margin: 0; }
code, pre { font: 0.86rem/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
nav code { color: var(--soft); }
summary { cursor: pointer; color: var(--link); }
pre {
  margin: 0.6rem 0 1rem; padding: 0.5rem 0.8rem; overflow-x: auto; background: var(--raised);
  border-radius: 6px; white-space: pre;
}
.table, .scroll { overflow-x: auto; max-width: 100%; }
.table { margin: 0.8rem 0 1.4rem; }
table {
  min-width: min(100%, 26rem); border-collapse: collapse; font-size: 0.88rem;
  font-variant-numeric: tabular-nums;
}
caption { text-align: left; padding-bottom: 0.4rem; }
caption span {
  display: block; position: sticky; left: 0; max-width: min(46rem, calc(100vw - 2.5rem));
}
th, td { padding: 0.25rem 0.6rem; text-align: left; vertical-align: top; }
td:first-child { white-space: nowrap; }
td { border-top: 1px solid var(--rule); }
th { vertical-align: bottom; border-bottom: 2px solid var(--rule); }
th.number, td.number { text-align: right; white-space: nowrap; }
th button {
  font: inherit; font-weight: 600; color: inherit; text-align: inherit; background: none;
  border: 0; padding: 0; cursor: pointer;
}
th button:hover, th[aria-sort] button { color: var(--link); }
th[aria-sort=ascending] button::after { content: " \25B2"; font-size: 0.7em; }
th[aria-sort=descending] button::after { content: " \25BC"; font-size: 0.7em; }
:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
figure { margin: 1.2rem 0; }
figcaption { max-width: 46rem; margin-top: 0.3rem; }
.images > div {
  display: grid; gap: 0.6rem; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr));
}
.images figure { margin: 0; max-width: 26rem; }
.images img { display: block; width: 100%; height: auto; background: #000; border-radius: 3px; }
svg.chart { display: block; width: 100%; height: auto; font-family: inherit; }
.chart-title { font-size: 13px; font-weight: 600; fill: var(--ink); }
.chart-label { font-size: 13px; fill: var(--ink); }
.chart-number { font-size: 12px; fill: var(--soft); }
.chart-grid { stroke: var(--rule); stroke-width: 0.7; }
.chart-frame { fill: none; stroke: var(--soft); stroke-width: 0.8; }
.chart-tick { stroke: var(--soft); stroke-width: 0.8; }
.chart-line { fill: none; stroke-width: 1.8; stroke-linejoin: round; }
.chart-whisker { stroke-width: 1.1; opacity: 0.75; }
.chart-marker { stroke: var(--page); stroke-width: 1; }
.chart-cross { stroke-width: 2; }
.chart-line, .chart-whisker, .chart-cross { stroke: var(--c); }
.chart-marker { fill: var(--c); }
.chart-colour-0 { --c: var(--c0); } .chart-colour-1 { --c: var(--c1); }
.chart-colour-2 { --c: var(--c2); } .chart-colour-3 { --c: var(--c3); }
.chart-colour-4 { --c: var(--c4); } .chart-colour-5 { --c: var(--c5); }
.chart-colour-6 { --c: var(--c6); } .chart-colour-7 { --c: var(--c7); }
@media (max-width: 480px) {
  .images > div { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  th, td { padding: 0.25rem 0.5rem; }
}
)";

}  // namespace bench
