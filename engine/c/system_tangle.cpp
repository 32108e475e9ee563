// Tangles of systems, for C.
#include "engine/c/call.hpp"
#include "engine/c/disagreements.hpp"
#include "engine/c/model.hpp"
#include "engine/c/tangle.hpp"
#include "lober/manifold_tangle.hpp"

namespace lober::detail::c {
namespace {

using Work = std::function<void(lober_result&)>;

std::function<bool(const std::string&)> text_progress() {
  const std::function<bool(double)> function = progress();
  if (!function) return {};
  return [function](const std::string&) { return function(-1); };
}

Work tangle_work(const lober_model* model, Options& given) {
  const PlanarMap& map = map_of(model);
  const Connection& connection = connection_of(model);
  ManifoldTangleOptions options;
  options.tolerance = given.number("tolerance", options.tolerance);
  options.before = static_cast<int>(given.integer("before", options.before, 1));
  options.after = static_cast<int>(given.integer("after", options.after));
  options.smooth = given.flag("smooth", options.smooth);
  options.max_points = given.count("max_points", options.max_points);
  options.bip_near = given.point("bip_near");
  options.progress = text_progress();
  return [=, &map, &connection](lober_result& result) {
    const std::shared_ptr<const ManifoldTangle> grown = grow_tangle(map, connection, options);
    add_tangle(result, {grown, &grown->tangle}, options.smooth);
    result.add_points("u", grown->u.points, grown);
    result.add_points("s", grown->s.points, grown);
    result.add("areas_by_action", grown->areas_by_action);
    result.add("action_errors", grown->action_errors);
    const Point from = grown->local_u.saddle, to = grown->local_s.saddle;
    result.add("saddles", lober_result::Doubles{from.x, from.y, to.x, to.y}, 2);
    result.add("multipliers", lober_result::Doubles{grown->local_u.multiplier, grown->local_s.multiplier});
    require_agreement(result, agreement_of(*grown));
  };
}

}  // namespace
}  // namespace lober::detail::c

int lober_model_tangle(const lober_model* model, const char* options, lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return tangle_work(model, given); });
}
