// naga.mjs LIST: validates WGSL and writes it as SPIR-V; each line of LIST has the two files.
import fs from "node:fs";
import { parseWgsl, validate, writeSpirv } from "naga-wasm";

for (const line of fs.readFileSync(process.argv[2], "utf8").trim().split("\n")) {
  const [from, to] = line.split(" ");
  try {
    const module = parseWgsl(fs.readFileSync(from, "utf8"));
    fs.writeFileSync(to, Buffer.from(writeSpirv(module, validate(module)).buffer));
  } catch (error) {
    console.error(`${from}: ${error.formatted ?? error}`);
    process.exit(1);
  }
}
