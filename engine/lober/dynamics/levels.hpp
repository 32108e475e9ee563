// Level curves: streamlines of a planar flow, equipotential and zero-velocity curves of a flow of two degrees of
// freedom.
//
// A function is sampled at the nodes of a grid; where a level passes between two neighbours, the point is found to
// rounding by bisection. So the vertices of a level curve lie on the level, whatever the grid; details smaller than a
// cell are missed, and between vertices the curve is straight.
//
//   const lober::LevelGrid grid(lober::energy_of(flow, time), window, 400, 300);
//   for (const lober::LevelCurve& curve : grid.curves(energy)) draw(curve.points);
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober {

/// A function of the plane; NaN or infinite where it has no value. Called from several threads at once.
using PlaneFunction = std::function<double(Point)>;

/// The energy of a Hamiltonian flow at a time: in two dimensions H(x, y), whose level curves are the streamlines then;
/// in four the least H over the momenta at a position, the (effective) potential: where it exceeds the energy no motion
/// is possible (outside Hill's region). H then has to be quadratic in the momenta. The flow must outlive the function.
/// Throws UsageError for other flows.
[[nodiscard]] LOBER_API PlaneFunction energy_of(const Flow& flow, double time);

/// An equilibrium of the flow as it is at a time, with its energy; in four dimensions a state of rest, `at` its
/// position.
struct Equilibrium {
  Point at;             ///< the position
  double energy = 0;    ///< energy there
  bool saddle = false;  ///< in a planar flow: eigenvalues of opposite sign; in four dimensions: rank 1 or more
};
/// The equilibrium that Newton's method finds from `guess`. Throws DataError when none is found, UsageError as
/// energy_of.
[[nodiscard]] LOBER_API Equilibrium equilibrium_near(const Flow& flow, const FlowState& guess, double time);

/// A curve on which the function has one value.
struct LevelCurve {
  std::vector<Point> points;  ///< the function is larger on their left; closed curves without the first point again
  bool closed = false;        ///< else it ends at the border of the window or of the domain of the function
};

/// Values at the nodes of a grid of columns x rows cells, (columns + 1)(rows + 1) of them.
class LevelGrid {
 public:
  /// Throws UsageError for a window without area or a grid without cells. O(nodes), parallel.
  LOBER_API LevelGrid(PlaneFunction function, const Rectangle& window, std::size_t columns, std::size_t rows);

  /// The box of the grid.
  [[nodiscard]] const Rectangle& window() const { return window_; }
  /// Number of cells along x.
  [[nodiscard]] std::size_t columns() const { return columns_; }
  /// Number of cells along y.
  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// The position of a node, columns and rows counted from 0.
  [[nodiscard]] LOBER_API Point node(std::size_t column, std::size_t row) const;
  /// The value at a node; NaN where the function has none.
  [[nodiscard]] double value(std::size_t column, std::size_t row) const {
    return values_[row * (columns_ + 1) + column];
  }

  /// The curves on which the function has this value (marching squares; in a cell crossed by two curves the mean of its
  /// corners decides). Nodes on the level count as above it; cells with a corner without value are left out. Open
  /// curves come first. The same for any number of threads. O(cells + evaluations on the curves).
  [[nodiscard]] LOBER_API std::vector<LevelCurve> curves(double level) const;

 private:
  PlaneFunction function_;
  Rectangle window_;
  std::size_t columns_, rows_;
  std::vector<double> values_;
};

}  // namespace lober
