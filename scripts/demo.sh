#!/usr/bin/env bash
# From equations to transport: grows the manifolds of the oscillating vortex pair, takes their tangle apart, prints how much
# fluid crosses the boundary in each period, and draws it. Then the overlay of two curves from files.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p out
build/bin/lober transport ovp --param gamma=0.5 --param eps=0.1 --iterates 7 --picture out/turnstile.svg --svg out/fluxes.svg
build/bin/lober overlay examples/resonance.dat examples/resonance_image.dat --svg out/demo.svg >out/demo.txt
echo
echo "Pictures: out/turnstile.svg and out/fluxes.svg, and out/demo.svg of the overlay of a region and its image (areas in"
echo "out/demo.txt)"
