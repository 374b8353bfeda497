import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folders: string[] = [];

/** The path of a new file with this name. The file is removed after the current test. */
export function temporaryFile(name: string): string {
  const folder = mkdtempSync(join(tmpdir(), 'vidno-'));
  folders.push(folder);
  return join(folder, name);
}

export function removeTemporaryFiles(): void {
  for (const folder of folders.splice(0)) rmSync(folder, { recursive: true });
}
