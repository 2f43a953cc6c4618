#!/bin/sh
# What the client works out by itself, tried in Node.
set -eu
cd "$(dirname "$0")/.."
bundles=$(mktemp -d)
trap 'rm -rf "$bundles"' EXIT
node_modules/.bin/esbuild tests/*.test.ts --bundle --platform=node --format=esm --target=node18 \
  --out-extension:.js=.mjs --log-level=warning --outdir="$bundles"
node --test "$bundles"
