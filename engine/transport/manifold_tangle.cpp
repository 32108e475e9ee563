#include "engine/transport/manifold_tangle.hpp"

#include "engine/error.hpp"
#include "engine/transport/tangle_growth.hpp"

namespace lober {

std::unique_ptr<ManifoldTangle> grow_tangle(const PlanarMap& map, const Connection& connection,
                                            const ManifoldTangleOptions& options) {
  if (options.before < 1 || options.after < 0) throw UsageError("at least one image of the bip before it is needed");
  TangleGrowth growth(map, connection, options);
  if (!growth.grow_to(options.before, options.after)) throw DataError(growth.limit());
  return growth.take();
}

}  // namespace lober
