/// <reference types="vite/client" />

/** The script of a worker as text; see `plugins/worker-code.ts`. */
declare module '*?code' {
  const code: string;
  export default code;
}
