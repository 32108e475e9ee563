// From a map and two saddles to their tangle: manifolds grown as far as they are needed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/dynamics/connecting_orbit.hpp"
#include "engine/dynamics/system.hpp"
#include "engine/tangle/tangle.hpp"

namespace lober {

struct ManifoldTangleOptions {
  /// Distance that polygon and manifold may have. With smooth areas their error is far smaller (order h^6 against h^2).
  /// It is divided by 10, twice at most, as long as a lobe of the turnstile is on average thinner than ten times
  /// this: polygons that lie so close to each other may cross where manifolds do not. An odd number of pips a period
  /// shows that they do: five times then.
  double tolerance = 1e-5;
  int before = 1;                   ///< images of the bip q that are wanted: from f^-before(q)
  int after = 0;                    ///< to f^after(q)
  std::optional<Point> bip_near{};  ///< default: as in the system's Connection, else the middle of the first pips found
  bool smooth = true;
  int most_iterates = 60;  ///< of either manifold
  std::size_t most_points = 20'000'000;
  /// Called with a line of what is being done; return false to cancel.
  std::function<bool(const std::string&)> progress{};
};

/// The two manifolds, their tangle with the period of the map known, and the orbits of the pips of one period. Beyond
/// eight times the size of the scene (saddles and local manifolds) manifolds are followed coarsely, beyond 500 times
/// distances are logarithmic: areas of lobes that reach there mean nothing, what they have in common with others near
/// by does.
struct ManifoldTangle {
  LocalManifold local_u, local_s;
  GrownManifold u, s;
  Tangle tangle;         ///< of u and s
  std::size_t bip = 0;   ///< number of the pip q
  double tolerance = 0;  ///< that the manifolds were grown to in the end
  /// Orbits of the pips from bip - period to bip: of the lobes of the turnstile.
  std::vector<ConnectingOrbit> orbits;
  /// Signed areas of the turnstile lobes by action, in the order of the lobes; empty if the map has no action.
  std::vector<double> areas_by_action;

  [[nodiscard]] std::size_t period() const { return tangle.images.period; }
  /// The pip f^n(q).
  [[nodiscard]] std::size_t image_of_bip(int n) const {
    return bip + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(period()) * n);
  }
};

/// Grows U from the saddle near connection.from and S from that near connection.to, by one iterate after the other,
/// until the pips from f^-before(q) to f^after(q) are there. Which pip is the image of which the map itself tells.
/// Throws DataError with what is missing when the manifolds do not cross within the limits, the number of pips a period
/// remains odd, or the saddles are none;
/// UsageError; Cancelled.
[[nodiscard]] std::unique_ptr<ManifoldTangle> grow_tangle(const PlanarMap& map, const Connection& connection,
                                                          const ManifoldTangleOptions& options = {});

}  // namespace lober
