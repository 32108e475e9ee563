#include "cli/densified_curve.hpp"

#include <cstddef>
#include <span>

namespace lober::cli {
namespace {

// Parameters to insert into (low, high), in order. `held` are those of the intersections in [low, high).
void insert(double low, double high, std::span<const SideChange> held, Densification densification,
            std::vector<double>& parameters) {
  const double step = (high - low) / (densification.points + 1);
  constexpr double finest = 0x1p-52;  // beyond, neighbours would be the same point
  if (densification.passes == 0 || densification.points == 0 || held.empty() || step < finest) return;
  double from = low;
  for (int k = 1; k <= densification.points + 1; ++k) {
    const bool last = k > densification.points;
    const double to = last ? high : low + k * step;
    std::size_t here = 0;
    while (here < held.size() && (last || held[here].at.t < to)) ++here;
    insert(from, to, held.first(here), {densification.passes - 1, densification.points}, parameters);
    held = held.subspan(here);
    if (!last) parameters.push_back(to);
    from = to;
  }
}

Point between(Point a, Point b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace

std::vector<LabelledPoint> densified_curve(const Crossings& nodes, int curve, Densification densification) {
  const CurveView& view = curve == 1 ? nodes.curve1() : nodes.curve2();
  const Buffer<Side> labels = label_vertices(nodes, curve);
  const std::vector<SideChange> changes = side_changes(nodes, curve);
  std::vector<LabelledPoint> points;
  points.reserve(labels.size() + changes.size());
  std::vector<double> inserted;
  std::size_t next = 0;
  for (std::size_t vertex = 0; vertex < labels.size(); ++vertex) {
    points.push_back({view.points[vertex], labels[vertex]});
    const std::size_t first = next;
    while (next < changes.size() && changes[next].at.segment == vertex) ++next;
    if (first == next) continue;
    const std::span<const SideChange> here = std::span(changes).subspan(first, next - first);
    inserted.clear();
    insert(0, 1, here, densification, inserted);
    Side side = changes[first == 0 ? changes.size() - 1 : first - 1].side;
    const Point a = view.points[vertex], b = view.points[vertex + 1 == labels.size() ? 0 : vertex + 1];
    std::size_t place = 0;
    const auto insert_before = [&](double end) {
      for (; place < inserted.size() && inserted[place] < end; ++place) {
        points.push_back({between(a, b, inserted[place]), side});
      }
    };
    for (const SideChange& change : here) {
      insert_before(change.at.t);
      if (place < inserted.size() && inserted[place] == change.at.t) ++place;  // the intersection itself
      if (!change.at_vertex) points.push_back({change.point, Side::on});
      side = change.side;
    }
    insert_before(1);
  }
  return points;
}

}  // namespace lober::cli
