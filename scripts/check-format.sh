#!/usr/bin/env bash
# Fails unless clang-format leaves every file of ours as it is.
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror
