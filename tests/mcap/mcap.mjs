// Writes and reads MCAP files with the format's own library, @mcap/core. The arguments and the printed JSON are
// those of benchmarks/mcap.cpp; `indexed FILE` reads by the index of the file instead of from front to back.
// `values FILE` prints {topic: {type, encoding, messages: [[time in ns, message]]}}, with every message decoded by the
// schema in the file.

import { open } from "node:fs/promises";
import { McapIndexedReader, McapStreamReader, McapWriter } from "@mcap/core";
import { crc32Final, crc32Init, crc32Update } from "@foxglove/crc";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import decompressLz4 from "@foxglove/wasm-lz4";
import zstd from "@foxglove/wasm-zstd";
import lz4 from "lz4js";

await Promise.all([decompressLz4.isLoaded, zstd.isLoaded]);

const DEFINITION = "float64[] data\n";
const PIECE = 1 << 20; // bytes that are read at once

const compressions = {
  none: undefined,
  lz4: (bytes) => ({ compression: "lz4", compressedData: new Uint8Array(lz4.compress(bytes)) }),
  zstd: (bytes) => ({ compression: "zstd", compressedData: new Uint8Array(zstd.compress(bytes)) }),
};

const decompressHandlers = {
  lz4: (bytes, size) => decompressLz4(bytes, Number(size)),
  zstd: (bytes, size) => zstd.decompress(bytes, Number(size)),
};

class File {
  #position = 0n;
  constructor(handle) {
    this.handle = handle;
  }
  position() {
    return this.#position;
  }
  async write(bytes) {
    await this.handle.write(bytes);
    this.#position += BigInt(bytes.byteLength);
  }
  async size() {
    return BigInt((await this.handle.stat()).size);
  }
  async read(offset, length) {
    const bytes = new Uint8Array(Number(length));
    await this.handle.read(bytes, 0, bytes.byteLength, Number(offset));
    return bytes;
  }
}

async function write(path, compression, messages, numbers) {
  const handle = await open(path, "w");
  const writer = new McapWriter({ writable: new File(handle), compressChunk: compressions[compression] });
  await writer.start({ profile: "ros2", library: "mcap.mjs" });
  const schemaId = await writer.registerSchema({
    name: "test_msgs/msg/Numbers",
    encoding: "ros2msg",
    data: new TextEncoder().encode(DEFINITION),
  });
  const states = { topic: "/states", messageEncoding: "cdr", schemaId, metadata: new Map([["qos", "reliable"]]) };
  const events = { topic: "/events", messageEncoding: "json", schemaId: 0, metadata: new Map() };
  const channels = [await writer.registerChannel(states), await writer.registerChannel(events)];
  const sequence = [0, 0];
  for (let n = 0; n < messages; ++n) {
    const logTime = 1_700_000_000_000_000_000n + BigInt(n) * 2_000_000n;
    const event = n % 10 === 9 ? 1 : 0;
    const data = event ? new TextEncoder().encode(`{"event":${n}}`) : new Uint8Array(12 + 8 * numbers);
    if (!event) {
      const view = new DataView(data.buffer);
      view.setUint8(1, 1); // little-endian CDR
      view.setUint32(4, numbers, true);
      for (let k = 0; k < numbers; ++k) view.setFloat64(12 + 8 * k, Math.sin(1e-3 * n + k), true);
    }
    const channelId = channels[event];
    await writer.addMessage({ channelId, sequence: sequence[event]++, logTime, publishTime: logTime, data });
  }
  await writer.addMetadata({ name: "about", metadata: new Map([["robot", "none"]]) });
  await writer.addAttachment({
    name: "notes.txt",
    mediaType: "text/plain",
    logTime: 0n,
    createTime: 0n,
    data: new Uint8Array(1000),
  });
  await writer.end();
  await handle.close();
}

class Counter {
  schemas = new Map();
  topics = new Map(); // by the number of the channel
  constructor(withCrc) {
    this.withCrc = withCrc;
  }
  take(record) {
    if (record.type === "Message") this.#count(record);
    else if (record.type === "Schema") this.schemas.set(record.id, record);
    else if (record.type === "Channel" && !this.topics.has(record.id))
      this.topics.set(record.id, { channel: record, messages: 0, bytes: 0, crc: crc32Init() });
  }
  #count(message) {
    const topic = this.topics.get(message.channelId);
    topic.messages += 1;
    topic.bytes += message.data.byteLength;
    if (!this.withCrc) return;
    const time = new Uint8Array(8);
    new DataView(time.buffer).setBigUint64(0, message.logTime, true);
    topic.crc = crc32Update(crc32Update(topic.crc, time), message.data);
  }
  print() {
    const found = [...this.topics.values()].map(({ channel, messages, bytes, crc }) => {
      const schema = this.schemas.get(channel.schemaId);
      return {
        name: channel.topic,
        type: schema?.name ?? "",
        encoding: channel.messageEncoding,
        schema: new TextDecoder().decode(schema?.data ?? new Uint8Array()).split("\n")[0],
        schema_encoding: schema?.encoding ?? "",
        messages,
        bytes,
        crc: this.withCrc ? crc32Final(crc) : 0,
      };
    });
    console.log(JSON.stringify(found));
  }
}

async function read(path, withCrc) {
  const handle = await open(path);
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  const counter = new Counter(withCrc);
  const piece = new Uint8Array(PIECE);
  for (;;) {
    const { bytesRead } = await handle.read(piece, 0, PIECE);
    if (bytesRead === 0) break;
    reader.append(piece.subarray(0, bytesRead));
    for (let record; (record = reader.nextRecord()); ) counter.take(record);
  }
  if (!reader.done()) throw new Error("the file is unfinished");
  counter.print();
}

async function readIndexed(path) {
  const reader = await McapIndexedReader.Initialize({ readable: new File(await open(path)), decompressHandlers });
  const counter = new Counter(true);
  for (const schema of reader.schemasById.values()) counter.take(schema);
  for (const channel of reader.channelsById.values()) counter.take(channel);
  for await (const message of reader.readMessages()) counter.take(message);
  const counted = [...counter.topics.values()].reduce((sum, topic) => sum + topic.messages, 0);
  if (Number(reader.statistics.messageCount) !== counted) throw new Error("the Statistics are wrong");
  if (reader.statistics.chunkCount !== reader.chunkIndexes.length) throw new Error("the chunks are not all indexed");
  counter.print();
}

async function readValues(path) {
  const reader = await McapIndexedReader.Initialize({ readable: new File(await open(path)), decompressHandlers });
  const topics = {};
  const decoders = new Map(); // by the number of the channel
  for (const { id, topic, schemaId, messageEncoding } of reader.channelsById.values()) {
    const schema = reader.schemasById.get(schemaId);
    decoders.set(id, new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true })));
    topics[topic] = { type: schema.name, encoding: `${messageEncoding} ${schema.encoding}`, messages: [] };
  }
  for await (const { channelId, logTime, data } of reader.readMessages()) {
    const { topic } = reader.channelsById.get(channelId);
    topics[topic].messages.push([Number(logTime), decoders.get(channelId).readMessage(data)]);
  }
  const text = JSON.stringify(topics, (_, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value));
  await new Promise((done) => process.stdout.write(text + "\n", done)); // all of it, before the program exits
}

const [what, path, compression, messages, numbers] = process.argv.slice(2);
if (what === "write") await write(path, compression, Number(messages), Number(numbers));
else if (what === "indexed") await readIndexed(path);
else if (what === "values") await readValues(path);
else await read(path, what === "check");
process.exit(0);
