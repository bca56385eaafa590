// How the phone app is bundled. Its unit tests are set up in vitest.config.ts, so that a build
// needs no test tools.
import { defineConfig } from "vite";
import { serviceWorker } from "./vite.worker.ts";

export default defineConfig({
  publicDir: "../static",
  plugins: [serviceWorker()],
  build: {
    // The build script of the Rust crate passes another folder; this is for a build by hand.
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    // No data: addresses: the Content-Security-Policy stays simple and every file can be cached.
    assetsInlineLimit: 0,
    // The drawing of the arm is fetched only where one is shown (docs/adr/0028).
    chunkSizeWarningLimit: 600,
  },
  server: {
    proxy: { "/api": { target: "http://127.0.0.1:8080", ws: true } },
  },
});
