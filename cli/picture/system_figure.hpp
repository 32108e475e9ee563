// Parts that pictures of several commands have in common: titles, names of axes, windows.
#pragma once

#include <string>
#include <vector>

#include "cli/picture/figure.hpp"
#include "lober/curve/files.hpp"
#include "lober/dynamics/periodic_orbit.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::cli {

/// "ovp: gamma = 0.5, eps = 0.1, phase = 0", the title of a picture.
[[nodiscard]] std::string system_title(const SystemInfo& system);
/// The names of the coordinates of the system's map: those of its section, which are not drawn to one scale where one
/// is a position and the other a velocity, or those that its summary names; x and y otherwise.
void name_axes(Figure& figure, const System& system);
/// Adds the curves beyond which the section has no points of this energy, as far as `box` reaches. Returns the box of
/// those that are closed. Nothing for sections of flows without a Hamiltonian.
Rectangle add_section_edge(Figure& figure, const Flow& flow, const Section& section, double energy,
                           const Rectangle& box);
/// The same for the section of the system's own map, which has its energy as a parameter.
void add_section_edge(Figure& figure, const System& system);
/// The names of the columns of the file, with their units, as in "easting (km)"; degrees where these are longitudes and
/// latitudes. x and y where the file has no names.
void name_axes(Figure& figure, const NamedCurve& input);

/// Points of a periodic orbit at equal times, in the two coordinates of position.
[[nodiscard]] std::vector<Point> orbit_positions(const Flow& flow, const PeriodicOrbit& orbit);

/// The box widened by a thirtieth on each side, so that nothing lies on the frame.
[[nodiscard]] Rectangle with_margin(const Rectangle& box);
/// "eddy.csv#0" for the curve of a file, without its folder.
[[nodiscard]] std::string short_name(const std::string& spec);
/// A number with six digits.
[[nodiscard]] std::string rounded(double value);

/// A borrowed curve, an open or a closed one.
[[nodiscard]] Polyline polyline(std::span<const Point> points, bool closed, std::string name = {});
/// Points of its own.
[[nodiscard]] Polyline polyline(std::vector<Point> points, bool closed, std::string name = {});

}  // namespace lober::cli
