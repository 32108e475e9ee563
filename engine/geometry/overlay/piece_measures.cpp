// Centroids of pieces, and which pieces are only noise.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/overlay/boundary.hpp"
#include "engine/geometry/overlay/pieces_data.hpp"
#include "kernels/box.hpp"
#include "kernels/moments.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t few_points = 256;  // pieces worth writing out and summing one by one
constexpr std::size_t steps_at_once = 512, points_at_once = std::size_t{1} << 13;

// Coordinates are multiplied by `factor`, a power of two, then `origin` is taken away.
struct MomentFrame {
  Point origin;
  double factor = 1;
  [[nodiscard]] static MomentFrame at(Point point, double factor) {
    return {{point.x * factor, point.y * factor}, factor};
  }
};

Moments of_polygon(std::span<const Point> polygon, const MomentFrame& frame) {
  Moments sum;
  Point before = polygon.back();
  for (const Point& point : polygon) {
    sum += moments_of_segment(before, point, frame.origin, frame.factor);
    before = point;
  }
  return sum;
}

// Sums over vertices that follow each other on a curve; long ones in parallel, joined in order.
Moments of_run(std::span<const Point> run, const MomentFrame& frame) {
  if (run.size() < 2) return {};
  const std::size_t segments = run.size() - 1;
  std::vector<Moments> parts((segments + points_at_once - 1) / points_at_once);
  for_each_block(segments, points_at_once, [&](std::size_t begin, std::size_t end) {
    parts[begin / points_at_once] = moments_along(&run[begin], end - begin, frame.origin, frame.factor);
  });
  Moments sum;
  for (const Moments& part : parts) sum += part;
  return sum;
}

// A part of a walk, which may have no point.
struct RunOfSteps {
  Moments sum;
  std::optional<Point> first, last;

  void go_on(Point from, Point to, const Moments& inside, const MomentFrame& frame) {
    if (last) sum += moments_of_segment(*last, from, frame.origin, frame.factor);
    if (!first) first = from;
    sum += inside;
    last = to;
  }
  void go_on(const RunOfSteps& next, const MomentFrame& frame) {
    if (next.first) go_on(*next.first, *next.last, next.sum, frame);
  }
  void go_on(std::span<const Point> run, bool forward, const MomentFrame& frame) {
    if (run.empty()) return;
    const Moments inside = of_run(run, frame);
    if (forward) {
      go_on(run.front(), run.back(), inside, frame);
    } else {
      go_on(run.back(), run.front(), -inside, frame);
    }
  }
};

// Sums round a boundary, without writing its points out.
Moments of_boundary(const Overlay& result, std::span<const std::uint32_t> steps, Directions forward,
                    const MomentFrame& frame) {
  std::vector<RunOfSteps> parts((steps.size() + steps_at_once - 1) / steps_at_once);
  for_each_block(steps.size(), steps_at_once, [&](std::size_t begin, std::size_t end) {
    RunOfSteps& part = parts[begin / steps_at_once];
    for (const BoundaryArc& arc : boundary_arcs(result, steps, begin, end, forward)) {
      const ArcPoints points = points_of(result, arc);
      if (!points.whole) part.go_on(points.first, points.first, {}, frame);
      part.go_on(points.forward ? points.low : points.high, points.forward, frame);
      part.go_on(points.forward ? points.high : points.low, points.forward, frame);
    }
  });
  RunOfSteps whole;
  for (const RunOfSteps& part : parts) whole.go_on(part, frame);
  whole.go_on(*whole.first, *whole.first, {}, frame);
  return whole.sum;
}

// One piece of a result.
class PieceBoundary {
 public:
  PieceBoundary(const Overlay& result, Pairing pairing, std::size_t piece)
      : result_(result), pieces_(result.pieces(pairing).data()), forward_(directions(result, pairing)), piece_(piece) {
    const std::span<const std::uint32_t> outer = pieces_.outer(piece);
    std::size_t count = outer.size() > few_points ? outer.size() : count_points(result, outer, forward_);
    for (const PieceHole& hole : pieces_.holes_of(piece)) {
      if (count > few_points) break;
      count += hole.steps.size() > few_points ? hole.steps.size() : count_points(result, hole.steps, forward_);
    }
    if (count <= few_points) polygons_ = outline(result, pairing, piece);
  }

  [[nodiscard]] Point first() const {
    if (!polygons_.empty()) return polygons_[0][0];
    const ArcPoints points = points_of(result_, boundary_arcs(result_, pieces_.outer(piece_), 0, 1, forward_)[0]);
    if (!points.whole) return points.first;
    return points.forward ? points.low.front() : points.low.back();
  }

