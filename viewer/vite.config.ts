/** Builds one page at a time (`--mode run` or `--mode study`) into one file without references. */
import { defineConfig, type Plugin } from "vite";

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
          const code = file.code.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
          html = html.replace(new RegExp(`<script[^>]*src="[^"]*${name}"[^>]*></script>`), () => "");
          html = html.replace("</body>", () => `<script type="module">${code}</script>\n</body>`);
        } else if (file.fileName.endsWith(".css")) {
          html = html.replace(new RegExp(`<link[^>]*href="[^"]*${name}"[^>]*>`), () => `<style>${String(file.source)}</style>`);
        } else continue;
        delete bundle[file.fileName];
      }
      if (/<script[^>]* src=|<link[^>]* href="(?!data:)/.test(html)) throw new Error("the page still refers to another file");
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
    rollupOptions: { input: `${mode}.html`, output: { inlineDynamicImports: true } },
  },
}));
