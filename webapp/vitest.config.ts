// Unit tests of the parts that need no server, in a simulated browser: the words follow the
// phone's language, and most of the app has words.
import { defineConfig } from "vitest/config";

export default defineConfig({
  test: { environment: "happy-dom", include: ["src/**/*.test.{ts,tsx}"] },
});
