/// <reference types="vite/client" />

/** The script of a worker as text; see `plugins/worker-code.ts`. */
declare module '*?code' {
  const code: string;
  export default code;
}

declare module 'virtual:vidno-engine' {
  /** The module that replays traces, gzip in base64. */
  const packed: string;
  export default packed;
}
