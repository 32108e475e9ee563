#include "kernels/elementary.hpp"
#include "lober/dynamics/tubes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/dynamics/escape/state_index.hpp"
#include "engine/dynamics/escape/work_meter.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/point.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober {
using namespace detail;
namespace {

LocalManifold local_manifold_of(const Flow& flow, const PeriodicOrbit& orbit, ManifoldSide side,
                                const IntegrationOptions& options) {
  IntegrationOptions near = options;
  near.max_time = std::min(options.max_time, 10 * orbit.period);
  const auto map = flow.section_map(orbit.local, orbit.energy, near);
  LocalManifoldOptions local;
  local.degree = 24;
  return local_manifold(*map, orbit.at, side, local);
}

// A few trajectories, evenly spread.
constexpr std::size_t scouts = 16;
std::array<double, scouts> scout_parameters() {
  std::array<double, scouts> u{};
  for (std::size_t k = 0; k < scouts; ++k) u[k] = static_cast<double>(k) / scouts;
  return u;
}

}  // namespace

Section position_section(const Flow& flow, int coordinate, double value, int direction) {
  const auto pairs = flow.conjugate_pairs();
  if (flow.dimension() != 4 || pairs.size() != 2) {
    throw UsageError("sections of tubes need a Hamiltonian flow of two degrees of freedom");
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (pairs[k].q != coordinate) continue;
    Section section;
    section.coordinate = coordinate;
    section.value = value;
    section.direction = direction;
    section.chart_x = pairs[1 - k].q;
    section.chart_y = pairs[1 - k].p;
    section.solved = pairs[k].p;
    return section;
  }
  throw UsageError("the section must be across a coordinate of position");
}

Tube::Tube(const Flow& flow, const PeriodicOrbit& orbit, ManifoldSide side, const IntegrationOptions& options)
    : flow_(flow), orbit_(orbit), options_(options), local_(local_manifold_of(flow, orbit, side, options)) {}

void Tube::begin(Branch branch, std::span<const double> u, std::span<FlowState> states) const {
  const double reach = static_cast<int>(branch) * local_.reach, log_multiplier = elementary::log(local_.multiplier);
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double s = reach * elementary::exp((u[k] - 1) * log_multiplier);
    states[k] = flow_.on_section(orbit_.local, orbit_.energy, local_.at(s));
  }
}

std::uint64_t Tube::crossings(Branch branch, const Section& section, int k, std::span<const double> u,
                              std::span<FlowState> states) const {
  begin(branch, u, states);
  return flow_.to_section(states, {}, section, side() == ManifoldSide::unstable ? k : -k, options_);
}

std::optional<Branch> Tube::branch_towards(const Section& section) const {
  const auto u = scout_parameters();
  double soonest = std::numeric_limits<double>::infinity();
  std::optional<Branch> best;
  for (const Branch branch : {Branch::plus, Branch::minus}) {
    std::array<FlowState, scouts> states;
    std::array<double, scouts> times{};
    begin(branch, u, states);
    flow_.to_section(states, times, section, side() == ManifoldSide::unstable ? 1 : -1, options_);
    double latest = 0;
    for (const double time : times) latest = std::isfinite(time) ? std::max(latest, std::fabs(time)) : INFINITY;
    if (latest < soonest) {
      soonest = latest;
      best = branch;
    }
  }
  return best;
}

int Tube::direction_of(Branch branch, const Section& section, int k) const {
  const auto u = scout_parameters();
  std::array<FlowState, scouts> states;
  crossings(branch, section, k, u, states);
  int direction = 0;
  for (const FlowState& state : states) {
    if (!std::isfinite(state[0])) continue;
    const int here = flow_.velocity(state, 0)[state_index(section.coordinate)] < 0 ? -1 : 1;
    if (direction != 0 && direction != here) return 0;
    direction = here;
  }
  return direction;
}

