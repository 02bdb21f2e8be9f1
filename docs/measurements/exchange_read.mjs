// Reads one of our exports with a JavaScript library: node exchange_read.mjs MODULES LIBRARY FILE OUT. As exchange_read.py.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { join } from 'node:path';

const [modules, library, file, out] = process.argv.slice(2);
const require = createRequire(join(modules, 'package.json'));
const load = async (name) => {
  try { return require(name); } catch { return import(pathToFileURL(require.resolve(name)).href); }
};
const bytes = readFileSync(file);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const kind = file.split('.').pop();

// A row per point: x y z red green blue class, not a number where there is none.
function cloudOf(positions, colours, channels, full, classes) {
  const rows = new Float64Array(positions.length / 3 * 7).fill(NaN);
  for (let n = 0; n < positions.length / 3; ++n) {
    for (let c = 0; c < 3; ++c) {
      rows[7 * n + c] = positions[3 * n + c];
      if (colours) rows[7 * n + 3 + c] = colours[n * channels + c] * 255 / full;
    }
    if (classes) rows[7 * n + 6] = classes[n];
  }
  return rows;
}

async function three() {
  const name = { ply: 'PLYLoader', pcd: 'PCDLoader', obj: 'OBJLoader', xyz: 'XYZLoader' }[kind];
  const module = await import(pathToFileURL(join(modules, 'node_modules/three/examples/jsm/loaders', `${name}.js`)).href);
  const loader = new module[name]();
  let made = loader.parse(kind === 'obj' || kind === 'xyz' ? bytes.toString('utf8') : buffer);
  if (kind === 'obj') made.traverse((part) => { if (part.geometry) made = part; });
  const geometry = made.geometry ?? made;
  const colours = geometry.attributes.color;
  return cloudOf(geometry.attributes.position.array, colours?.array, colours?.itemSize, 1);
}

async function loadersGl() {
  const { parse } = await load('@loaders.gl/core');
  const module = await load(`@loaders.gl/${kind}`);
  const loader = module[{ ply: 'PLYLoader', pcd: 'PCDLoader', obj: 'OBJLoader', las: 'LASLoader', csv: 'CSVLoader' }[kind]];
  const read = await parse(kind === 'obj' || kind === 'csv' ? bytes.toString('utf8') : buffer, loader, { worker: false, csv: { header: true, shape: 'array-row-table' }, las: { fp64: true } });
  if (kind === 'csv') {
    const at = Object.keys(read.data[0]).length - 1; // class
    return cloudOf(read.data.flatMap((row) => row.slice(0, 3).map(Number)), null, 0, 0, read.data.map((row) => Number(row[at])));
  }
  const colours = read.attributes.COLOR_0 ?? read.attributes.COLOR;
  return cloudOf(read.attributes.POSITION.value, colours?.value, colours?.size, 255);
}

async function copc() {
  const { Las } = await load('copc');
  const header = Las.Header.parse(bytes);
  const view = Las.View.create(bytes.subarray(header.pointDataOffset, header.pointDataOffset + header.pointCount * header.pointDataRecordLength), header);
  const get = Object.fromEntries(['X', 'Y', 'Z'].map((name) => [name, view.getter(name)]));
  const colour = ['Red', 'Green', 'Blue'].every((name) => view.dimensions[name]) ? ['Red', 'Green', 'Blue'].map((name) => view.getter(name)) : null;
  const positions = [];
  const colours = [];
  for (let n = 0; n < view.pointCount; ++n) {
    positions.push(get.X(n), get.Y(n), get.Z(n));
    if (colour) colours.push(...colour.map((channel) => channel(n)));
  }
  const classes = Array.from({ length: view.pointCount }, (_, n) => Math.max(view.getter('Classification')(n) - 64, 0));
  return cloudOf(positions, colour ? colours : null, 3, 65535, classes);
}

async function mcap() {
  const { McapIndexedReader } = await load('@mcap/core');
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, size) => bytes.subarray(Number(offset), Number(offset) + Number(size)),
    },
  });
  let lines = 0;
  const topics = new Map([...reader.channelsById.values()].map((channel) => [channel.id, channel.topic]));
  for await (const message of reader.readMessages()) lines += topics.get(message.channelId) === '/lidar/cola_rx' ? 1 : 0;
  console.log(`${lines} telegrams`);
  return null;
}

try {
  const read = await { three, 'loaders.gl': loadersGl, copc, mcap }[library]();
  if (read) writeFileSync(out, Buffer.from(read.buffer));
} catch (problem) {
  console.log(String(problem.message ?? problem));
  process.exit(1);
}
