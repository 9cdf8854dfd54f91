// Saves the figures of a page of verdicts (report.html of `validate`, report-<ID>.html of `reproduce`) as SVG files, one
// for each figure, or group of figures that belong together: stiffness.svg, stiffness-paths.svg, validate-fibres.svg.
// Needs chromium (or $CHROMIUM).
//   node tools/figures.mjs PAGE FOLDER
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { Browser } from "../viewer/drive.mjs";

const [file, folder] = process.argv.slice(2);
if (!file || !folder) throw new Error("node tools/figures.mjs PAGE FOLDER");

/** A number of pixels with one decimal, as short as it can be. */
const tenth = (n) => String(Number(Number(n).toFixed(1))).replace(/^(-?)0\./, "$1.");

/** Lines of a path, "M1,2L3,4L5,6", as steps of tenths of a pixel: "M1,2l2 2 2 2". */
function steps(path) {
  return path.replace(/M(-?[\d.]+),(-?[\d.]+)((?:L-?[\d.]+,-?[\d.]+){2,})/g, (_, x0, y0, lines) => {
    let [x, y] = [Math.round(10 * x0), Math.round(10 * y0)];
    const found = [...lines.matchAll(/L(-?[\d.]+),(-?[\d.]+)/g)].map((pair) => {
      const [u, v] = [Math.round(10 * pair[1]), Math.round(10 * pair[2])];
      const step = `${tenth((u - x) / 10)} ${tenth((v - y) / 10)}`;
      [x, y] = [u, v];
      return step;
    });
    return `M${tenth(Math.round(10 * x0) / 10)},${tenth(Math.round(10 * y0) / 10)}l${found.join(" ")}`.replaceAll(" -", "-");
  });
}

/** Dots of one look in a group as one path: a line of no length with round ends is a dot. */
function dotsTogether(svg) {
  const dot = /<path transform="translate\(([^,]+),([^)]+)\)" d="M([\d.]+),0A[^"]*" style="([^"]*)"\/>/g;
  return svg.replace(/<g>((?:<path transform="[^"]*" d="M[\d.]+,0A[^"]*" style="[^"]*"\/>){3,})<\/g>/g, (group, row) => {
    const dots = [...row.matchAll(dot)];
    const [, , , radius, style] = dots[0];
    if (dots.some((one) => one[3] !== radius || one[4] !== style) || !style.includes("stroke-width: 0px")) return group;
    const line = style.replace("stroke-width: 0px", `stroke-width: ${2 * radius}px; stroke-linecap: round`).replace(/fill(-opacity)?:/g, "stroke$1:");
    return `<path d="${dots.map(([, x, y]) => `M${tenth(x)},${tenth(y)}h0`).join("")}" style="${line}"/>`;
  });
}

/** Places of paths, dots and texts without a translation of their own. */
function moved(svg) {
  const by = / transform="translate\((-?[\d.]+),(-?[\d.]+)\)"/;
  return svg.replace(/<(path|text)[^>]*>/g, (element) => {
    const [found, dx, dy] = by.exec(element) ?? [];
    const from = / d="M(-?[\d.]+),(-?[\d.]+)([^"A-Z]*|[^"]*L[^"]*)"/.exec(element);
    if (found === undefined || (element.startsWith("<path") && (!from || /[A-KN-Y]/.test(from[3])))) return element;
    const rest = element.replace(found, "");
    const sum = (a, b) => tenth(Number(a) + Number(b));
    if (element.startsWith("<text")) return rest.replace(/ x="([^"]*)"/, (_, x) => ` x="${sum(x, dx)}"`).replace(/ y="([^"]*)"/, (_, y) => ` y="${sum(y, dy)}"`);
    return rest.replace(/([ML])(-?[\d.]+),(-?[\d.]+)/g, (_, to, x, y) => `${to}${sum(x, dx)},${sum(y, dy)}`);
  });
}

