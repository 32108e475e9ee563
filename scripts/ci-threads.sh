#!/usr/bin/env bash
# Builds with ThreadSanitizer what is named and runs the tests there.
# usage: ci-threads.sh TARGET...
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/ci-build.sh tsan "$@"
scripts/ci-sanitized.sh build-tsan
