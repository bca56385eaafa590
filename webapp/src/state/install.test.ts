import { expect, test } from "vitest";
import { platform } from "./install";

test("a phone is told how its own system does it", () => {
  expect(platform("Mozilla/5.0 (Linux; Android 14; Pixel 8) Chrome/143", 5)).toBe("android");
  expect(platform("Mozilla/5.0 (iPhone; CPU iPhone OS 18_4 like Mac OS X)", 5)).toBe("iphone");
  expect(platform("Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7)", 5)).toBe("iphone");
  expect(platform("Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7)", 0)).toBe("other");
  expect(platform("Mozilla/5.0 (X11; Linux x86_64)", 0)).toBe("other");
});
