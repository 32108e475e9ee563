#include "engine/operations/tangle_fields.hpp"

#include <cmath>
#include <optional>

namespace lober::detail::table {
using namespace operations;
namespace {

struct GrownBranch {
  const LocalManifold* local;
  const GrownManifold* grown;
};

const Schema<GrownBranch>& branch_schema() {
  static const Schema<GrownBranch> schema = [] {
    Schema<GrownBranch> made;
    made.field("at", "length", "the saddle", [](const GrownBranch& b) { return b.local->saddle; })
        .field("multiplier", "", "multiplier with which the map stretches the manifold at the saddle",
               [](const GrownBranch& b) { return b.local->multiplier; })
        .field("tangent", "", "unit vector along the manifold at the saddle",
               [](const GrownBranch& b) { return b.local->tangent; })
        .field("reach", "length", "parameter up to which the polynomial of the local manifold is used",
               [](const GrownBranch& b) { return b.local->reach; })
        .field("defect", "length", "largest distance of the local manifold from its image",
               [](const GrownBranch& b) { return b.local->defect; })
        .field("points", "", "number of points of the polygon",
               [](const GrownBranch& b) { return b.grown->points.size(); });
    return made;
  }();
  return schema;
}

struct TurnstileLobe {
  std::size_t number;
  const ManifoldTangle* manifolds;

  [[nodiscard]] const Lobe& lobe() const { return manifolds->tangle.lobes[number]; }
  [[nodiscard]] std::optional<double> action_part(const std::vector<double>& parts) const {
    if (parts.empty()) return std::nullopt;
    return parts[number - manifolds->image_of_bip(-1)];
  }
};

std::vector<TurnstileLobe> turnstile_lobes(const ManifoldTangle& manifolds) {
  std::vector<TurnstileLobe> lobes;
  for (std::size_t k = 0; k < manifolds.period(); ++k) lobes.push_back({manifolds.image_of_bip(-1) + k, &manifolds});
  return lobes;
}

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

Schema<TurnstileLobe> lobe_schema() {
  Schema<TurnstileLobe> made;
  made.field("index", "", "number of the lobe among all of the tangle, from 0", &TurnstileLobe::number)
      .field("label", "", "the region that it leaves and the one that it enters: L12(1)",
             [](const TurnstileLobe& l) { return text(l.manifolds->tangle.images.labels[l.number]); })
      .field(
          "area", "area", "signed area by geometry",
          [](const TurnstileLobe& l) {
            return Measured{l.lobe().area, l.lobe().smooth_error};
          },
          "error")
      .field(
          "action", "area", "signed area by action; not known where the map has none",
          [](const TurnstileLobe& l) {
            return Measured{l.action_part(l.manifolds->areas_by_action).value_or(not_known),
                            l.action_part(l.manifolds->action_errors).value_or(not_known)};
          },
          "action_error")
      .field("difference", "area", "difference of both areas", [](const TurnstileLobe& l) {
        return std::fabs(l.lobe().area - l.action_part(l.manifolds->areas_by_action).value_or(not_known));
      });
  return made;
}

Schema<ConnectingOrbit> pip_schema() {
  Schema<ConnectingOrbit> made;
  made.field("at", "length", "the pip", &ConnectingOrbit::at)
      .field("residual", "length", "distance by which the two halves of its orbit fail to meet",
             &ConnectingOrbit::residual)
      .field("action", "area", "action of the orbit through it; not known where the map has none",
             [](const ConnectingOrbit& o) { return o.action ? static_cast<double>(*o.action) : not_known; });
  return made;
}

}  // namespace

const Schema<ManifoldTangle>& saddles_schema() {
  static const Schema<ManifoldTangle> schema = [] {
    Schema<ManifoldTangle> made;
    made.object("unstable", "saddle of U, and U", branch_schema(),
                [](const ManifoldTangle& m) {
                  return GrownBranch{&m.local_u, &m.u};
                })
        .object("stable", "saddle of S, and S", branch_schema(), [](const ManifoldTangle& m) {
          return GrownBranch{&m.local_s, &m.s};
        });
    return made;
  }();
  return schema;
}

Schema<ManifoldTangle> turnstile_schema() {
  Schema<ManifoldTangle> made;
  made.field("period", "", "number of pips from one to its image", &ManifoldTangle::period)
      .list("pips", "pips from f^-1(q) to q", pip_schema(), &ManifoldTangle::orbits)
      .list("lobes", "between them", lobe_schema(), turnstile_lobes);
  return made;
}

}  // namespace lober::detail::table
