import { readFileSync } from 'node:fs' // reads a PNG or a binary PPM with 8 bits each of red, green and blue: for verify.mjs
import { inflateSync } from 'node:zlib'
const nearest = (to, ...values) => values.reduce((best, each) => (Math.abs(to - each) < Math.abs(to - best) ? each : best))
const predictions = [ // by the kind of a row, a byte from those of the pixels at its left, above it, and above the left one
  () => 0,
  left => left,
  (_, above) => above,
  (left, above) => (left + above) >> 1,
  (left, above, corner) => nearest(left + above - corner, left, above, corner),
]
function pngRows(picture, width, height) {
  const data = []
  let isRgb = true
  for (let at = 8; at < picture.length; at += picture.readUInt32BE(at) + 12) {
    const kind = picture.toString('latin1', at + 4, at + 8), chunk = picture.subarray(at + 8, at + 8 + picture.readUInt32BE(at))
    if (kind === 'IHDR') isRgb &&= chunk.readUInt32BE(0) === width && chunk.toString('hex', 8) === '0802000000'
    if (kind === 'tRNS') isRgb = false
    if (kind === 'IDAT') data.push(chunk)
  }
  const packed = isRgb ? inflateSync(Buffer.concat(data)) : [], rows = Buffer.alloc(isRgb ? 3 * width * height : 0)
  for (let i = 0; i < rows.length; ++i) {
    const row = Math.floor(i / (3 * width)), isFirst = i % (3 * width) < 3
    const left = isFirst ? 0 : rows[i - 3], above = rows[i - 3 * width] ?? 0, corner = isFirst ? 0 : (rows[i - 3 * width - 3] ?? 0)
    rows[i] = packed[i + row + 1] + predictions[packed[row * (3 * width + 1)]](left, above, corner)
  }
  return rows
}
/** The bytes of the pixels, row by row, of a picture of this size; none if it is another picture. */
export function readPicture(file, width, height) {
  const picture = readFileSync(file), ppm = Buffer.from(`P6\n${width} ${height}\n255\n`)
  if (picture.toString('latin1', 0, 8) === '\x89PNG\r\n\x1a\n') return pngRows(picture, width, height)
  return picture.indexOf(ppm) === 0 ? picture.subarray(ppm.length) : Buffer.alloc(0)
}