/** A document without elements that draw nothing. */
function withoutEmpty(svg) {
  const fewer = svg.replace(/<(g|defs)[^>]*\/>|<path(?: style="[^"]*")?\/>|<path d="M0,0Z"[^>]*\/>|<g(?: style="[^"]*")?>\s*<\/g>|<defs[^>]*><\/defs>/g, "");
  return fewer.length < svg.length ? withoutEmpty(fewer) : svg;
}

/** A document without groups that only group. */
function withoutGroups(svg) {
  const kept = [];
  return svg.replace(/ transform="rotate\(0,[^"]*"| style="opacity: 1;"/g, "").replace(/<g(\s[^>]*)?>|<\/g>/g, (tag, attributes) => {
    if (tag !== "</g>") kept.push(attributes !== undefined);
    return (tag === "</g>" ? kept.pop() : kept.at(-1)) ? tag : "";
  });
}

/**
 * A smaller document that looks the same: each style stands once, places have a tenth of a pixel; points of no size, what is
 * transparent, elements that draw nothing and names that nothing uses are gone.
 */
function smaller(svg) {
  const plain = svg
    .replace(/<path(?=[^>]* d="M0,0A0,0 )[^>]*\/>/g, "")
    .replace(/ (class|data-[\w-]+)="[^"]*"/g, "")
    .replace(/ style=""/g, "")
    .replace(/(<svg x=[^>]*?) xmlns="[^"]*" xmlns:xlink="[^"]*"/g, "$1")
    .replace(/<rect[^>]* style="[^"]*fill: rgb\(0, 0, 0\); fill-opacity: 0;[^"]*"\/>/g, "");
  const short = moved(withoutGroups(dotsTogether(withoutEmpty(plain))))
    .replace(/<path(?: transform="translate\(([^,]+),([^)]+)\)")? d="M([\d.]+),0A\3,\3 0 1,1 0,-\3A\3,\3 0 0,1 \3,0Z"/g, '<circle cx="$1" cy="$2" r="$3"')
    .replace(/<polygon points="([^"]*)"/g, (_, points) => `<path d="M${points.trim().split(/\s+/).join("L")}Z"`)
    .replace(/<\/polygon>/g, "</path>")
    .replace(/ (x|y|cx|cy|d|transform|width|height)="([^"]*)"/g, (_, name, value) => ` ${name}="${(name === "d" ? steps(value) : value).replace(/-?\d*\.\d{2,}/g, tenth)}"`);
  const styles = new Map();
  const styled = short.replace(/ style="([^"]*)"/g, (_, style) => {
    if (!styles.has(style)) styles.set(style, `s${styles.size}`);
    return ` class="${styles.get(style)}"`;
  });
  const rules = [...styles].map(([style, name]) => `.${name}{${style.replaceAll("&quot;", '"')}}`).join("\n");
  return styled.replace(">\n", `>\n<style>\n${rules.replaceAll("&", "&amp;").replaceAll("<", "&lt;")}\n</style>\n`);
}

