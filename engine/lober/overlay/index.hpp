// Curves with a spatial index, which saves time for curves that occur in many pairs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"

namespace lober {

/// Which index prunes the pairs of segments. Results do not depend on it, the time does.
enum class IndexKind : std::uint8_t { automatic, tree, grid, kd };
/// All kinds of index.
inline constexpr std::array<IndexKind, 4> all_index_kinds{IndexKind::automatic, IndexKind::tree, IndexKind::grid,
                                                          IndexKind::kd};
/// The name of the kind.
[[nodiscard]] LOBER_API std::string_view name(IndexKind kind);
/// The kind of that name; `automatic` if there is none.
[[nodiscard]] LOBER_API IndexKind index_kind(std::string_view name);

namespace detail {
class BoxTree;  // private: engine/geometry/index/box_tree.hpp
}  // namespace detail

/// A curve with its box tree: what every search starts from. Build it once for a curve that occurs in many pairs.
/// Cheap to copy; keeps alive what the curve owns. O(N), parallel; about 2 bytes a point, 2 more for a curve whose
/// folds have been searched, and 32 more for one of up to 2048 segments that has been used several times.
class IndexedCurve {
 public:
  /// Indexes a closed curve and keeps alive what it owns.
  LOBER_API explicit IndexedCurve(const ClosedCurve& curve);
  /// Indexes an open curve and keeps alive what it owns.
  LOBER_API explicit IndexedCurve(const OpenCurve& curve);
  /// Indexes points that somebody else keeps. A temporary that owns its points does not convert to the view.
  LOBER_API explicit IndexedCurve(CurveView curve);

  /// The curve.
  [[nodiscard]] const CurveView& view() const& { return view_; }
  [[nodiscard]] const CurveView& view() const&& = delete;  // the points may go with the curve
  /// Number of segments.
  [[nodiscard]] std::size_t segments() const { return view_.segments(); }
  /// False when some coordinate is not finite, or so large that products overflow: then `validate` says which one.
  [[nodiscard]] LOBER_API bool finite() const;
  [[nodiscard]] LOBER_API std::size_t memory() const;  ///< bytes of the index
  /// The owner of the points; null when they are borrowed.
  [[nodiscard]] const std::shared_ptr<const void>& owner() const { return owner_; }
  /// For the library itself.
  [[nodiscard]] const detail::BoxTree& tree() const { return *tree_; }

 private:
  CurveView view_;
  std::shared_ptr<const void> owner_;
  std::shared_ptr<const detail::BoxTree> tree_;
};

/// Whether `point` lies inside the closed curve (even-odd rule); the point must not lie on it. Exact. Takes about log
/// N: whole subtrees count by their end points.
[[nodiscard]] LOBER_API bool contains(const IndexedCurve& curve, Point point);

}  // namespace lober
