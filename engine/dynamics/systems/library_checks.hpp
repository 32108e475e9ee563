// Whether the functions of a system of one's own belong together (private to systems/).
#pragma once

#include <span>

#include "lober/dynamics/systems.hpp"
#include "lober/dynamics/vector_field.hpp"
#include "lober/lober_system.h"

namespace lober::detail {

/// Compares, at some points of the window, the inverse of a map with the map, its derivative and its action with finite
/// differences; and whether it repeats after the lattice. Points where a function fails are left out, unless that is
/// all of them. Throws DataError that names the first discrepancy, its place and both numbers. Takes microseconds.
void check_library_map(const lober_system& system, const System& made, std::span<const double> parameters);

/// Compares, in the same way, the Jacobian of a field with finite differences, what its Hamiltonian says of the
/// velocity and velocities of several points with those of one; and whether they repeat after the lattice and the
/// period. `made` is the system, with its name, flow, window and section, `energy` that of the section.
void check_flow(const VectorField& field, const System& made, double energy);

}  // namespace lober::detail
