#!/usr/bin/env bash
# Exports every scene in assets and checks each .glb with Khronos' validator (npm gltf-validator), which must report no
# errors: tests/gltf_validator.sh GLINT. Installs the validator into a temporary folder, so it needs the network.
set -eu
glint=$(realpath "$1")
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm install --silent gltf-validator@2.0.0-dev.3.10
for scene in "$root"/assets/scenes/*.json "$root"/docs/museum.json; do
    "$glint" export "$scene" -o "$(basename "$scene" .json).glb" 2>>warnings.txt
done
cat >check.js <<'JS'
const fs = require('fs'), validator = require('gltf-validator');
const files = fs.readdirSync('.').filter((name) => name.endsWith('.glb'));
Promise.all(files.map(async (name) => {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(name)));
    const bad = report.issues.messages.filter((message) => message.severity < 2);  // errors and warnings
    for (const message of bad) console.log(`${name}: ${message.pointer}: ${message.message}`);
    return bad.length;
})).then((counts) => {
    const bad = counts.filter((count) => count > 0).length;
    console.log(`${files.length - bad} of ${files.length} exported files are valid`);
    process.exit(bad > 0 || files.length === 0 ? 1 : 0);
});
JS
node check.js
