// Reads what a browser's screenshots are: PNG of 8 bits a channel, RGB or RGBA, not interlaced.
import { inflateSync } from "node:zlib";

export function readPng(file) {
  const width = file.readUInt32BE(16), height = file.readUInt32BE(20), channels = { 2: 3, 6: 4 }[file[25]];
  if (file[24] !== 8 || !channels || file[28] !== 0) throw new Error("not a PNG as screenshots are");
  const parts = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    if (file.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
  }
  const raw = inflateSync(Buffer.concat(parts)), stride = width * channels, pixels = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let i = 0; i < stride; ++i) {
      const left = i < channels ? 0 : pixels[y * stride + i - channels];
      const up = y === 0 ? 0 : pixels[(y - 1) * stride + i];
      const corner = i < channels || y === 0 ? 0 : pixels[(y - 1) * stride + i - channels];
      const guess = filter === 0 ? 0 : filter === 1 ? left : filter === 2 ? up : filter === 3 ? (left + up) >> 1 : paeth(left, up, corner);
      pixels[y * stride + i] = raw[y * (stride + 1) + 1 + i] + guess;
    }
  }
  return { width, height, channels, pixels };
}

function paeth(left, up, corner) {
  const p = left + up - corner;
  const a = Math.abs(p - left), b = Math.abs(p - up), c = Math.abs(p - corner);
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

/// Share of the pixels of two pictures of one size that differ by more than a shade.
export function difference(one, other) {
  if (one.width !== other.width || one.height !== other.height || one.channels !== other.channels) throw new Error("pictures of two kinds");
  let count = 0;
  for (let i = 0; i < one.pixels.length; i += one.channels) {
    const differs = (k) => Math.abs(one.pixels[i + k] - other.pixels[i + k]) > 6;
    count += differs(0) || differs(1) || differs(2);
  }
  return count / (one.width * one.height);
}
