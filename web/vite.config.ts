// How the pages are bundled: hashed files below assets/, no source maps, three.js and CodeMirror in chunks of their own.
import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vitest/config";

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
  server: { port: 5173, strictPort: true, proxy: { "/api": "http://127.0.0.1:8470" } },
  test: { include: ["tests/**/*.test.ts"], environment: "node" },
});
