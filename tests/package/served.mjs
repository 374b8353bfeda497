// The player in a fresh Vite project, and the page as it was unpacked, in Chromium and Firefox: below the root of a web server that sends
// the policy that the package's README states, and the page from disk, too.
//
//     node served.mjs FOLDER-OF-PACKAGES TRACE
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [packages, trace] = process.argv.slice(2).map((path) => resolve(path));
const viewer = fileURLToPath(new URL('../../viewer_web/', import.meta.url));
const require = createRequire(join(viewer, 'package.json'));
const { chromium } = require('playwright-core');
const puppeteer = require('puppeteer-core');
const work = mkdtempSync(join(tmpdir(), 'vidno-served-'));

const packed = (pattern) => join(packages, readdirSync(packages).find((name) => pattern.test(name)));
const run = (directory, command, ...args) => execFileSync(command, args, { cwd: directory, stdio: ['ignore', 'ignore', 'inherit'] });

/** The policy in a README: the line of its block of code. */
const policyIn = (readme) => /^(?:Content-Security-Policy: )?(default-src .*)$/mu.exec(readFileSync(readme, 'utf8'))[1];

/** A project that uses the package as its README says, and what Vite builds of it. */
function project() {
  const folder = join(work, 'project');
  mkdirSync(join(folder, 'public'), { recursive: true });
  writeFileSync(join(folder, 'package.json'), '{ "type": "module", "private": true }');
  writeFileSync(
    join(folder, 'index.html'),
    `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Course</title>
     <script type="module" src="/main.ts"></script></head>
     <body><vidno-player src="run.jsonl" step="40" controls="small" lang="en"></vidno-player></body></html>`,
  );
  writeFileSync(
    join(folder, 'main.ts'),
    `import 'vidno-player';
     const player = document.querySelector('vidno-player');
     player?.addEventListener('vidno-step', () => (document.title = String(player.step)));`,
  );
  cpSync(trace, join(folder, 'public', 'run.jsonl'));
  run(folder, 'npm', 'install', '--offline', '--no-audit', '--no-fund', '--silent', packed(/^vidno-player-.*\.tgz$/u));
  const bin = join(viewer, 'node_modules', '.bin');
  run(folder, join(bin, 'tsc'), '--noEmit', '--strict', '--module', 'esnext', '--moduleResolution', 'bundler', '--target', 'es2022', 'main.ts');
  run(folder, join(bin, 'vite'), 'build', '--base', './', '--logLevel', 'error');
  return { site: join(folder, 'dist'), policy: policyIn(join(folder, 'node_modules', 'vidno-player', 'README.md')) };
}

function page() {
  run(work, 'unzip', '-q', packed(/^vidno-page-.*\.zip$/u));
  const site = join(work, readdirSync(work).find((name) => name.startsWith('vidno-page-')));
  return { site, policy: policyIn(join(site, 'README.md')) };
}

const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css' };

/** A server of the sites below /course/NAME/, each with its policy. */
async function serve(sites) {
  const server = createServer((request, response) => {
    const [, course, name, ...rest] = new URL(request.url, 'http://x').pathname.split('/');
    const site = course === 'course' ? sites[name] : undefined;
    try {
      const file = normalize(join(site.site, rest.join('/') || 'index.html'));
      assert(file.startsWith(site.site));
      const bytes = readFileSync(file);
      response.writeHead(200, {
        'Content-Type': types[extname(file)] ?? 'application/octet-stream',
        'Content-Security-Policy': site.policy,
      });
      response.end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  return { server, address: `http://127.0.0.1:${server.address().port}/course` };
}

const browsers = {
  Chromium: () =>
    chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--headless=new', '--no-sandbox', '--disable-gpu'] }),
  Firefox: () =>
    puppeteer.launch({ browser: 'firefox', executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr', headless: true }),
};

/** Opens the address, waits until a player shows a whole trace, and returns its step, its sentence and the browser's complaints. */
async function shown(browser, address) {
  const page = await browser.newPage();
  const faults = [];
  // A browser asks a server for an icon of its own accord.
  const note = (text, place = '') => /favicon/u.test(text + place) || faults.push(text);
  page.on('pageerror', (error) => note(String(error)));
  page.on('console', (message) => {
    if (['error', 'warn', 'warning'].includes(message.type())) note(message.text(), message.location()?.url);
  });
  await page.goto(address);
  await page.waitForFunction(() => {
    const player = document.querySelector('vidno-player') ?? document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
    return player?.trace?.complete === true && player.shadowRoot.querySelector('.sentence')?.textContent.trim() !== '';
  });
  const state = await page.evaluate(() => {
    const player = document.querySelector('vidno-player') ?? document.querySelector('vidno-app').shadowRoot.querySelector('vidno-player');
    return { step: player.step, length: player.length, sentence: player.shadowRoot.querySelector('.sentence').textContent.replace(/\s+/gu, ' ').trim() };
  });
  await page.close();
  return { ...state, faults };
}

let server;
try {
  const sites = { player: project(), page: page() };
  const served = await serve(sites);
  server = served.server;
  const events = readFileSync(trace, 'utf8').trimEnd().split('\n').length - 2;
  for (const [name, launch] of Object.entries(browsers)) {
    const browser = await launch();
    try {
      const player = await shown(browser, `${served.address}/player/`);
      assert.deepEqual([player.step, player.length, player.faults], [40, events, []], name);
      console.log(`  ${name}, the player in a Vite project: ${player.sentence}`);
      for (const address of [`${served.address}/page/`, pathToFileURL(join(sites.page.site, 'index.html')).href]) {
        const page = await shown(browser, `${address}#lang=en`);
        assert(page.length > 100, name);
        assert.deepEqual([page.step, page.faults], [page.length, []], name);
        console.log(`  ${name}, the page at ${address.replace(/:\d+/u, '').replace(work, '')}: ${page.length} steps`);
      }
    } finally {
      await browser.close();
    }
  }
  console.log('== The player and the page work under the policies that their READMEs state');
} finally {
  server?.close();
  rmSync(work, { recursive: true });
}
