// How the pages are bundled: hashed files below assets/, no source maps, three.js and CodeMirror in chunks of their own.
import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vitest/config";

/** The server that pages under development speak to; it refuses requests of other origins than its own. */
const SERVER = "http://127.0.0.1:8470";

export default defineConfig({
  base: "/",
  plugins: [svelte()],
  build: {
    outDir: "dist",
    assetsDir: "assets",
    sourcemap: false,
    target: "es2022",
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 650,
  },
  server: {
    port: 5173,
    strictPort: true,
    proxy: { "/api": { target: SERVER, changeOrigin: true, headers: { origin: SERVER } } },
  },
  test: { include: ["tests/**/*.test.ts"], environment: "node" },
});
