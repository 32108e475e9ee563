#!/usr/bin/env bash
# A million random pairs, with seeds that no run before has used, against the exact oracle, and ten times the tangles and
# winding regions of the tests, transport of a hundred random maps; then a fiftieth as many pairs under every transformation
# of tests/stress, which ends with how often the error bars hold and how loose they are; then the scenes of the benchmark
# with every number of threads, index and instruction set; then batches that are killed.
# usage: stress.sh [PAIRS [SEED]]      pairs that fail are written to build/failures
set -euo pipefail
cd "$(dirname "$0")/.."
export LOBER_RANDOM_PAIRS=${1:-1000000}
export LOBER_RANDOM_TANGLES=$(((LOBER_RANDOM_PAIRS + 249) / 250))
export LOBER_RANDOM_REGIONS=$(((LOBER_RANDOM_PAIRS + 7) / 8))
export LOBER_STABILITY_PAIRS=$(((LOBER_RANDOM_PAIRS + 49) / 50))
export LOBER_DISCRETISATION_PAIRS=2000
export LOBER_RANDOM_TRANSPORT=100
export LOBER_SEED=${2:-$(date +%s%N)}
export LOBER_FAILURES=$PWD/build/failures
mkdir -p "$LOBER_FAILURES"
echo "LOBER_RANDOM_PAIRS=$LOBER_RANDOM_PAIRS LOBER_SEED=$LOBER_SEED"
status=0
build/bin/lober_tests --gtest_filter='*Random*' || status=1
build/bin/lober_tests --gtest_filter='*Stability*' || status=1
# The error bars of lobes and fluxes, of forty systems of each of four families.
LOBER_COVERAGE_SYSTEMS=40 build/bin/lober_tests --gtest_filter='TransportCoverage*' || status=1
LOBER_ALL_VARIATIONS=1 LOBER_SCENE_POINTS=1000000 build/bin/lober_determinism_tests --gtest_brief=1 || status=1
# Two hundred times kill -9 in the middle of a batch.
LOBER_KILLS=200 build/bin/lober_cli_tests --gtest_filter='BatchCrash.Killed*' || status=1
exit $status
