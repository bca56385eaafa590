// Lays beside each file of a finished build what the server sends to browsers that can unpack it:
// `name.br` and `name.gz`, where that is smaller than the file itself. Done once at build time, so
// that the strongest setting costs no request anything.
//
// node compress.mjs FOLDER
import { readdir, readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

/** What is compressed already gains nothing. */
const WORTH_IT = /\.(html|js|css|svg|json|webmanifest|txt)$/;

const folder = process.argv[2];
if (!folder) throw new Error("usage: node compress.mjs FOLDER");

for (const entry of await readdir(folder, { recursive: true, withFileTypes: true })) {
  if (!entry.isFile() || !WORTH_IT.test(entry.name)) continue;
  const file = path.join(entry.parentPath, entry.name);
  const plain = await readFile(file);
  const params = {
    [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
    [constants.BROTLI_PARAM_SIZE_HINT]: plain.length,
  };
  const packed = {
    br: brotliCompressSync(plain, { params }),
    gz: gzipSync(plain, { level: constants.Z_BEST_COMPRESSION }),
  };
  for (const [ending, bytes] of Object.entries(packed)) {
    if (bytes.length < plain.length) await writeFile(`${file}.${ending}`, bytes);
  }
}
