#!/usr/bin/env node
// The program vidno, compiled to WebAssembly. This script gives it what Node has: the hash and gzip.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { constants, gunzipSync, gzipSync } from 'node:zlib';
import start from './program.js';

let memory;
const bytes = (at, size) => new Uint8Array(memory.buffer, at >>> 0, size >>> 0);

let packing = new Uint8Array();

const gunzipped = (packed) => {
  try {
    return { data: gunzipSync(packed), cut: false };
  } catch {
    return { data: gunzipSync(packed, { finishFlush: constants.Z_SYNC_FLUSH }), cut: true };
  }
};

// What the program imports: see sha256.cpp and gzip.cpp in trace/wasm.
const vidno = {
  sha256: (at, size, to) => {
    bytes(to, 32).set(createHash('sha256').update(bytes(at, size)).digest());
  },
  packed: (at, size) => {
    packing = gzipSync(bytes(at, size), { level: 6 });
    return packing.length;
  },
  unpacked: (at, size) => {
    try {
      const { data, cut } = gunzipped(bytes(at, size));
      packing = data;
      return cut ? -1 - data.length : data.length;
    } catch {
      packing = new Uint8Array();
      return -1;
    }
  },
  packing_take: (to) => {
    bytes(to, packing.length).set(packing);
  },
};

const file = readFileSync(new URL('program.wasm', import.meta.url));
await start({
  arguments: process.argv.slice(2),
  instantiateWasm: (imports, ready) => {
    WebAssembly.instantiate(file, { ...imports, vidno }).then(({ instance, module }) => {
      memory = instance.exports.memory;
      ready(instance, module);
    });
    return {};
  },
});
