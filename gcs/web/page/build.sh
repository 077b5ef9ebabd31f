#!/bin/sh
# Builds the page: gcs/web/page → gcs/web/built, with three.js and uPlot inside. For maintainers; needs node, npm and the
# network once. Users need none of it: what is built is committed.
#   gcs/web/page/build.sh [FOLDER FOR node_modules]
set -eu
page=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$page/../../.." && pwd)
tools=${1:-"$root/.venv/page-tools"}
built="$page/../built"
mkdir -p "$tools" "$built"
cp "$page/package.json" "$tools/"
[ -d "$tools/node_modules/esbuild" ] || (cd "$tools" && npm install --silent --no-audit --no-fund)
bin="$tools/node_modules/.bin"
node "$page/types.mjs" "$root/gcs/schemas/messages.schema.json" "$page/messages.d.ts"
ln -sfn "$tools/node_modules" "$page/node_modules"
trap 'rm -f "$page/node_modules"' EXIT
"$bin/tsc" -p "$page/tsconfig.json"
sources=$(cat "$page"/*.js "$page/page.css" | sha256sum | cut -c1-16)
"$bin/esbuild" "$page/main.js" --banner:js="/* of sources $sources */" --bundle --minify --format=iife --target=es2022 --charset=utf8 --legal-comments=none \
  --outfile="$built/page.js"
cat "$tools/node_modules/uplot/dist/uPlot.min.css" "$page/page.css" | "$bin/esbuild" --loader=css --minify --charset=utf8 > "$built/page.css"
{
  for name in three uplot; do
    version=$(node -p "require('$tools/node_modules/$name/package.json').version")
    printf '%s %s, https://www.npmjs.com/package/%s\n\n' "$name" "$version" "$name"
    cat "$tools/node_modules/$name/LICENSE"
    printf '\n\n'
  done
} > "$built/LICENSES.txt"
wc -c "$built"/*