  [[nodiscard]] Moments moments(const MomentFrame& frame) const {
    Moments sum;
    if (!polygons_.empty()) {
      for (const std::vector<Point>& polygon : polygons_) sum += of_polygon(polygon, frame);
      return sum;
    }
    sum = of_boundary(result_, pieces_.outer(piece_), forward_, frame);
    for (const PieceHole& hole : pieces_.holes_of(piece_)) sum += of_boundary(result_, hole.steps, forward_, frame);
    return sum;
  }

  // Box of the outer boundary.
  [[nodiscard]] Box box() const {
    if (!polygons_.empty()) return box_of(polygons_[0]);
    Box box;
    const std::span<const std::uint32_t> steps = pieces_.outer(piece_);
    for (std::size_t k = 0; k < steps.size(); k += steps_at_once) {
      for (const BoundaryArc& arc :
           boundary_arcs(result_, steps, k, std::min(k + steps_at_once, steps.size()), forward_)) {
        const ArcPoints points = points_of(result_, arc);
        if (!points.whole) box = union_of(box, Box::of(points.first, points.first));
        box = union_of(union_of(box, box_of(points.low)), box_of(points.high));
      }
    }
    return box;
  }

 private:
  const Overlay& result_;
  const PiecesData& pieces_;
  Directions forward_;
  std::size_t piece_;
  std::vector<std::vector<Point>> polygons_;  // written out if there are few points, else empty
};

// Whether neither the third power of a length of the piece nor the error of any product has left the range of double.
bool in_range(const Moments& moments) {
  constexpr double least = 0x1p-500, most = 0x1p600;
  const double area = std::fabs(moments.area.hi);
  return area > least && area < most && std::fabs(moments.x.hi) < 0x1p900 && std::fabs(moments.y.hi) < 0x1p900;
}

// A power of two that brings the box to a size near 1.
double factor_for(const Box& box) {
  double size = 0;
  for (const double lane : box.lane) size = std::max(size, std::fabs(lane));
  const double width = 0.5 * box.max_x() - 0.5 * box.min_x(), height = 0.5 * box.max_y() - 0.5 * box.min_y();
  const double extent = std::max(width, height);
  if (extent == 0) return 1;
  // Coordinates may not overflow, were they ever so much larger than the box.
  constexpr int most = 1000;
  return std::ldexp(1.0, std::clamp(-std::ilogb(extent), -most, std::min(most, most - std::ilogb(size))));
}

double length(const std::vector<Point>& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &a = polygon[k], &b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    sum += std::hypot(b.x - a.x, b.y - a.y);
  }
  return sum;
}

}  // namespace

Point centroid(const Overlay& result, Pairing pairing, std::size_t piece) {
  const PieceBoundary boundary(result, pairing, piece);
  const Point first = boundary.first();
  MomentFrame frame = MomentFrame::at(first, 1);
  Moments moments = boundary.moments(frame);
  if (!in_range(moments)) {
    frame = MomentFrame::at(first, factor_for(boundary.box()));
    moments = boundary.moments(frame);
  }
  const DD below = DD{3, 0} * moments.area;
  if (below.hi == 0) return first;  // a piece so thin that its rounded vertices enclose nothing
  const auto coordinate = [&](double from, DD moment) { return (from + (moment / below).hi) / frame.factor; };
  return {coordinate(frame.origin.x, moments.x), coordinate(frame.origin.y, moments.y)};
}

std::vector<Point> centroids(const Overlay& result, Pairing pairing) {
  std::vector<Point> points(result.pieces(pairing).size());
  for_each_block(points.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) points[k] = centroid(result, pairing, k);
  });
  return points;
}

Slivers find_slivers(const Overlay& result, Pairing pairing) {
  const double ulp = result.largest_coordinate * std::numeric_limits<double>::epsilon();
  const double vertices = static_cast<double>(result.nodes.curve1().points.size()) +
                          static_cast<double>(result.nodes.curve2().points.size());
  const std::span<const double> areas = result.pieces(pairing).areas();
  Buffer<std::uint8_t> uncertain(areas.size());
  for_each_block(areas.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      uncertain[k] = 0;
      if (areas[k] > 2 * ulp * result.longest_segment * vertices) continue;
      // A piece between few nodes has few segments, mostly; only then is its outline worth walking.
      double perimeter = 0;
      for (const std::vector<Point>& polygon : outline(result, pairing, k)) perimeter += length(polygon);
      uncertain[k] = areas[k] <= 2 * ulp * perimeter;
    }
  });
  Slivers slivers;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (uncertain[k] == 0) continue;
    slivers.pieces.push_back(static_cast<std::uint32_t>(k));
    slivers.area += areas[k];
  }
  return slivers;
}

}  // namespace lober
