#!/usr/bin/env bash
# Runs the tests in which other projects use lober, those that `make test` leaves out too (tests/CMakeLists.txt).
# usage: run-consumers.sh BUILD
set -euo pipefail
ctest --test-dir "$1" -C consumers -L consumers --output-on-failure --no-tests=error
