import packed from 'virtual:vidno-engine';
import { fromBase64 } from '../base/base64.js';
import { startEngine } from '../replay/engine.js';

async function compiled(): Promise<WebAssembly.Module> {
  const bytes = new Blob([fromBase64(packed)])
    .stream()
    .pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
}

startEngine(compiled());
