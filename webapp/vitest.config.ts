// Unit tests of the parts that need no server. Those that draw ask for a simulated browser with
// `@vitest-environment happy-dom` in their first line.
import { defineConfig } from "vitest/config";

export default defineConfig({
  test: { environment: "node", include: ["src/**/*.test.{ts,tsx}"] },
});
