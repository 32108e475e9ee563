// A map whose orbits are followed up to a shift of the plane: on a cylinder or a torus a periodic point of the lifted
// map goes round and comes back shifted, f^period(z) = z + shift, as the saddles of a resonance do.
//
//   const lober::ShiftedMap turned(map, 3, {6.283185307179586, 0});  // round once in three iterates
//   const auto local = lober::local_manifold(turned, saddle, lober::ManifoldSide::unstable, {.period = 3});
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober {

/// z -> f^k(z) - (k / period) shift for the multiples k of the period: f^period up to the shift, and its powers. The
/// map f has to repeat after the shift, f(z + shift) = f(z) + shift, and has to outlive this one.
class LOBER_API ShiftedMap final : public PlanarMap {
 public:
  /// Throws UsageError unless period >= 1.
  ShiftedMap(const PlanarMap& map, int period, Point shift);

  /// Throws UsageError unless `iterates` is a multiple of the period.
  void iterate(std::span<Point> points, int iterates) const override;
  [[nodiscard]] bool is_defined_at(Point point) const override { return map_->is_defined_at(point); }
  /// Throws UsageError unless `iterates` is a multiple of the period.
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override;
  /// Throws UsageError unless `iterates` is a multiple of the period.
  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override;
  [[nodiscard]] double unit() const override { return map_->unit(); }
  [[nodiscard]] std::size_t batch() const override { return map_->batch(); }
  [[nodiscard]] bool takes_all_iterates() const override { return period_ == 1 && map_->takes_all_iterates(); }
  [[nodiscard]] std::unique_ptr<PlanarMap> finer() const override;
  [[nodiscard]] std::uint64_t work() const override { return map_->work(); }
  [[nodiscard]] std::uint64_t work_of_derivatives() const override { return map_->work_of_derivatives(); }

 private:
  [[nodiscard]] Point shift_of(int iterates) const;

  const PlanarMap* map_;
  std::unique_ptr<PlanarMap> owned_;  // map_ where it is a finer map made here
  int period_;
  Point shift_;
};

}  // namespace lober
