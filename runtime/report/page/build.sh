#!/usr/bin/env bash
# Makes ../page.html of this folder, with Node and npm, in a folder of its own: ./dev report
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$here"/{package.json,package-lock.json,build.mjs,src} "$work"
cd "$work"
npm ci --no-fund --no-audit --loglevel=error
node build.mjs "$here/../page.html"
