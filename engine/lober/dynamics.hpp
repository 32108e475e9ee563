// Maps and flows, built in and of one's own, with their orbits, fixed points, manifolds, tubes and images of curves.
#pragma once

#include "lober/dynamics/connecting_orbit.hpp"
#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/levels.hpp"
#include "lober/dynamics/local_manifold.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/orbits.hpp"
#include "lober/dynamics/periodic_orbit.hpp"
#include "lober/dynamics/planar_map.hpp"
#include "lober/dynamics/shifted_map.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/dynamics/tube_surface.hpp"
#include "lober/dynamics/tubes.hpp"
#include "lober/dynamics/vector_field.hpp"
