// Builds the service worker after the app, because it has to know the app's files by their names.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import path from "node:path";
import { build, type Plugin, type ResolvedConfig, type Rolldown } from "vite";
import type { Build } from "./src/worker/shell";

const WORKER = "src/worker/worker.ts";
/** The words of one language, the app's own and the server's; each is loaded by itself. */
const LANGUAGE = /\/src\/(?:texts|words)\/([a-z]{2})\/index\.ts$/;

export function serviceWorker(): Plugin {
  let config: ResolvedConfig;
  return {
    name: "service-worker",
    apply: "build",
    configResolved(resolved) {
      config = resolved;
    },
    async writeBundle(options, bundle) {
      const outDir = options.dir ?? config.build.outDir;
      const page = readFileSync(path.join(outDir, "index.html"));
      const files = describe(bundle, createHash("sha256").update(page));
      await build({
        configFile: false,
        root: config.root,
        publicDir: false,
        logLevel: "warn",
        define: { BUILD: JSON.stringify(files) },
        build: {
          outDir,
          emptyOutDir: false,
          copyPublicDir: false,
          modulePreload: false,
          target: config.build.target,
          rollupOptions: {
            input: path.join(config.root, WORKER),
            output: { format: "iife", entryFileNames: "sw.js" },
          },
        },
      });
    },
  };
}

function describe(bundle: Rolldown.OutputBundle, hash: ReturnType<typeof createHash>): Build {
  const chunks = Object.values(bundle).filter((file) => file.type === "chunk");
  const shell = new Set(["/"]);
  for (const chunk of chunks.filter((one) => one.isEntry)) addFiles(bundle, chunk, shell);
  const languages: Record<string, string[]> = {};
  for (const chunk of chunks) {
    const language = LANGUAGE.exec(chunk.facadeModuleId ?? "")?.[1];
    if (language === undefined) continue;
    const files = new Set<string>();
    addFiles(bundle, chunk, files);
    const own = [...files].filter((file) => !shell.has(file));
    languages[language] = [...(languages[language] ?? []), ...own];
  }
  // Every name in assets/ holds a hash of the file, so the names stand for the whole build.
  for (const name of Object.keys(bundle).sort()) hash.update(name);
  return { version: hash.digest("hex").slice(0, 16), shell: [...shell], languages };
}

/** A chunk with all that is loaded together with it. */
function addFiles(
  bundle: Rolldown.OutputBundle,
  chunk: Rolldown.OutputChunk,
  files: Set<string>,
): void {
  const name = `/${chunk.fileName}`;
  if (files.has(name)) return;
  files.add(name);
  for (const style of chunk.viteMetadata?.importedCss ?? []) files.add(`/${style}`);
  for (const imported of chunk.imports) {
    const next = bundle[imported];
    if (next?.type === "chunk") addFiles(bundle, next, files);
  }
}
