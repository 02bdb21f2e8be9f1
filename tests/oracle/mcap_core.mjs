// Reads recordings with @mcap/core, CRCs on, and lists them: node mcap_core.mjs FILE.mcap [FILE.mcap ...]
// Needs `npm i @mcap/core` in a folder named by MCAP_CORE (default: the current one). Exit 1 when a file is not sound.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";

const require = createRequire(resolve(process.env.MCAP_CORE ?? ".", "package.json"));
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");

/** Front to back, as a reader does that trusts no index. */
function streamed(bytes) {
  const reader = new McapStreamReader({ validateCrcs: true, includeChunks: true });
  const topics = new Map();
  const counts = {};
  let [chunks, footer] = [0, false];
  reader.append(bytes);
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Chunk") ++chunks;
    if (record.type === "Footer") footer = true;
    if (record.type === "Channel") topics.set(record.id, record.topic);
    if (record.type === "Message") counts[topics.get(record.channelId)] = (counts[topics.get(record.channelId)] ?? 0) + 1;
  }
  return { counts, chunks, footer, whole: reader.done() };
}

/** By the index at the end. */
async function indexed(bytes) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
  };
  const reader = await McapIndexedReader.Initialize({ readable });
  const counts = {};
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const topic = reader.channelsById.get(message.channelId).topic;
    counts[topic] = (counts[topic] ?? 0) + 1;
  }
  const metadata = {};
  for await (const record of reader.readMetadata()) metadata[record.name] = Object.fromEntries(record.metadata);
  return { library: reader.header.library, counts, stated: Number(reader.statistics.messageCount), metadata };
}

let sound = true;
for (const file of process.argv.slice(2)) {
  const bytes = new Uint8Array(readFileSync(file));
  try {
    const stream = streamed(bytes);
    const index = stream.footer ? await indexed(bytes) : undefined;
    const sum = Object.values(stream.counts).reduce((a, b) => a + b, 0);
    const same = !index || (JSON.stringify(Object.entries(stream.counts).sort()) === JSON.stringify(Object.entries(index.counts).sort()) && index.stated === sum);
    if (!same) sound = false;
    console.log(JSON.stringify({ file, messages: sum, topics: stream.counts, chunks: stream.chunks, crc: "ok", closed: stream.whole,
                                 index: index ? (same ? "ok" : "differs") : "none", library: index?.library, metadata: index ? Object.keys(index.metadata) : [] }));
  } catch (error) {
    sound = false;
    console.log(JSON.stringify({ file, error: String(error.message) }));
  }
}
process.exit(sound ? 0 : 1);
