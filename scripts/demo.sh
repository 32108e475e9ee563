#!/usr/bin/env bash
# Takes apart the tangle of the Henon map (examples/make_demo_manifolds.cpp), prints its lobes and draws them. Overlays the
# resonance region of the standard map and its image after four iterates (examples/make_demo_curves.cpp) too.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p out
build/bin/lober tangle examples/manifolds.dat --overlaps --svg out/tangle.svg
build/bin/lober overlay examples/resonance.dat examples/resonance_image.dat --svg out/demo.svg >out/demo.txt
echo
echo "Pictures: out/tangle.svg, and out/demo.svg of the overlay of a region and its image (areas in out/demo.txt)"
