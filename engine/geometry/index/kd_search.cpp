// Pairs of segments from k-d trees (nanoflann) over the midpoints of the segments of the second curve.
//
// Two segments with a common point have midpoints not farther apart than the sum of their half lengths. There
// is one tree for each class of lengths between powers of two, so that one long segment does not widen every
// search. All of it happens in coordinates in which the region of interest has about unit size.

#include <array>
#include <cmath>
#include <memory>
#include <nanoflann.hpp>

#include "engine/geometry/index/block_search.hpp"
#include "engine/geometry/index/search.hpp"

namespace lober::detail {
namespace {

// Half lengths outside 2^-60 .. 2^500 are not told apart: below lies the rounding error of unit size, above
// it squares overflow, and such segments are candidates for everything.
constexpr int smallest_class = -60;
constexpr int largest_class = 500;
constexpr std::size_t points_per_tree_leaf = 16;

struct Midpoint {
  std::array<double, 2> at;
  double half_length;  // infinite when it cannot be handled

  [[nodiscard]] bool usable() const { return half_length < 0x1p500; }
};

// The scaled coordinates. Midpoints and half lengths are right to 2^-50 (1 + half length) for segments that
// meet the window.
class KdScale {
 public:
  explicit KdScale(const Box& window) : origin_{window.min_x(), window.min_y()} {
    int exponent = 0;
    std::frexp(std::max(window.width(), window.height()), &exponent);
    scale_ = std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
  }
  [[nodiscard]] Midpoint midpoint(const Segment& ends) const {
    const Point a = scaled(ends.a), b = scaled(ends.b);
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double half_length = std::sqrt(dx * dx + dy * dy) / 2;
    if (!(half_length < 0x1p500)) return {{0, 0}, INFINITY};
    return {{(a.x + b.x) / 2, (a.y + b.y) / 2}, half_length};
  }

 private:
  [[nodiscard]] Point scaled(Point point) const {
    return {(point.x - origin_.x) * scale_, (point.y - origin_.y) * scale_};
  }
  Point origin_;
  double scale_ = 1;
};

// Segments of about one length with their tree. The member functions are those that nanoflann asks for.
class LengthClass {
 public:
  void add(std::uint32_t segment, const Midpoint& midpoint) {
    segments_.push_back(segment);
    midpoints_.push_back(midpoint.at);
    half_length_ = std::max(half_length_, midpoint.half_length);
  }
  void build() {
    tree_ = std::make_unique<Tree>(2, *this, nanoflann::KDTreeSingleIndexAdaptorParams(points_per_tree_leaf));
  }

  /// Calls found(segment) for every segment that may have a point in common with one of that midpoint.
  template <typename Found>
  void search(const Midpoint& midpoint, const Found& found) const {
    const double radius = (midpoint.half_length + half_length_) * (1 + 0x1p-36) + 0x1p-48;
    if (distance_to_box_squared(midpoint.at) > radius * radius) return;
    struct Results {  // the interface of nanoflann's result sets
      const LengthClass& members;
      const Found& report;
      double radius_squared;
      std::size_t count = 0;
      [[nodiscard]] std::size_t size() const { return count; }
      [[nodiscard]] bool full() const { return true; }
      [[nodiscard]] double worstDist() const { return radius_squared; }
      bool addPoint(double, std::uint32_t index) {
        ++count;
        report(members.segments_[index]);
        return true;
      }
    } results{*this, found, radius * radius};
    tree_->findNeighbors(results, midpoint.at.data(), nanoflann::SearchParams());
  }
  [[nodiscard]] const Buffer<std::uint32_t>& segments() const { return segments_; }

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return midpoints_.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const { return midpoints_[index][axis]; }
  template <typename Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;  // let it compute them
  }

 private:
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, LengthClass>, LengthClass, 2>;

  // A search goes down to a leaf of the tree even when all of it is far away.
  [[nodiscard]] double distance_to_box_squared(const std::array<double, 2>& point) const {
    double sum = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double below = tree_->root_bbox[axis].low - point[axis], above = point[axis] - tree_->root_bbox[axis].high;
      const double distance = std::max({below, above, 0.0});
      sum += distance * distance;
    }
    return sum;
  }

  Buffer<std::uint32_t> segments_;
  Buffer<std::array<double, 2>> midpoints_;
  double half_length_ = 0;
  std::unique_ptr<Tree> tree_;
};

class Forest {
 public:
  Forest(const IndexedCurve& curve, const Box& window) : curve_(curve), frame_(window) {
    std::array<std::unique_ptr<LengthClass>, largest_class - smallest_class + 1> by_exponent;
    for (std::size_t leaf = 0; leaf < curve.tree().leaves(); ++leaf) {
      for_each_segment_of_leaf(curve.tree(), leaf, window, [&](std::uint32_t segment, const Segment& ends) {
        const Midpoint midpoint = frame_.midpoint(ends);
        if (!midpoint.usable()) {
          unusable_.push_back(segment);
          return;
        }
        int exponent = 0;
        std::frexp(midpoint.half_length, &exponent);
        auto& members = by_exponent[static_cast<std::size_t>(std::max(exponent, smallest_class) - smallest_class)];
        if (!members) members = std::make_unique<LengthClass>();
        members->add(segment, midpoint);
      });
    }
    for (auto& members : by_exponent) {
      if (members) classes_.push_back(std::move(members));
    }
    for_each_block(classes_.size(), 1, [&](std::size_t k, std::size_t) { classes_[k]->build(); });
  }

  // Appends the segments whose boxes meet `box` out of those near a segment; returns how many were near.
  std::size_t find(const Segment& ends, const Box& box, Buffer<std::uint32_t>& candidates) const {
    std::size_t near = 0;
    const auto consider = [&](std::uint32_t segment) {
      ++near;
      const Segment other = curve_.view().segment(segment);
      if (meet(box, Box::of(other.a, other.b))) candidates.push_back(segment);
    };
    std::for_each(unusable_.begin(), unusable_.end(), consider);
    const Midpoint midpoint = frame_.midpoint(ends);
    for (const auto& members : classes_) {
      if (midpoint.usable()) {
        members->search(midpoint, consider);
      } else {
        std::for_each(members->segments().begin(), members->segments().end(), consider);
      }
    }
    return near + classes_.size();
  }

 private:
  const IndexedCurve& curve_;
  KdScale frame_;
  std::vector<std::unique_ptr<LengthClass>> classes_;
  Buffer<std::uint32_t> unusable_;
};

}  // namespace

SearchCounts find_pairs_by_kd(const IndexedCurve& first, const IndexedCurve& second, PairConsumer& consumer) {
  const Box& box = second.tree().box();
  if (!meet(first.tree().box(), box)) return search_nothing(first.tree());
  const Box window = intersection(first.tree().box(), box);
  const Forest forest(second, window);
  return search_blocks(first.tree(), window, consumer, [&] {
    return [&](const Segment& ends, const Box& ends_box, Buffer<std::uint32_t>& candidates) {
      return forest.find(ends, ends_box, candidates);
    };
  });
}

}  // namespace lober::detail
