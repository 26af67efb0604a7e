// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// node record.js EVERY INPUT OUTPUT
//
// Decodes the Velodyne packets in INPUT (a rawlog or a pcap, gzipped or not) with
// @foxglove/velodyne-cloud, found beside the current folder, and writes to OUTPUT (CSV, gzipped
// where it ends in .gz): what each laser returned, and every EVERY-th point.
"use strict";
const fs = require("fs");
const zlib = require("zlib");
const { createRequire } = require("module");
const { Calibration, PointCloud, RawPacket, Transformer } = createRequire(
  process.cwd() + "/package.json",
)("@foxglove/velodyne-cloud");

const kPacketBytes = 1206;

function isPacketAt(bytes, at) {
  for (let block = 0; block < 12; block++) {
    if (bytes[at + 100 * block] !== 0xff || bytes[at + 100 * block + 1] !== 0xee) return false;
  }
  return bytes[at + 1204] >= 0x37 && bytes[at + 1204] <= 0x39;
}

// The payloads, wherever they stand in the file.
function packetsIn(file) {
  let bytes = fs.readFileSync(file);
  if (bytes[0] === 0x1f && bytes[1] === 0x8b) bytes = zlib.gunzipSync(bytes);
  const packets = [];
  for (let at = 0; at + kPacketBytes <= bytes.length; ) {
    if (isPacketAt(bytes, at)) {
      packets.push(new RawPacket(new Uint8Array(bytes.subarray(at, at + kPacketBytes))));
      at += kPacketBytes;
    } else {
      at++;
    }
  }
  return packets;
}

function decode(packets) {
  // No limits: the package's own would drop what is nearer than 0.4 m. 0 is no return.
  const limits = { minRange: 1e-6, maxRange: Infinity };
  const transformer = new Transformer(new Calibration(packets[0].inferModel()), limits);
  const cloud = new PointCloud({ stamp: 0, maxPoints: packets.length * 384 });
  const start = packets[0].gpsTimestamp;
  for (const packet of packets) {
    transformer.unpack(packet, 0, (packet.gpsTimestamp - start) * 1e-6, cloud);
  }
  return cloud;
}

function totals(cloud) {
  const lasers = [];
  for (let i = 0; i < cloud.width; i++) {
    const p = cloud.point(i);
    lasers[p.ring] ??= { count: 0, distance: 0, z: 0, intensity: 0 };
    lasers[p.ring].count++;
    lasers[p.ring].distance += p.distance;
    lasers[p.ring].z += p.z;
    lasers[p.ring].intensity += p.intensity;
  }
  return lasers;
}

const [every, input, output] = process.argv.slice(2);
const cloud = decode(packetsIn(input));
const lines = ["laser,count,sum_distance_m,sum_z_m,sum_intensity"];
totals(cloud).forEach((t, laser) =>
  lines.push([laser, t.count, t.distance.toFixed(3), t.z.toFixed(3), t.intensity].join(",")),
);
lines.push("index,x_m,y_m,z_m,intensity,laser,azimuth_hundredths,time_ns");
for (let i = 0; i < cloud.width; i += Number(every)) {
  const p = cloud.point(i);
  const xyz = [p.x, p.y, p.z].map((v) => v.toFixed(4));
  lines.push([i, ...xyz, p.intensity, p.ring, p.azimuth, p.deltaNs].join(","));
}
const text = lines.join("\n") + "\n";
fs.writeFileSync(output, output.endsWith(".gz") ? zlib.gzipSync(text, { level: 9 }) : text);
