#!/usr/bin/env bash
# A part of docs/explanation/size.md, from bench/CLUSTER.json.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 bench/cluster_schedule.py costs
