// SPDX-License-Identifier: Apache-2.0
// The script of the report: tables are sorted by the column whose head is pressed, once upwards,
// then downwards. Without it they stay in the order in which they were written.
#include "report_page.h"

namespace bench {

const char kReportScript[] = R"(for (const table of document.querySelectorAll("table.sortable")) {
  const heads = [...table.tHead.rows[0].cells];
  const body = table.tBodies[0];
  const textOf = (row, column) => row.cells[column].textContent.trim();
  // NaN where a cell doesn't begin with a number.
  const numberOf = (text) => parseFloat(text.replace(/^\u2212/, "-"));
  const sort = (column) => {
    const head = heads[column];
    const down = head.getAttribute("aria-sort") === "ascending";
    const rows = [...body.rows];
    const texts = rows.map((row) => textOf(row, column));
    const words = texts.some((text) => Number.isNaN(numberOf(text)) && !/^[-\u2013]?$/.test(text));
    const compare = (a, b) => {
      const x = textOf(a, column), y = textOf(b, column);
      if (words) return down ? y.localeCompare(x) : x.localeCompare(y);
      const p = numberOf(x), q = numberOf(y);
      // What has no number comes last either way.
      if (Number.isNaN(p) || Number.isNaN(q)) return Number.isNaN(p) - Number.isNaN(q);
      return down ? q - p : p - q;
    };
    rows.sort(compare);
    body.append(...rows);
    for (const other of heads) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
  };
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.title = "Sort by this column";
    button.append(...head.childNodes);
    button.addEventListener("click", () => sort(column));
    head.append(button);
  });
}
)";

}  // namespace bench
