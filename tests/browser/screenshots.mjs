// Screenshots of every page and state, in every language, light and dark:
//
//   npm run screenshots [-- [--only NAME,…] [--languages en,de] [--size small|usual|tablet] FOLDER]
//
// Takes the server at BASE_URL when that is set, which must have the virtual robot and is filled
// with tasks of its own; else starts one of its own (`cargo run`) on an empty data folder.
import { spawn } from "node:child_process";
import { mkdir, mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { createInterface } from "node:readline";
import { parseArgs } from "node:util";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    only: { type: "string" },
    languages: { type: "string" },
    size: { type: "string", default: "usual" },
  },
});
const ROOT = path.resolve(import.meta.dirname, "../..");
const folder = path.resolve(positionals[0] ?? path.join(ROOT, "target/screenshots"));

/** Starts the program from the sources; resolves with its address when it says that it is ready. */
async function startServer() {
  const data = await mkdtemp(path.join(tmpdir(), "team-screenshots-"));
  const options = ["--listen", "127.0.0.1:0", "--egm-port", "0", "--data", data];
  const child = spawn("cargo", ["run", "--quiet", "-p", "server", "--", ...options], {
    cwd: ROOT,
    stdio: ["ignore", "pipe", "inherit"],
    // A group of its own, so that Cargo and the program end together.
    detached: true,
  });
  const stop = async () => {
    process.kill(-child.pid, "SIGTERM");
    await new Promise((resolve) => child.once("exit", resolve));
    await rm(data, { recursive: true });
  };
  for await (const line of createInterface({ input: child.stdout })) {
    const address = /http:\S+/.exec(line)?.[0];
    if (address) {
      child.stdout.resume();
      return { address, stop };
    }
  }
  throw new Error("the server did not start");
}

/** The languages that the app has, from its own list. */
async function languages() {
  if (values.languages) return values.languages.split(",");
  const source = await readFile(path.join(ROOT, "webapp/src/texts/index.ts"), "utf8");
  return [...source.matchAll(/code: "(\w+)"/g)].map(([, code]) => code);
}

async function shoot(browser, world, language) {
  const { drawn, newPhone, SIZES } = await import("./support/phone.mjs");
  const { enter, readyForStates, statesOf } = await import("./support/states.mjs");
  const phone = await newPhone(browser, { viewport: SIZES[values.size] });
  phone.context.setDefaultTimeout(15_000);
  const setStage = await readyForStates(phone.context, language);
  const only = values.only?.split(",");
  const missed = [];
  for (const state of statesOf(world).filter(({ name }) => only?.includes(name) ?? true)) {
    try {
      await enter(phone.page, setStage, state, process.env.BASE_URL);
      for (const colorScheme of ["light", "dark"]) {
        await phone.page.emulateMedia({ colorScheme });
        await drawn(phone.page);
        const name = `${state.name}.${language}.${colorScheme}.png`;
        await phone.page.screenshot({ path: path.join(folder, name) });
      }
    } catch (error) {
      missed.push(`${state.name}.${language}: ${error.message.split("\n")[0]}`);
    }
  }
  await phone.context.close();
  return [...missed, ...phone.errors];
}

const server = process.env.BASE_URL ? null : await startServer();
if (server) process.env.BASE_URL = server.address;
try {
  // Only now: these modules read BASE_URL when they are loaded.
  const { openBrowser } = await import("./support/phone.mjs");
  const { makeWorld, nameTasks } = await import("./support/world.mjs");
  await mkdir(folder, { recursive: true });
  const world = await makeWorld();
  const browser = await openBrowser();
  const missed = [];
  for (const language of await languages()) {
    await nameTasks(world, language);
    missed.push(...(await shoot(browser, world, language)));
  }
  await browser.close();
  console.log(`Screenshots are in ${folder}.`);
  if (missed.length > 0) {
    console.error(`Not reached:\n${missed.join("\n")}`);
    process.exitCode = 1;
  }
} finally {
  await server?.stop();
}
