import { describe, expect, it } from 'vitest';
import { browser } from './browser.js';
import { compared, comparing, counter, differ, names, sentences, stepsOf } from './compare.js';
import { editing, handle, looks, rerun, spotOf } from './live.js';
import { goTo, open } from './page.js';

const lesson = 'trace=09-usual-mistakes.warnock.double.corrected.signs';

describe('the printed text beside the corrected one', () => {
  it('diverges in a number and in an action, and goes to both', async () => {
    const { page, faults } = await comparing(
      browser,
      `${lesson}&with=warnock.printed.double.signs`,
    );
    expect(await names(page)).toEqual([
      'Warnock · corrected · double',
      'Warnock · as printed · double',
    ]);
    // The planes differ by a factor. Two planes, push, pop, call, corners, box, count, four depths, four comparisons,
    // nearer: then k = 4, so that PW7 uncovers; as printed (X-W3) only 0 < k < 4 would.
    await page.getByRole('button', { name: 'step 18' }).click();
    expect(await stepsOf(page)).toEqual([18, 18]);
    expect(await sentences(page)).toEqual(['PW7', 'PW8']);
    await page.getByRole('button', { name: 'step 1', exact: true }).click();
    expect(await stepsOf(page)).toEqual([1, 1]);
    await page.keyboard.press('j');
    expect(await stepsOf(page)).toEqual([18, 18]);
    await page.keyboard.press('Shift+J');
    expect(await stepsOf(page)).toEqual([1, 1]);
    expect(faults).toEqual([]);
  });

  it('says how many pixels differ, and marks them', async () => {
    const { page } = await comparing(browser, `${lesson}&with=warnock.printed.double.signs`);
    // All 8 x 8 pixels of N are lost.
    expect(await differ(page).textContent()).toContain('0 now, 64 at the end');
    await page.keyboard.press('End');
    await expect.poll(() => differ(page).textContent()).toContain('64 now, 64 at the end');
    const image = (): Promise<string> =>
      page
        .locator('vidno-compared-run.other .cells')
        .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
    const plain = await image();
    await page.keyboard.press('l');
    await expect.poll(image).not.toBe(plain);
    await page.waitForURL(/layer=difference/);
    await page.getByRole('checkbox', { name: 'Mark them' }).uncheck();
    await expect.poll(image).toBe(plain);
  });

  it('has its counters beside those of the other', async () => {
    const { page } = await comparing(browser, `${lesson}&with=warnock.printed.double.signs`);
    await page.keyboard.press('j');
    // One window, popped in step 4. As printed, no other window is ever popped.
    await expect.poll(() => counter(page, 'windows')).toEqual(['1/149', '1/1']);
    // Q's four comparisons are done; N's four follow.
    expect((await counter(page, 'comparisons'))[1]).toBe('4/8');
    expect((await counter(page, 'steps'))[1]).toBe('18/62');
    expect((await counter(page, 'painted'))[1]).toBe('0/256');
  });

  it('bookmarks its step and saves both pictures, as its map of keys says', async () => {
    const { page } = await comparing(
      browser,
      `${lesson}&with=09-usual-mistakes.warnock.double.printed.signs&step=20`,
    );
    await page.keyboard.press('b');
    await page.waitForURL(/bookmarks=/);
    const files: string[] = [];
    page.on('download', (file) => files.push(file.suggestedFilename()));
    await page.keyboard.press('s');
    await expect.poll(() => files.length).toBe(2);
    expect(files.join()).toMatch(/corrected\.step-20\.svg,.*printed\.step-\d+\.svg$/u);
    await page.keyboard.press('?');
    const map = page.locator('vidno-comparison vidno-keys dl');
    expect(await map.textContent()).toContain('mark the pixels that differ');
    expect(await map.textContent()).not.toContain('question');
  });
});

describe('float beside exact', () => {
  it('diverges where the depth of a pixel is decided differently', async () => {
    const trace = 'trace=08-show-line.zbuffer.float.corrected.signs';
    const { page, faults } = await comparing(
      browser,
      `${trace}&with=zbuffer.corrected.exact.signs`,
    );
    // `vidno diff` finds step 1, a number. Without the numbers the lines of both files are the same up to 812.
    await page.keyboard.press('j');
    await expect.poll(() => stepsOf(page)).toEqual([813, 813]);
    const said = await page.locator('vidno-compared-run .sentence').allTextContents();
    for (const each of said) expect(each).toContain('Pixel (19, 10)');
    expect(said[0]).not.toBe(said[1]);
    expect(faults).toEqual([]);
  });
});

