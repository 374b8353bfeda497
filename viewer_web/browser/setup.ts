import { afterEach } from 'vitest';
import { takeBack } from './browser.js';
import { removeFiles } from './page.js';

afterEach(async ({ task }) => {
  await takeBack(task.result?.state !== 'fail');
  removeFiles();
});
