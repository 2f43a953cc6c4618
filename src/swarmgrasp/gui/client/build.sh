#!/bin/sh
# The page from its sources, into the folder that is named, or the one that the package ships.
set -eu
cd "$(dirname "$0")"
page=${1:-../page}
mkdir -p "$page"
rm -f "$page"/*
node_modules/.bin/esbuild src/boot.ts --bundle --minify --format=esm --target=es2022 \
  --legal-comments=none --log-level=warning --outfile="$page/main.js"
node_modules/.bin/esbuild src/page.css --bundle --minify --target=es2022 \
  --legal-comments=none --log-level=warning --external:*.woff2 --outfile="$page/page.css"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
node_modules/.bin/esbuild src/studio.css --bundle --minify --target=es2022 \
  --legal-comments=none --log-level=warning --outfile="$work/studio.css"
node_modules/.bin/esbuild src/widget.ts --bundle --minify --format=esm --target=es2022 \
  --legal-comments=none --log-level=warning --alias:styles="$work/studio.css" \
  --loader:.css=text --loader:.woff2=binary --outfile="$page/widget.js"
cp index.html "$page/"
cp fonts/*.woff2 fonts/OFL.txt "$page/"
