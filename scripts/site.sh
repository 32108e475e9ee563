#!/usr/bin/env bash
# Builds the site of the documents as static HTML in BUILD/docs/html, without the network; every warning is an error.
# The program and the Python module have to be there: their numbers and pictures are made anew.
# usage: site.sh [BUILD]
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath "${1:-build}")
site=$build/docs
python=$build/python/venv/bin/python
[ -x "$build/bin/lober" ] && [ -x "$python" ] || { echo "no program or no Python module in $build; make docs builds them" >&2; exit 1; }
mkdir -p "$site/static"

# The headers.
(cat docs/site/Doxyfile; echo "OUTPUT_DIRECTORY = $site/doxygen"; echo "WARN_AS_ERROR = ${LOBER_DOXYGEN_ERRORS:-FAIL_ON_WARNINGS}") |
  { rm -rf "$site/doxygen"; mkdir -p "$site/doxygen"; doxygen -; } || { echo "the headers have symbols without a comment" >&2; exit 1; }

# MathJax, the part that turns TeX into SVG.
mathjax=/usr/share/javascript/mathjax
for part in MathJax.js config/TeX-AMS_SVG.js extensions jax/input/TeX jax/element jax/output/SVG/jax.js jax/output/SVG/autoload \
  jax/output/SVG/config.js jax/output/SVG/fonts/TeX jax/output/PreviewHTML; do
  mkdir -p "$site/static/mathjax/$(dirname "$part")"
  cp -rLu "$mathjax/$part" "$site/static/mathjax/$(dirname "$part")/"
done

"$python" docs/site/stage.py "$build" "$site/source"
rm -rf "$site/html" "$site/doctrees"
LOBER_SOURCE=$PWD LOBER_SITE_STATIC=$site/static \
  "$python" -m sphinx -W --keep-going -q -c docs/site -d "$site/doctrees" "$site/source" "$site/html"

# Debian's furo expects a web server that has /javascript, and a bundler; here its parts become files that a browser
# opens from a disk.
static=$site/html/_static
cp -L /usr/share/javascript/normalize.css/normalize.css "$static/styles/"
sed -i 's|@import url(/javascript/normalize.css/normalize.css)|@import url(normalize.css)|' "$static/styles/furo.css"
{ cat "$static/scripts/gumshoe-patched.js"; sed 's|^import Gumshoe from .*||' "$static/scripts/furo.js"; } >"$static/scripts/bundled.js"
mv "$static/scripts/bundled.js" "$static/scripts/furo.js"

# Nothing is loaded from elsewhere, neither from the network nor from a server's own folders.
elsewhere='(https?:)?//|/[a-z]'
loaded=$(
  grep -rlE --include='*.html' "<(script|img|iframe|source|object)[^>]* (src|data)=\"($elsewhere)|<link [^>]*rel=\"(stylesheet|icon|preload|manifest)\"[^>]*href=\"($elsewhere)" "$site/html"
  grep -rlE --include='*.css' "@import (url\()?[\"']?($elsewhere)|url\([\"']?($elsewhere)" "$site/html"
  grep -lE '^import |\bimport\(' "$static"/*.js "$static"/scripts/*.js
) || true
[ -z "$loaded" ] || { echo "files that load something from elsewhere:" >&2; echo "$loaded" >&2; exit 1; }
echo "$(find "$site/html" -name '*.html' | wc -l) pages in $site/html; begin with index.html"
