import { describe, expect, it } from "vitest";
import { answerTo, kept, type Build } from "./shell";

const HERE = "https://cell.local:8080";
const ask = (method: string, path: string, mode = "cors") =>
  answerTo({ method, url: HERE + path, mode }, HERE);

describe("the service worker", () => {
  it("never touches the interface, whatever the method", () => {
    for (const method of ["GET", "POST", "PATCH", "DELETE"]) {
      for (const path of ["/api/v1/robots/left/stop", "/api/v1/reproductions", "/api/v1/session"]) {
        expect(ask(method, path), `${method} ${path}`).toBe("not ours");
        expect(ask(method, path, "navigate")).toBe("not ours");
      }
    }
  });

  it("answers for the page and for files with a hash in their name", () => {
    expect(ask("GET", "/", "navigate")).toBe("page");
    expect(ask("GET", "/assets/index-abc.js")).toBe("kept file");
    expect(ask("POST", "/", "navigate")).toBe("not ours");
    expect(ask("POST", "/assets/index-abc.js")).toBe("not ours");
  });

  it("leaves everything else to the browser", () => {
    expect(ask("GET", "/")).toBe("not ours");
    expect(ask("GET", "/team-cell.crt", "navigate")).toBe("not ours");
    expect(ask("GET", "/manifest.webmanifest")).toBe("not ours");
    const elsewhere = { method: "GET", url: "https://elsewhere/assets/a.js", mode: "cors" };
    expect(answerTo(elsewhere, HERE)).toBe("not ours");
  });

  it("keeps the shell and the words of one language", () => {
    const languages = { de: ["/assets/de.js"], fr: ["/assets/fr.js"] };
    const build: Build = { version: "1", shell: ["/", "/assets/index.js"], languages };
    expect(kept(build, "de")).toEqual(["/", "/assets/index.js", "/assets/de.js"]);
    for (const language of ["en", "xx", null]) expect(kept(build, language)).toEqual(build.shell);
  });
});
