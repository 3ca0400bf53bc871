// Builds the page from the report's contents: title and notes, then the parts pictures, charts,
// tables and facts, each from its template. A part without elements is left out.

"use strict";
const report = JSON.parse(document.getElementById("report").textContent);

// Children are elements or texts; a text stays as it is, whatever it holds.
function element(name, attributes, ...children) {
  const result = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
  result.append(...children);
  return result;
}

const image = (type, base64, attributes) =>
  element("img", { ...attributes, src: `data:image/${type};base64,${base64}` });

function fillPictures(part) {
  for (const select of part.querySelectorAll("select"))
    select.append(...report.pictures.map(({ label }) => element("option", {}, label)));
  part.querySelector("#stage").prepend(...report.pictures.map((picture) => {
    const { label, details, png, error_png: errors } = picture;
    const figure = element("figure", { class: "picture" },
      image("png", png, { class: "colour", alt: label, draggable: false }));
    if (errors)
      figure.append(image("png", errors,
        { class: "error", alt: `Error map of ${label}`, draggable: false }));
    figure.append(element("figcaption", {}, element("b", {}, label), " ",
      element("span", {}, details)));
    return figure;
  }));
}

function fillCharts(part) {
  part.firstElementChild.append(...report.charts.map(({ caption, svg }) =>
    element("figure", { class: "chart" }, image("svg+xml", svg, { alt: caption }),
      element("figcaption", {}, caption))));
}

// "number" for a column whose cells all begin with digits, after an optional sign or point; a unit
// may follow. Cells without letters and digits are empty ones.
function alignment({ rows }, column) {
  const cells = rows.map((row) => row[column] ?? "").filter((cell) => !/^[-+. ]*$/.test(cell));
  return cells.length > 0 && cells.every((cell) => /^[-+.]*[0-9]/.test(cell)) ? "number" : "text";
}

function fillTables(part) {
  part.firstElementChild.append(...report.tables.map((table) => {
    const align = table.header.map((_, column) => alignment(table, column));
    const row = (cells, name, attributes) => element("tr", {}, ...cells.map((cell, column) =>
      element(name, { ...attributes, class: align[column] ?? "text" }, cell)));
    return element("div",
      { class: "scroll", role: "group", tabindex: 0, "aria-label": table.caption },
      element("table", {}, element("caption", {}, table.caption),
        element("thead", {}, row(table.header, "th", { scope: "col" })),
        element("tbody", {}, ...table.rows.map((cells) => row(cells, "td", {})))));
  }));
}

function fillFacts(part) {
  part.querySelector("dl").append(...report.facts.flatMap(({ name, value, meaning }) =>
    [element("dt", { title: meaning }, name), element("dd", {}, value)]));
}

document.title = report.title;
const main = document.querySelector("main");
main.replaceChildren(element("h1", {}, report.title),
  ...report.notes.map((note) => element("p", {}, note)));
for (const [name, fill] of Object.entries(
  { pictures: fillPictures, charts: fillCharts, tables: fillTables, facts: fillFacts })) {
  if (report[name].length === 0) continue;
  const part = document.importNode(document.getElementById(name).content, true);
  fill(part);
  main.append(part);
}
