// Systems by name: the built-in ones and those from a user's shared library.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/local_manifold.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober {

/// A parameter of a system.
struct Parameter {
  std::string name;     ///< the name on the command line
  double value = 0;     ///< the default in a SystemInfo, the chosen value in a System
  std::string meaning;  ///< a phrase
  /// The values that make sense: min to max, without min or max where it is excluded.
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();  ///< the upper bound
  bool min_excluded = false;                             ///< whether min itself is excluded
  bool max_excluded = false;                             ///< whether max itself is excluded
  /// Whether it is the size of a perturbation, without which (at 0) manifolds coincide: that of Melnikov's method.
  bool perturbation = false;

  /// Whether the number is in the range.
  [[nodiscard]] LOBER_API bool allows(double number) const;
  /// The values as words: "positive", "above 2", "at least -1", "in [0, 0.5)"; empty where any number will do.
  [[nodiscard]] LOBER_API std::string range() const;
};

/// The description of a system before its parameters are chosen.
struct SystemInfo {
  std::string name;                   ///< the name on the command line
  std::string summary;                ///< one line: equations or their source, and the planar map
  std::vector<Parameter> parameters;  ///< in their order, with defaults
  std::string library = {};           ///< the path of the shared library that it is from; empty for built-in systems
  /// The hash of that file, lower-case hexadecimal, where operations::system_input loaded it; else empty.
  std::string library_sha256 = {};

  /// The parameter that is the size of a perturbation; null where there is none.
  [[nodiscard]] LOBER_API const Parameter* perturbation() const;
};

/// An affine map z -> linear z + shift of the plane that takes orbits of the planar map f to orbits: it commutes with
/// f, or, a reversor, it turns f into its inverse, f S = S f^-1. Nothing in the engine relies on it.
struct Symmetry {
  Matrix2 linear;         ///< the linear part
  Point shift{};          ///< the constant part
  bool reversor = false;  ///< whether it turns the map into its inverse

  /// The image of a point.
  [[nodiscard]] LOBER_API Point operator()(Point z) const;
};

/// A pair of manifolds: U from one saddle, S from another or the same one, each on the branch that leaves its saddle in
/// the given direction.
struct Connection {
  Point from, u_direction;     ///< near the saddle of U, and the direction in which U leaves it
  Point to, s_direction;       ///< near the saddle of S, and the direction in which S leaves it
  std::optional<Point> bip{};  ///< near a pip that is a good one to bound a region with
  /// Corners of the path from `to` back to `from` that the map keeps, walls or an axis, and that closes the boundary;
  /// without any it is straight.
  std::vector<Point> closure{};
  /// A known obstacle to growing these manifolds, for messages; empty where there is none.
  std::string caution{};

  /// The point near the saddle of this manifold.
  [[nodiscard]] Point saddle(ManifoldSide side) const { return side == ManifoldSide::unstable ? from : to; }
  /// The direction in which this manifold leaves its saddle.
  [[nodiscard]] Point direction(ManifoldSide side) const {
    return side == ManifoldSide::unstable ? u_direction : s_direction;
  }
};

/// A system with its parameters chosen.
struct System {
  SystemInfo info;  ///< description, with the chosen values of the parameters
  /// The box of the fixed points of interest: a scan searches it unless the user gives another one. The map's unit
  /// (PlanarMap::unit) follows from its extent.
  Rectangle window;
  /// The box that a picture of orbits shows and in which they begin: the window, unless the system says otherwise.
  Rectangle picture;
  /// Shift of the plane after which the map repeats itself, (0, 0) when there is none: (2 pi, 0) for a lifted angle.
  Point lattice;
  /// A second shift in another direction, where both coordinates are angles; (0, 0) otherwise.
  Point second_lattice{};
  std::optional<Connection> connection;  ///< the one whose tangle is of interest; its boundary bounds region 1
  /// Why a system that has a connection for other parameters has none for these; empty elsewhere.
  std::string no_connection{};
  std::vector<Connection> further{};  ///< connections whose boundaries bound more regions
  /// Whether region 1 is not bounded without those: the strip of a cylinder between an upper and a lower boundary.
  bool further_needed = false;
  std::shared_ptr<const Flow> flow;  ///< null when the system is a map
  std::vector<FlowState> saddles;    ///< states near the saddles of rank 1 that bound a well (engine/escape)
  std::optional<Section> section;    ///< section of the map, when it is a return map
  /// Names of the flow's coordinates, in their order, where the system gives them: sections can be named by them.
  std::vector<std::string> coordinates{};
  std::vector<Symmetry> symmetries;      ///< symmetries of the map known for these parameters, lattice aside
  std::shared_ptr<const PlanarMap> map;  ///< null for a flow whose map is not defined by its canonical section
};

/// Names and values, in any order; those left out take their defaults.
using ParameterValues = std::vector<std::pair<std::string, double>>;

/// The built-in systems, in the order of their names.
[[nodiscard]] LOBER_API std::vector<SystemInfo> list_systems();

/// Whether the name of a system is the path of a shared library: it has a slash, or ends in ".so".
[[nodiscard]] LOBER_API bool is_library_path(std::string_view name);

/// The system `name`, or the one in the shared library `name` (is_library_path; lober_system.h). Throws UsageError,
/// naming the alternatives, for an unknown name or parameter, a parameter given twice or out of its range; DataError
/// for a library that cannot be used.
[[nodiscard]] LOBER_API System make_system(std::string_view name, const ParameterValues& values = {},
                                           const IntegrationOptions& options = {});

}  // namespace lober
