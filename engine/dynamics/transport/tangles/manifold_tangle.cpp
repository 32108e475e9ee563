#include "lober/tangle/manifold_tangle.hpp"

#include <cmath>
#include <string>

#include "engine/dynamics/transport/tangles/barrier.hpp"
#include "engine/dynamics/transport/tangles/tangle_growth.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;

std::unique_ptr<ManifoldTangle> grow_tangle(const PlanarMap& map, const Connection& connection,
                                            const ManifoldTangleOptions& options) {
  if (options.before < 1 || options.after < 0)
    throw UsageError("the number of images of the bip has to be at least 1 before it and at least 0 after it");
  TangleGrowth growth(map, connection, options);
  if (!growth.grow_to(options.before, options.after)) throw DataError(growth.limit());
  return growth.take();
}

std::vector<Point> boundary_curve(const ManifoldTangle& manifolds) {
  return outline_of({.tangle = &manifolds.tangle, .bip = manifolds.bip, .period = manifolds.period()}, 0);
}

std::string remark_on_boundary(const ManifoldTangle& manifolds, Point lattice) {
  return crosses_itself(barrier_of(manifolds, lattice)) ? remark_on_boundary(manifolds.tangle) : std::string();
}

Agreement agreement_of(const ManifoldTangle& manifolds) {
  Agreement agreement;
  Measured leaving, entering;
  for (std::size_t k = 0; k < manifolds.areas_by_action.size(); ++k) {
    const std::size_t number = manifolds.image_of_bip(-1) + k;
    const Lobe& lobe = manifolds.tangle.lobes[number];
    agreement.compare({"area of lobe " + std::to_string(number), "geometry", "action", lobe.area,
                       manifolds.areas_by_action[k], lobe.smooth_error + manifolds.action_errors[k]});
    Measured& side = manifolds.tangle.images.labels[number].from == 1 ? leaving : entering;
    side = side + Measured{std::fabs(lobe.area), lobe.smooth_error};
  }
  agreement.compare({"area that crosses in one step", "L12(1)", "L21(1)", leaving.value, entering.value,
                     leaving.error + entering.error});
  if (manifolds.splitting_zeros > 0) {
    agreement.compare({"number of pips a period", "polygons", "sign changes of the splitting",
                       static_cast<double>(manifolds.period()), static_cast<double>(manifolds.splitting_zeros), 0});
  }
  return agreement;
}

}  // namespace lober
