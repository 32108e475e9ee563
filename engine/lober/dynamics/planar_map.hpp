// A planar map, which carries curves and manifolds along. Maps given by formulas, stroboscopic maps of
// time-periodic flows and Poincare maps on a section all look like this.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"

namespace lober {

/// A 2 x 2 matrix, row by row.
struct Matrix2 {
  double xx = 1, xy = 0;  ///< first row
  double yx = 0, yy = 1;  ///< second row
};

/// A diffeomorphism of (a part of) the plane. Immutable: every call may come from several threads at the same time, and
/// a point has the same image, bit for bit, in every batch.
class LOBER_API PlanarMap {
 public:
  PlanarMap() = default;
  PlanarMap(const PlanarMap&) = delete;
  PlanarMap& operator=(const PlanarMap&) = delete;
  virtual ~PlanarMap() = default;

  /// Replaces every point by its image under `iterates` steps; negative: steps of the inverse map. A point whose orbit
  /// cannot be followed (it leaves the domain, never returns to the section, the integration fails) becomes (NaN, NaN).
  /// Serial: callers hand out batches to threads.
  virtual void iterate(std::span<Point> points, int iterates) const = 0;

  /// Whether the point may have an image, as far as that is known without following it: false where the energy of a
  /// return map does not reach, or outside the bound of its section.
  [[nodiscard]] virtual bool is_defined_at(Point /*point*/) const { return true; }

  /// The image of one point as `iterate` gives it (to the tolerance of an integration), and the derivative there.
  virtual Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const = 0;
  /// The same for many points, each replaced by its image; `derivatives` has the same number of elements.
  virtual void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const {
    for (std::size_t k = 0; k < points.size(); ++k) {
      points[k] = iterate_with_derivative(points[k], iterates, derivatives[k]);
    }
  }

  /// The action L of the step from `from` to its image `to`, in units of area: dL = y' dx' - y dx along the graph of
  /// the map (MacKay, Meiss & Percival 1984), so that differences of sums of L along orbits are areas. Nothing when the
  /// map does not preserve area or its action is not known. For maps with a generating function this is L(x, x'); for
  /// flows the integral of y dx - H dt, with y' dx' for the gap between `to` and the computed image. Either way the sum
  /// over an orbit is stationary: if its points are off by d, it is off by O(d^2). Rounding: that of long double for
  /// generating functions, the tolerance for flows.
  [[nodiscard]] virtual std::optional<long double> action(Point /*from*/, Point /*to*/) const { return std::nullopt; }
  /// An estimate of the error of an action L, as a fraction of unit()^2 + |L|.
  [[nodiscard]] virtual double action_accuracy() const { return 1e-18; }

  /// The size of the coordinates of interest, as a power of ten: steps, errors and distances that are to be small are
  /// so beside it. 1, as for the built-in systems, unless it is overridden (unit_within).
  [[nodiscard]] virtual double unit() const { return 1; }

  /// The least number of points that is worth a call of `iterate`: callers that have that many hand out no fewer at a
  /// time. 0: a few dozen are enough, as they are unless each call costs much.
  [[nodiscard]] virtual std::size_t batch() const { return 0; }

  /// The same map integrated to a hundredth of the tolerance; nothing for a map that is given by formulas.
  [[nodiscard]] virtual std::unique_ptr<PlanarMap> finer() const { return nullptr; }
  /// Whether `iterate` takes every number of iterates, negative ones too: not where the inverse is not known.
  [[nodiscard]] virtual bool takes_all_iterates() const { return true; }
  /// The flow whose step this map is, counted in halves of a step: n iterates from a point take n / 2 steps of time,
  /// those of negative n back in time. A point has f^k(z) = z exactly where half a way on and half a way back meet,
  /// half()->iterate(z, k) and half()->iterate(z, -k), each of which stretches by the square root only. Nothing for
  /// maps whose steps are not known to have halves.
  [[nodiscard]] virtual std::unique_ptr<PlanarMap> half() const { return nullptr; }
  /// Evaluations of a vector field that `iterate` has taken so far, in all threads together; those of several points at
  /// a time count a tenth, about their cost. 0 for a map that is given by formulas. The number is the same for the same
  /// points, however they are shared out, on every processor.
  [[nodiscard]] virtual std::uint64_t work() const { return tenths_of_work_.load(std::memory_order_relaxed) / 10; }
  /// The work of `iterate_with_derivatives`, where an evaluation counts three times.
  [[nodiscard]] virtual std::uint64_t work_of_derivatives() const {
    return tenths_of_derivatives_.load(std::memory_order_relaxed) / 10;
  }

 protected:
  /// Adds to `work`, in tenths of an evaluation.
  void add_tenths_of_work(std::uint64_t tenths) const { tenths_of_work_.fetch_add(tenths, std::memory_order_relaxed); }
  /// Adds to `work_of_derivatives`, in tenths of an evaluation.
  void add_tenths_of_derivatives(std::uint64_t tenths) const {
    tenths_of_derivatives_.fetch_add(tenths, std::memory_order_relaxed);
  }

 private:
  mutable std::atomic<std::uint64_t> tenths_of_work_{0}, tenths_of_derivatives_{0};
};

/// PlanarMap::unit for a region of interest of this extent: the largest power of ten that is no larger; 1 where that is
/// not known, not positive or not finite.
[[nodiscard]] LOBER_API double unit_within(double extent);

}  // namespace lober
