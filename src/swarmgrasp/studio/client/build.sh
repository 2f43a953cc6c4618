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
cp index.html "$page/"
for font in fonts/*.woff2; do
  if [ -e "$font" ]; then cp "$font" "$page/"; fi
done
