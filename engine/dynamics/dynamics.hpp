// Dynamics: systems by name, maps and flows, their planar maps.
//
//   planar_map.hpp     PlanarMap, what everything else works with
//   flow.hpp           Flow: trajectories, sections, stroboscopic and return maps
//   system.hpp         make_system, list_systems: the built-in systems and those of users
//   fixed_points.hpp   fixed and periodic points, one or all in a box
//   lober_system.h     the C interface by which users add systems
#pragma once

#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/planar_map.hpp"
#include "lober/dynamics/systems.hpp"
