// Runs verify.mjs many times in one process: a line of standard input has its arguments, a line of standard output its exit status and
// what it printed.
import { readFileSync } from 'node:fs'
import { createInterface } from 'node:readline'
import { pathToFileURL } from 'node:url'

const source = readFileSync(process.argv[2], 'utf8').replaceAll(/^import .*$/gm, '')
const { readPicture } = await import(new URL('read_picture.mjs', pathToFileURL(process.argv[2])))
const checker = new Function('readFileSync', 'readPicture', 'process', 'console', source)

class Exit extends Error {}

for await (const line of createInterface({ input: process.stdin })) {
  const said = []
  const print = text => said.push(text)
  let status = 0
  try {
    const exit = code => {
      status = code
      throw new Exit()
    }
    const given = { argv: ['node', 'verify.mjs', ...line.split('\t')], exit }
    checker(readFileSync, readPicture, given, { log: print, error: print })
  } catch (error) {
    if (!(error instanceof Exit)) {
      status = 1
      said.push(String(error))
    }
  }
  console.log(`${status}\t${said.join(' ').replaceAll('\n', ' ')}`)
}
