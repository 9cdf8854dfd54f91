/** Builds one page at a time (`--mode run`, `study`, `verdicts` or `live`) into one file without references. */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { defineConfig, type Plugin } from "vite";

/** Comes minified; put into the page as it is, since taking it apart again would take most of the build. */
const plotly = "plotly.js-cartesian-dist-min";

const script = (code: string): string =>
  `<script>${code.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--")}</script>\n`;

/** Puts script and style into the page, so that it opens by double click and never asks a network. */
function inlineEverything(): Plugin {
  return {
    name: "inline-everything",
    enforce: "post",
    generateBundle(_options, bundle) {
      const page = Object.values(bundle).find((file) => file.fileName.endsWith(".html"));
      if (page === undefined || page.type !== "asset") throw new Error("no page was made");
      let html = String(page.source);
      for (const file of Object.values(bundle)) {
        const name = file.fileName.replace(/[.]/g, "\\.");
        // Replacements are functions: a `$&` in minified code must stay as it is.
        if (file.type === "chunk") {
          const library = file.imports.includes(plotly)
            ? script(readFileSync(createRequire(import.meta.url).resolve(plotly), "utf8"))
            : "";
          html = html.replace(new RegExp(`<script[^>]*src="[^"]*${name}"[^>]*></script>`), () => "");
          html = html.replace("</body>", () => `${library}${script(file.code)}</body>`);
        } else if (file.fileName.endsWith(".css")) {
          html = html.replace(
            new RegExp(`<link[^>]*href="[^"]*${name}"[^>]*>`),
            () => `<style>${String(file.source)}</style>`,
          );
        } else continue;
        delete bundle[file.fileName];
      }
      if (/<script[^>]* src=|<link[^>]* href="(?!data:)/.test(html))
        throw new Error("the page still refers to another file");
      page.source = html;
    },
  };
}

export default defineConfig(({ mode }) => ({
  base: "./",
  plugins: [inlineEverything()],
  build: {
    target: "es2022",
    emptyOutDir: mode === "run",
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      input: `${mode}.html`,
      external: [plotly],
      output: { format: "iife", globals: { [plotly]: "Plotly" } },
    },
  },
}));
