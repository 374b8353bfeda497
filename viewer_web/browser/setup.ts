import { afterEach } from 'vitest';
import { takeBack } from './browser.js';
import { removeTemporaryFiles } from './temporary.js';

afterEach(async ({ task }) => {
  await takeBack(task.result?.state !== 'fail');
  removeTemporaryFiles();
});
