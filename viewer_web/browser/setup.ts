import { afterEach } from 'vitest';
import { takeBack } from './browser.js';

afterEach(async ({ task }) => {
  await takeBack(task.result?.state !== 'fail');
});