/** In the page: the figures below an element as one SVG document, as they lie on the page. */
async function drawn(group) {
  const margin = 12;
  const plots = [...group.querySelectorAll(".plotly-figure")];
  for (const plot of plots) {
    plot.scrollIntoView();
    while (plot.dataset.drawn !== "true") await new Promise((later) => setTimeout(later, 20));
  }
  const box = group.getBoundingClientRect();
  const at = (element) => {
    const r = element.getBoundingClientRect();
    return { x: Math.round(r.left - box.left), y: Math.round(r.top - box.top), width: Math.round(r.width), height: Math.round(r.height) };
  };
  const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
  const label = (x, y, text, style) => `<text x="${x}" y="${y}" ${style}>${escaped(text)}</text>\n`;
  /** The lines of a text, as the browser has broken it. */
  const lines = (element) => {
    const found = new Map();
    const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
    const range = document.createRange();
    for (let node = walker.nextNode(); node; node = walker.nextNode())
      for (const word of node.data.matchAll(/\S+\s*/g)) {
        range.setStart(node, word.index);
        range.setEnd(node, word.index + word[0].length);
        const r = range.getClientRects()[0];
        const y = Math.round(r.bottom - box.top - 5);
        const line = found.get(y) ?? { x: Math.round(r.left - box.left), text: "" };
        found.set(y, { ...line, text: line.text + word[0] });
      }
    return [...found].map(([y, line]) => label(line.x, y, line.text.trim(), 'font-size="14" fill="#57606a"')).join("");
  };
  let body = "";
  for (const [k, plot] of plots.entries()) {
    const { x, y, width, height } = at(plot);
    const address = await Plotly.toImage(plot, { format: "svg", width, height });
    let svg = decodeURIComponent(address.slice(address.indexOf(",") + 1));
    svg = svg.replace(/\d+\.\d{4,}/g, (number) => String(Number(Number(number).toFixed(3)))); // of pixels
    const id = /clip([0-9a-f]{6})/.exec(svg)?.[1]; // plotly draws lots for its ids
    if (id) svg = svg.replaceAll(id, `figure${k}`);
    svg = svg.replace(/ trace[0-9a-f]{6}"/g, '"');
    body += `${svg.replace("<svg ", `<svg x="${x}" y="${y}" `)}\n`;
  }
  for (const shapes of group.querySelectorAll("svg.shapes")) {
    const copy = shapes.cloneNode(true);
    for (const [name, value] of Object.entries(at(shapes))) copy.setAttribute(name, String(value));
    for (const one of copy.querySelectorAll("text, rect")) one.setAttribute("fill", "#1f2328");
    body += `${new XMLSerializer().serializeToString(copy)}\n`;
  }
  for (const patch of group.querySelectorAll(".series .patch")) {
    const { x, y, width, height } = at(patch);
    body += `<rect x="${x}" y="${y}" width="${width}" height="${height}" fill="${getComputedStyle(patch).backgroundColor}"/>\n`;
  }
  for (const text of group.querySelectorAll("figcaption, .series li")) body += lines(text);
  const heading = group.closest("section").querySelector("h2").textContent;
  // A figure alone has its title in its caption.
  const titles = group.tagName === "FIGURE" ? [] : [heading.replace(/^Study [^:]*: /, ""), group.previousElementSibling.textContent];
  const top = 8 + 22 * titles.length;
  const [width, height] = [Math.ceil(box.width) + 2 * margin, Math.ceil(box.height) + top + margin];
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" ` +
    `role="img" aria-label="${escaped([heading, ...titles.slice(1)].join(": ")).replace(/"/g, "&quot;")}" font-family="system-ui, Helvetica, Arial, sans-serif">\n` +
    `<rect width="${width}" height="${height}" fill="#ffffff"/>\n` +
    titles.map((text, k) => label(margin, 22 + 22 * k, text, `font-size="17" font-weight="${k === 0 ? 600 : 400}" fill="#1f2328"`)).join("") +
    `<g transform="translate(${margin} ${top})">\n${body}</g>\n</svg>\n`
  );
}

mkdirSync(folder, { recursive: true });
const profile = mkdtempSync(join(tmpdir(), "figures-"));
const browser = new Browser(process.env.CHROMIUM ?? "chromium", profile);
try {
  const page = await browser.open(resolve(file), 1280, 900);
  await page('(async () => { while (document.documentElement.dataset.ready !== "true") await new Promise((later) => setTimeout(later, 20)); })()');
  const all = 'document.querySelectorAll("[data-figure]")';
  for (const [k, name] of (await page(`Array.from(${all}, (group) => group.dataset.figure)`)).entries()) {
    writeFileSync(join(folder, `${name}.svg`), smaller(await page(`(${drawn})(${all}[${k}])`)));
    console.log(join(folder, `${name}.svg`));
  }
} finally {
  await browser.close();
  rmSync(profile, { recursive: true, force: true });
}
