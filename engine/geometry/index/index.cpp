#include "engine/geometry/index/index.hpp"

#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/search.hpp"

namespace lober {
using namespace detail;

IndexedCurve::IndexedCurve(CurveView curve) : view_(curve), tree_(std::make_shared<const BoxTree>(curve)) {}
IndexedCurve::IndexedCurve(const ClosedCurve& curve) : IndexedCurve(CurveView(curve)) {
  owner_ = curve.owner();
}
IndexedCurve::IndexedCurve(const OpenCurve& curve) : IndexedCurve(CurveView(curve)) {
  owner_ = curve.owner();
}

bool IndexedCurve::finite() const {
  return tree_->sums_finite();
}
std::size_t IndexedCurve::memory() const {
  return tree_->memory();
}

std::string_view name(IndexKind kind) {
  switch (kind) {
    case IndexKind::automatic:
      return "auto";
    case IndexKind::tree:
      return "tree";
    case IndexKind::grid:
      return "grid";
    case IndexKind::kd:
      return "kd";
  }
  return "";
}

IndexKind index_kind(std::string_view wanted) {
  for (const IndexKind kind : {IndexKind::tree, IndexKind::grid, IndexKind::kd}) {
    if (name(kind) == wanted) return kind;
  }
  return IndexKind::automatic;
}

SearchCounts detail::find_pairs(const IndexedCurve& first, const IndexedCurve& second, IndexKind kind,
                                PairConsumer& consumer) {
  switch (kind) {
    case IndexKind::grid:
      return find_pairs_by_grid(first, second, consumer);
    case IndexKind::kd:
      return find_pairs_by_kd(first, second, consumer);
    case IndexKind::tree:
      return find_pairs_by_tree(first, second, consumer);
    case IndexKind::automatic:
      break;
  }
  throw UsageError("find_pairs needs a definite index, see choose_index");
}

}  // namespace lober