describe('Warnock beside the Z-buffer', () => {
  it('is chosen by keyboard, paired by share, kept in the link, and left', async () => {
    const { page, faults } = await open(browser, `#${lesson}&lang=en`);
    await page.locator('.title h2').getByText(/./u).waitFor();
    await page.keyboard.press('d');
    await page.locator('[name=method]:focus').waitFor();
    await page.keyboard.press('Enter');
    await compared(page);
    expect(await page.locator('.share').textContent()).toContain('aligned by progress');
    await page.keyboard.press('End');
    await expect.poll(() => stepsOf(page)).toEqual([5337, 541]);
    expect(await differ(page).textContent()).toContain('0 now, 0 at the end');
    expect(await counter(page, 'windows')).toEqual(['149/149', '—']);
    expect(await counter(page, 'ael')).toEqual(['—', '6/6']);
    await page.waitForURL(/with=zbuffer\.corrected\.double\.signs.*step=5337/);
    const again = await open(browser, new URL(page.url()).hash);
    await compared(again.page);
    expect(await stepsOf(again.page)).toEqual([5337, 541]);
    await page.keyboard.press('d');
    await page.locator('vidno-comparison').waitFor({ state: 'detached' });
    expect(await page.locator('vidno-player').isVisible()).toBe(true);
    await page.waitForURL((url) => !url.hash.includes('with='));
    expect(faults).toEqual([]);
  });

  it('is stepped alone when it is unlinked', async () => {
    const { page } = await comparing(browser, `${lesson}&with=zbuffer.corrected.double.signs`);
    await goTo(page, 100);
    // 100 of 5337 steps correspond to 10 of 541.
    await expect.poll(() => stepsOf(page)).toEqual([100, 10]);
    await page.getByRole('checkbox', { name: 'Step together' }).uncheck();
    await page.keyboard.press('ArrowRight');
    expect(await stepsOf(page)).toEqual([101, 10]);
    await page.getByRole('button', { name: 'The other run: step forward' }).click();
    expect(await stepsOf(page)).toEqual([101, 11]);
    await page.getByRole('spinbutton', { name: 'Step of the other run' }).fill('40');
    await page.getByRole('spinbutton', { name: 'Step of the other run' }).press('Enter');
    expect(await stepsOf(page)).toEqual([101, 40]);
    await page.getByRole('checkbox', { name: 'Step together' }).check();
    await expect.poll(() => stepsOf(page)).toEqual([101, 10]);
  });

  it('chooses a pixel in both', async () => {
    const { page } = await comparing(browser, `${lesson}&with=zbuffer.corrected.double.signs`);
    const { x, y } = await page.locator('vidno-compared-run.one .picture').evaluate((picture) => {
      const { left, top, width, height } = picture.getBoundingClientRect();
      return { x: left + width / 2, y: top + height / 2 };
    });
    await page.mouse.click(x + 3, y + 3);
    await expect.poll(() => looks(page, 'chosen')).toBe(4); // with their casings
    await page.waitForURL(/pixel=8(,|%2C)8/);
  });
});

describe('other runs', () => {
  it('are traces of the lessons and files', async () => {
    const { page, faults } = await comparing(
      browser,
      `${lesson}&with=09-usual-mistakes.warnock.double.printed.signs`,
    );
    expect((await names(page))[1]).toBe('Warnock · as printed · double');
    await page.keyboard.press('d');
    await page.locator('vidno-comparison').waitFor({ state: 'detached' });
    await page.keyboard.press('d');
    await page
      .locator('vidno-rival-choice select[name=lesson]')
      .selectOption('07-z-buffer-ael.zbuffer.double.corrected.signs');
    await page.locator('vidno-rival-choice button[name=open]').click();
    await compared(page);
    expect((await names(page))[1]).toBe('Z-buffer · corrected · double');
    expect(await page.locator('vidno-compared-run.other .note').textContent()).toMatch(/./u);
    await page.waitForURL(/with=07-z-buffer-ael/);
    expect(faults).toEqual([]);
  });

  it('are refused if they are not traces', async () => {
    const { page } = await open(browser, `#${lesson}&lang=en`);
    await page.locator('.title h2').getByText(/./u).waitFor();
    await page.keyboard.press('d');
    const file = { name: 'x.jsonl', mimeType: 'text/plain', buffer: Buffer.from('<b>no</b>\n') };
    await page.locator('vidno-rival-choice input').setInputFiles(file);
    await page.locator('vidno-notice [role=alert]', { hasText: 'x.jsonl' }).waitFor();
    expect(await page.locator('vidno-player').isVisible()).toBe(true);
    await page.keyboard.press('d');
    expect(await page.locator('vidno-rival-choice dialog').isVisible()).toBe(true);
  });
});

describe('before and after a drag', () => {
  it('the earlier run stays as it was, and the other follows the drag', async () => {
    const { page, faults } = await editing(browser);
    await page.locator(handle(1, 2)).focus();
    await rerun(page, () => page.keyboard.press('Shift+ArrowLeft'));
    await page.keyboard.press('End');
    await page.keyboard.press('d');
    await page.getByRole('button', { name: 'before the last change' }).click();
    await compared(page);
    expect(await page.locator('.note').textContent()).toBe('before the change');
    const last = await stepsOf(page);
    // A corner of the square moved from (7, 7) to (6, 7). The edge from (7, 2) then passes the centres of column 6 in rows
    // 2 to 4: x = 7 - (y - 2) / 5 > 6.5 while y < 4.5, closed at 4.5. Rows 5 and 6 lose theirs.
    expect(await differ(page).textContent()).toContain('2 at the end');
    await page.keyboard.press('e');
    await page.locator(handle(1, 2)).waitFor();
    const from = await spotOf(page, 6, 7);
    const to = await spotOf(page, 7, 7);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move((from.x + to.x) / 2, to.y);
    await page.mouse.move(to.x, to.y);
    await page.mouse.up();
    await expect.poll(() => differ(page).textContent()).toContain('0 at the end');
    expect((await stepsOf(page))[1]).toBe(last[1]);
    expect(await page.locator('.deed').textContent()).toContain('nowhere');
    await page.keyboard.press('Control+z');
    await expect.poll(() => differ(page).textContent()).toContain('2 at the end');
    expect(faults).toEqual([]);
  });

  it('a run by another kernel follows the drag, too', async () => {
    const { page } = await editing(browser);
    await page.keyboard.press('d');
    await page.getByRole('button', { name: 'the other method' }).click();
    await compared(page);
    await page.keyboard.press('e');
    await page.locator(handle(1, 2)).focus();
    await page.keyboard.press('Shift+ArrowLeft');
    const corner = (): Promise<unknown> =>
      page.evaluate(() => {
        const app = document.querySelector('vidno-app')?.shadowRoot;
        return app?.querySelector('vidno-comparison')?.rival?.header.scene.polygons[1]?.vertices[2];
      });
    await expect.poll(corner).toEqual([6, 7, 0.25]);
  });
});