// The area between the curve and its position without the errors of the integration and of the local manifold. The
// former are measured at a few points, by integrating ten times less accurately; the latter move the whole tube, and
// the flow keeps the area between.
double Tube::displacement_area(Branch branch, const Section& section, int k, const CurveImage& image) const {
  constexpr std::size_t samples = 64;
  constexpr double coarser = 10;
  std::array<double, samples> u{};
  std::array<std::size_t, samples> vertex{};
  const std::size_t size = image.points.size();
  for (std::size_t j = 0; j < samples; ++j) {
    vertex[j] = j * size / samples;
    u[j] = image.parameters[vertex[j]];
  }
  std::array<FlowState, samples> states;
  begin(branch, u, states);
  IntegrationOptions options = options_;
  options.tolerance *= coarser;
  flow_.to_section(states, {}, section, side() == ManifoldSide::unstable ? k : -k, options);
  double area = 0;
  for (std::size_t j = 0; j < samples; ++j) {
    const Point here = image.points[vertex[j]], after = image.points[(vertex[j] + 1) % size];
    const Point off{states[j][state_index(section.chart_x)] - here.x, states[j][state_index(section.chart_y)] - here.y};
    const Point along{after.x - here.x, after.y - here.y};
    const double across = std::fabs(off.x * along.y - off.y * along.x) / std::max(length(along), 1e-300);
    double arc = 0;  // that this sample stands for
    const std::size_t end = j + 1 < samples ? vertex[j + 1] : size;
    for (std::size_t i = vertex[j]; i < end; ++i) arc += distance(image.points[i], image.points[(i + 1) % size]);
    area += across * arc;
  }
  double own = 1, far = 1;
  for (const ConjugatePair& pair : flow_.conjugate_pairs()) {
    if (pair.q == orbit_.local.chart_x) own = std::fabs(pair.factor);
    if (pair.q == section.chart_x) far = std::fabs(pair.factor);
  }
  return area + local_.defect_across * local_.reach * own / far;
}

TubeCurve Tube::curve(Branch branch, const Section& section, int k, const TubeCurve* before,
                      const TubeCurveOptions& options) const {
  WorkMeter work(options.max_work);
  const CurveSequence sequence = [&](int, std::span<const double> u, std::span<Point> points) {
    std::vector<FlowState> states(u.size());
    work.add(crossings(branch, section, k, u, states));
    for (std::size_t i = 0; i < u.size(); ++i) {
      points[i] = {states[i][state_index(section.chart_x)], states[i][state_index(section.chart_y)]};
    }
  };
  ImageOptions tracing;
  tracing.tolerance = options.tolerance;
  tracing.max_points = options.max_points;
  tracing.progress = [&](const GrowthProgress&) { return !work.spent() && options.progress(std::string()); };
  std::vector<double> guide;
  if (before != nullptr) {
    guide.assign(before->image.parameters.begin(), before->image.parameters.end());
    guide.push_back(1);
  }
  const std::array<double, 2> ends{0, 1};
  TubeCurve curve;
  curve.out_of_work = !work.within([&] {
    curve.image = std::move(images_of(
        sequence, ends, tracing, [](const CurveImage&) { return false; }, guide)[0]);
  });
  curve.work = work.done();
  if (curve.out_of_work) return curve;
  curve.direction = direction_of(branch, section, k);
  curve.complete =
      curve.image.diagnostics.empty() && curve.image.stop != GrowthStop::points && curve.image.points.size() >= 8;
  if (curve.complete) {
    const SmoothArea area = smooth_area(ClosedCurve::borrow(curve.image.points));
    curve.area = std::fabs(area.area);
    curve.displacement_area = displacement_area(branch, section, k, curve.image);
    curve.area_error = area.error + curve.displacement_area;
  }
  return curve;
}

double Tube::area_by_action(const Section& section) const {
  for (const ConjugatePair& pair : flow_.conjugate_pairs()) {
    if (pair.q == section.chart_x) return std::fabs(orbit_.action / pair.factor);
  }
  throw UsageError("the section's chart is not a conjugate pair");
}

}  // namespace lober
