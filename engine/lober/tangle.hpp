// The tangle of an unstable and a stable manifold: pips, lobes, turnstile; of curves, and of the manifolds of a system.
#pragma once

#include "lober/tangle/manifold_tangle.hpp"
#include "lober/tangle/tangle.hpp"
