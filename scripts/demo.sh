#!/usr/bin/env bash
# Overlays the resonance region of the standard map and its image after four iterates (see
# examples/make_demo_curves.cpp), prints the lobes and draws them.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p out
build/bin/lober overlay examples/resonance.dat examples/resonance_image.dat --svg out/demo.svg
echo
echo "The picture of the two curves and their lobes is in out/demo.svg"
