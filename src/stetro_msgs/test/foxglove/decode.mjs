// Copyright 2026 The sTetro Authors
//
// Licensed under the Apache License, Version 2.0 (the "License");
// you may not use this file except in compliance with the License.
// You may obtain a copy of the License at
//
//     http://www.apache.org/licenses/LICENSE-2.0
//
// Unless required by applicable law or agreed to in writing, software
// distributed under the License is distributed on an "AS IS" BASIS,
// WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
// See the License for the specific language governing permissions and
// limitations under the License.

// Reads the payloads that write_payloads wrote, as a ROS 2 tool reads them: with the definitions of
// a ROS 2 distribution, or the .msg files this package ships, and a decoder that shares no code
// with ours.
// usage: node decode.mjs PAYLOADS.json MSG_DIR DEFINITIONS_DIR

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join } from "node:path";
import test from "node:test";

import rosmsg from "@foxglove/rosmsg";
import common from "@foxglove/rosmsg-msgs-common";
import serialization from "@foxglove/rosmsg2-serialization";

const [payloadsFile, msgDir, definitionsDir] = process.argv.slice(2);
const samples = JSON.parse(readFileSync(payloadsFile, "utf8"));
const require = createRequire(import.meta.url);
const commonDir = join(dirname(require.resolve("@foxglove/rosmsg-msgs-common")), "..", "msgdefs");

/** "sensor_msgs::msg::dds_::Range_" is "sensor_msgs/Range" to ROS 2. */
function rosName(ddsType) {
  const parts = /^(\w+)::msg::dds_::(\w+)_$/.exec(ddsType);
  assert.ok(parts, `ROS 2 would not know the type ${ddsType}`);
  return `${parts[1]}/${parts[2]}`;
}

/** The .msg texts in a folder, by ROS name. */
function textsIn(folder, packageName) {
  const files = readdirSync(folder).filter((name) => name.endsWith(".msg"));
  return files.map((name) => [
    `${packageName}/${basename(name, ".msg")}`,
    readFileSync(join(folder, name), "utf8"),
  ]);
}

/** The names of the messages a message holds, itself first. */
function closure(root, texts, found = new Set()) {
  found.add(root);
  for (const line of texts.get(root).split("\n")) {
    const type = line.split(/[\s[<#]/)[0];
    const name = type.includes("/") ? type : `${dirname(root)}/${type}`;
    if (texts.has(name)) closure(name, texts, found);
  }
  return found;
}

/** One text with all definitions, the root's first: what a bag or a bridge hands to a reader. */
function schemaText(root, texts) {
  const [, ...others] = closure(root, texts);
  const sections = others.map((name) => `${"=".repeat(80)}\nMSG: ${name}\n${texts.get(name)}`);
  return [texts.get(root), ...sections].join("\n");
}

const standardPackages = ["std_msgs", "geometry_msgs"];

/** Definitions of one message that is not in the sets of a distribution. */
function shippedDefinitions(root, distribution) {
  const gid = distribution === "ros2humble" ? "humble" : "iron";
  const texts = new Map([
    ...textsIn(msgDir, "stetro_msgs"),
    ...textsIn(join(definitionsDir, "rmf_fleet_msgs"), "rmf_fleet_msgs"),
    ...textsIn(join(definitionsDir, "rmw_dds_common"), "rmw_dds_common"),
    ...textsIn(join(definitionsDir, gid), "rmw_dds_common"),
    ...standardPackages.flatMap((name) => textsIn(join(commonDir, distribution, name, "msg"), name)),
  ]);
  assert.ok(texts.has(root), `no definition of ${root}`);
  return rosmsg.parse(schemaText(root, texts), { ros2: true });
}

/** Definitions of one message of a distribution: itself first, then all it may hold. */
function standardDefinitions(root, set) {
  return [set[root], ...Object.values(set).filter((definition) => definition.name !== root)];
}

/** What was written as JSON, in the shape of what was decoded. */
function plain(value) {
  if (typeof value === "bigint") return String(value);
  if (typeof value === "number" && !Number.isFinite(value)) {
    return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
  }
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, plain);
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, plain(item)]));
  }
  return value;
}

function decode(definitions, payload) {
  const reader = new serialization.MessageReader(definitions);
  const value = plain(reader.readMessage(Buffer.from(payload, "hex")));
  return { value, rest: payload.length / 2 - reader.lastReadByteLength() };
}

function check(sample, distribution) {
  const name = rosName(sample.dds_type);
  const set = common[distribution];
  const expected = structuredClone(sample.value);
  let restExpected = 0;
  if (name === "sensor_msgs/Range" && distribution === "ros2humble") {
    delete expected.variance; // Humble does not know it and leaves its four bytes alone
    restExpected = 4;
  }
  const definitions =
    name in set ? standardDefinitions(name, set) : shippedDefinitions(name, distribution);
  const { value, rest } = decode(definitions, sample.payload);
  assert.deepEqual(value, expected);
  assert.equal(rest, restExpected, "bytes left behind the message");
}

const onlyIn = { Humble: "ros2humble", Iron: "ros2jazzy" };

for (const distribution of ["ros2humble", "ros2jazzy"]) {
  for (const sample of samples) {
    const prefix = /^(Humble|Iron)/.exec(sample.file);
    if (prefix && onlyIn[prefix[1]] !== distribution) continue;
    test(`${distribution} reads ${sample.file}`, () => check(sample, distribution));
  }
}

test("every shipped definition was used", () => {
  const used = new Set(samples.map((sample) => rosName(sample.dds_type)));
  for (const [name] of textsIn(msgDir, "stetro_msgs")) assert.ok(used.has(name), name);
});
