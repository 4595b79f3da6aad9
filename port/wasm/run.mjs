// run.mjs - runs a firmware that is a WebAssembly module:
//
//     node port/wasm/run.mjs FILE
//
// Its console is standard output; what main returns, modulo 256, is the exit code.
import { readFileSync, writeSync } from "node:fs";

const STANDARD_OUTPUT = 1;

const module = await WebAssembly.compile(readFileSync(process.argv[2]));
const instance = await WebAssembly.instantiate(module, {
    console: {
        write(text, length) {
            writeSync(STANDARD_OUTPUT, new Uint8Array(instance.exports.memory.buffer, text, length));
        },
    },
});
process.exitCode = instance.exports.main() & 255;
