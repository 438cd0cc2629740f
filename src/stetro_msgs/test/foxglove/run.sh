#!/bin/sh
# Copyright 2026 The sTetro Authors
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.

# Decodes our payloads with Foxglove's reader. Fails when npm or node is missing.
# usage: run.sh PACKAGE_DIR SCRATCH_DIR WRITE_PAYLOADS
set -eu

package_dir=$1
scratch=$2
write_payloads=$3

mkdir -p "$scratch"
cp "$package_dir"/test/foxglove/package.json "$package_dir"/test/foxglove/package-lock.json \
  "$package_dir"/test/foxglove/decode.mjs "$scratch"
"$write_payloads" "$scratch/payloads.json"
cd "$scratch"
if ! cmp -s package-lock.json installed-lock.json; then
  npm ci --no-audit --no-fund --loglevel=error
  cp package-lock.json installed-lock.json
fi
node decode.mjs payloads.json "$package_dir/msg" "$package_dir/test/foxglove/definitions"
