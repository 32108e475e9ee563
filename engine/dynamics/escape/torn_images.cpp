#include "engine/dynamics/escape/torn_images.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "engine/base/parallel/parallel.hpp"
#include "lober/error.hpp"
#include "lober/index.hpp"

namespace lober {
namespace {

// From 0 to 1, slow at both ends: there torn curves wind about a tube, each turn in a fraction 1 / multiplier of what
// is left.
constexpr double grading = 30;
double graded(double t) {
  return t <= 0.5 ? 0.5 * std::expm1(2 * grading * t) / std::expm1(grading) : 1 - graded(1 - t);
}
double ungraded(double g) {
  return g <= 0.5 ? std::log1p(2 * g * std::expm1(grading)) / (2 * grading) : 1 - ungraded(1 - g);
}

// A stretch of trajectories of a tube or a rim.
struct Arc {
  bool rim = false;
  std::size_t neck = 0;
  int born = 0;  // rims: the image at which they lay about X
  double from = 0, to = 1;
  bool graded_ends = false;

  [[nodiscard]] double at(double t) const {
    if (!graded_ends) return from + t * (to - from);
    return t <= 0.5 ? from + (to - from) * graded(t) : to - (to - from) * graded(1 - t);
  }
  [[nodiscard]] double parameter_of(double u) const {
    if (to == from) return 0;
    const double g = std::clamp((u - from) / (to - from), 0.0, 1.0), h = std::clamp((to - u) / (to - from), 0.0, 1.0);
    if (!graded_ends) return g;
    return g <= h ? ungraded(g) : 1 - ungraded(h);
  }
};

struct Gate {
  std::size_t neck;
  CurveImage rim;
  std::unique_ptr<IndexedCurve> index;
  Point middle;  // inside
};

Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace

class TornImages::Tearing {
 public:
  Tearing(const Flow& flow, const Section& section, std::span<const NeckTubes> necks, std::size_t neck, bool entry,
          const TubeCurve& last, int level, const IntegrationOptions& integration, const TornOptions& options)
      : flow_(flow),
        section_(section),
        necks_(necks.begin(), necks.end()),
        entry_(entry),
        integration_(integration),
        options_(options) {
    tracing_.tolerance = options.tracing.tolerance;
    tracing_.most_points = options.tracing.most_points;
    if (options.tracing.progress)
      tracing_.progress = [this](const GrowthProgress&) { return options_.tracing.progress(); };
    arcs_.push_back({false, neck, 0, 0, 1, false});
    for (std::size_t j = 0; j < necks.size(); ++j) rims_.push_back(rim_of(j));
    for (std::size_t j = 0; j < necks.size(); ++j) gates_.push_back(gate(j));
    level_ = level;
    direction_ = last.direction;
    sample(last);
  }

  std::size_t prepare() {
    if (prepared_) return guide_.size();
    for (const Gate& gate : gates_) {
      const NeckTubes& neck = necks_[gate.neck];
      if ((entry_ ? neck.exit_direction : neck.entry_direction) != direction_) continue;
      if (!guide_.empty()) sample(traced());  // another gate on this side has changed the curve
      if (cut(gate)) lost_ += options_.strip;
    }
    ++level_;
    direction_ = -direction_;
    prepared_ = true;
    return guide_.empty() ? parameters_.size() : guide_.size();
  }

  std::optional<TubeCurve> next() {
    prepare();
    prepared_ = false;
    TubeCurve result = traced();
    result.direction = direction_;
    result.cut_off = lost_;
    // Where the ends wind closely, errors of the integration make small jumps that no refinement removes.
    const bool failed = std::any_of(result.image.flaws.begin(), result.image.flaws.end(),
                                    [](const GrowthFlaw& flaw) { return flaw.cause == GrowthFlawCause::failed; });
    out_of_points_ = result.image.stop == GrowthStop::points;
    if (failed || out_of_points_) return std::nullopt;
    sample(result);
    return result;
  }
  [[nodiscard]] bool out_of_points() const { return out_of_points_; }

 private:
  // The present curve is known at these points.
  void sample(const TubeCurve& curve) {
    points_.assign(curve.image.points.begin(), curve.image.points.end());
    parameters_.assign(curve.image.parameters.begin(), curve.image.parameters.end());
  }

  // s w = I (1 + small) next to the orbit, with w and s both near the square root of I: a turn of the trajectories that
  // pass there. Sums of points of the two local manifolds are no exact coordinates, so that turn and product are
  // adapted until the end of a turn is the image of its beginning.
  struct Rim {
    double product = 0, log_multiplier = 0, widest = 0;
    double turn = 1, growth = 0;
  };

  [[nodiscard]] Point rim_point(std::size_t j, const Rim& rim, double part) const {
    const NeckTubes& neck = necks_[j];
    const LocalManifold &stable = neck.stable->local(), &unstable = neck.unstable->local();
    const double v = part * rim.turn, w = rim.widest * std::exp((v - 1) * rim.log_multiplier);
    const double s = rim.product * std::exp(rim.growth * v) / w;
    const Point a = stable.at(static_cast<int>(neck.out) * w), b = unstable.at(static_cast<int>(neck.in) * s);
    return {a.x + b.x - unstable.saddle.x, a.y + b.y - unstable.saddle.y};
  }

  [[nodiscard]] Rim rim_of(std::size_t j) const {
    const NeckTubes& neck = necks_[j];
    const PeriodicOrbit& orbit = neck.stable->orbit();
    Rim rim;
    rim.product = product_of(j);
    rim.log_multiplier = std::log(neck.stable->local().multiplier);
    rim.widest = std::sqrt(rim.product * neck.stable->local().multiplier);
    const auto map = flow_.section_map(orbit.local, orbit.energy, integration_);
    const Point along_w = neck.stable->local().tangent, along_s = neck.unstable->local().tangent;
    const double sine = cross(along_w, along_s);
    const double w = static_cast<int>(neck.out) * rim.widest * std::exp(-rim.log_multiplier);
    const double s = rim.product / w * static_cast<int>(neck.in) * static_cast<int>(neck.out);
    for (int round = 0; round < 8; ++round) {
      Point image = rim_point(j, rim, 1);
      map->iterate({&image, 1}, 1);
      const Point r = image - rim_point(j, rim, 0);
      const double off_w = std::log1p(cross(r, along_s) / sine / w), off_s = std::log1p(cross(along_w, r) / sine / s);
      if (!std::isfinite(off_w) || !std::isfinite(off_s)) throw DataError("the rim of a tube could not be closed");
      rim.turn -= off_w / rim.log_multiplier;
      rim.growth -= off_s + off_w;
    }
    return rim;
  }

  // Where the trajectories of a rim begin.
  void begin_rim(std::size_t j, std::span<const double> u, std::span<FlowState> states) const {
    const PeriodicOrbit& orbit = necks_[j].stable->orbit();
    for (std::size_t k = 0; k < u.size(); ++k) {
      // The whole turn [0, 1] in one piece.
      const double part = u[k] == 1 ? 1 : u[k] - std::floor(u[k]);
      states[k] = flow_.on_section(orbit.local, orbit.energy, rim_point(j, rims_[j], part));
    }
  }
  // s w = I of the strip: its area is I log(multiplier) in units of both tangents, on the local section.
  [[nodiscard]] double product_of(std::size_t j) const {
    const LocalManifold &s = necks_[j].stable->local(), &w = necks_[j].unstable->local();
    const PeriodicOrbit& orbit = necks_[j].stable->orbit();
    double own = 1, far = 1;
    for (const ConjugatePair& pair : flow_.conjugate_pairs()) {
      if (pair.q == orbit.local.chart_x) own = std::fabs(pair.factor);
      if (pair.q == section_.chart_x) far = std::fabs(pair.factor);
    }
    return options_.strip * far / (own * std::log(s.multiplier) * std::fabs(cross(s.tangent, w.tangent)));
  }

  void evaluate(const Arc& arc, int level, std::span<const double> u, std::span<Point> points) const {
    std::vector<FlowState> states(u.size());
    if (arc.rim) {
      begin_rim(arc.neck, u, states);
      const int crossing = level == arc.born ? -1 : level - arc.born;
      flow_.to_section(states, {}, section_, entry_ ? crossing : -crossing, integration_);
    } else {
      const NeckTubes& neck = necks_[arc.neck];
      const Tube& tube = entry_ ? *neck.unstable : *neck.stable;
      tube.crossings(entry_ ? neck.in : neck.out, section_, level + 1, u, states);
    }
    for (std::size_t k = 0; k < u.size(); ++k) {
      points[k] = {states[k][static_cast<std::size_t>(section_.chart_x)],
                   states[k][static_cast<std::size_t>(section_.chart_y)]};
    }
  }
  // The whole curve at parameters: number of the arc + parameter on it.
  void evaluate(std::span<const double> parameters, std::span<Point> points) const {
    for (std::size_t k = 0; k < parameters.size();) {
      const std::size_t arc = arc_of(parameters[k]);
      std::vector<double> u;
      std::size_t end = k;
      for (; end < parameters.size() && arc_of(parameters[end]) == arc; ++end) {
        u.push_back(arcs_[arc].at(parameters[end] - static_cast<double>(arc)));
      }
      evaluate(arcs_[arc], level_, u, points.subspan(k, end - k));
      k = end;
    }
  }
  [[nodiscard]] std::size_t arc_of(double parameter) const {
    return std::min(static_cast<std::size_t>(parameter), arcs_.size() - 1);
  }
  [[nodiscard]] Point at(double parameter) const {
    const double size = static_cast<double>(arcs_.size());
    parameter -= size * std::floor(parameter / size);
    Point point;
    evaluate({&parameter, 1}, {&point, 1});
    return point;
  }

  [[nodiscard]] Gate gate(std::size_t j) const {
    Gate gate{j, {}, nullptr, {}};
    const Arc arc{true, j, 0, 0, 1, false};
    const CurveSequence curve = [&](int, std::span<const double> u, std::span<Point> points) {
      evaluate(arc, 0, u, points);
    };
    const std::array<double, 2> ends{0, 1};
    gate.rim = std::move(images_of(curve, ends, tracing_, [](const CurveImage&) { return false; })[0]);
    if (!gate.rim.flaws.empty()) throw DataError("the rim of a tube could not be followed to the section");
    gate.index = std::make_unique<IndexedCurve>(CurveView(gate.rim));
    for (const Point& p : gate.rim.points) {
      gate.middle.x += p.x / static_cast<double>(gate.rim.points.size());
      gate.middle.y += p.y / static_cast<double>(gate.rim.points.size());
    }
    return gate;
  }

  struct Crossing {
    double parameter;  // on the curve
    double u;          // on the rim
  };

  // Newton's method for c(parameter) = rim(u), with difference quotients, from segment k and the nearest rim vertex.
  [[nodiscard]] Crossing crossing_in(const Gate& gate, std::size_t k) const {
    const double size = static_cast<double>(arcs_.size());
    const double from = parameters_[k];
    double to = k + 1 < parameters_.size() ? parameters_[k + 1] : size;
    const Arc rim{true, gate.neck, level_, 0, 1, false};
    const auto on_rim = [&](double u) {
      Point p;
      evaluate(rim, level_, {&u, 1}, {&p, 1});
      return p;
    };
    Crossing at_best{0.5 * (from + to), 0};
    const Point guess = at(at_best.parameter);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < gate.rim.points.size(); ++i) {
      const double distance = std::hypot(gate.rim.points[i].x - guess.x, gate.rim.points[i].y - guess.y);
      if (distance < nearest) {
        nearest = distance;
        at_best.u = gate.rim.parameters[i];
      }
    }
    Crossing here = at_best;
    double best = std::numeric_limits<double>::infinity();
    const double step = 1e-3 * (to - from), turn = 1e-5;
    for (int round = 0; round < 20; ++round) {
      const Point p = at(here.parameter), q = on_rim(here.u), r = p - q;
      const double size_of_rest = std::hypot(r.x, r.y);
      if (!(size_of_rest < best)) break;
      best = size_of_rest;
      at_best = here;
      const Point p2 = at(here.parameter + step), q2 = on_rim(here.u + turn);
      const Point along{(p2.x - p.x) / step, (p2.y - p.y) / step}, around{(q2.x - q.x) / turn, (q2.y - q.y) / turn};
      const double sine = cross(along, around);
      if (sine == 0 || !std::isfinite(sine)) break;
      // p + a along = q + b around
      here.parameter -= std::clamp(cross(r, around) / sine, from - to, to - from);
      here.u -= std::clamp(cross(r, along) / sine, -0.1, 0.1);
      here.parameter = std::clamp(here.parameter, from - 2 * (to - from), to + 2 * (to - from));
    }
    at_best.parameter -= size * std::floor(at_best.parameter / size);
    at_best.u -= std::floor(at_best.u);
    return at_best;
  }

  // Replaces what lies in the gate by stretches of its rim. False: nothing does.
  bool cut(const Gate& gate) {
    std::vector<char> inside(points_.size());
    for_each_block(points_.size(), 512, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) inside[k] = encloses(*gate.index, points_[k]);
    });
    const std::size_t count = points_.size();
    std::vector<std::size_t> enters, leaves;  // segments
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = k + 1 < count ? k + 1 : 0;
      if (!inside[k] && inside[next]) enters.push_back(k);
      if (inside[k] && !inside[next]) leaves.push_back(k);
    }
    if (leaves.empty()) return false;
    // Begin with a way out, so that stretches are leaves[i] ... enters[i].
    if (enters[0] < leaves[0]) std::rotate(enters.begin(), enters.begin() + 1, enters.end());
    std::vector<Crossing> out(leaves.size()), in(leaves.size());
    for_each_block(2 * leaves.size(), 1, [&](std::size_t k, std::size_t) {
      (k % 2 == 0 ? out : in)[k / 2] = crossing_in(gate, k % 2 == 0 ? leaves[k / 2] : enters[k / 2]);
    });
    std::vector<Arc> arcs;
    std::vector<double> guide;
    std::vector<std::size_t> rims;
    double turns = 0;  // of what is kept and the rims, about the middle
    for (std::size_t i = 0; i < out.size(); ++i) {
      turns += turns_outside(leaves[i], enters[i], gate.middle);
      keep(out[i].parameter, in[i].parameter, arcs, guide);
      const Crossing& next = out[(i + 1) % out.size()];
      double way = next.u - in[i].u;
      way -= std::round(way);
      rims.push_back(arcs.size());
      arcs.push_back({true, gate.neck, level_, in[i].u, in[i].u + way, false});
      turns += way * orientation_of(gate);
      add_guide(arcs.size() - 1, {}, guide);
    }
    // Small gaps between vertices and crossings do not matter to a whole number.
    const double excess = std::round(turns);
    arcs[rims[0]].to -= excess * orientation_of(gate);
    arcs_ = std::move(arcs);
    guide_ = std::move(guide);
    guide_.push_back(static_cast<double>(arcs_.size()));
    return true;
  }

  [[nodiscard]] static double orientation_of(const Gate& gate) { return signed_area(CurveView(gate.rim)) > 0 ? 1 : -1; }

  // From segment `leave` to segment `enter` along the polygon.
  [[nodiscard]] double turns_outside(std::size_t leave, std::size_t enter, Point middle) const {
    double angle = 0;
    const std::size_t count = points_.size();
    std::size_t k = leave + 1 < count ? leave + 1 : 0;
    while (k != enter) {
      const std::size_t next = k + 1 < count ? k + 1 : 0;
      const Point a = points_[k] - middle, b = points_[next] - middle;
      angle += std::atan2(cross(a, b), a.x * b.x + a.y * b.y);
      k = next;
    }
    return angle / (2 * std::numbers::pi);
  }

  // The arcs between two parameters of the curve, the second one later, if need be after a round.
  void keep(double from, double to, std::vector<Arc>& arcs, std::vector<double>& guide) const {
    const auto size = arcs_.size();
    if (to <= from) to += static_cast<double>(size);
    for (auto number = static_cast<std::size_t>(from); static_cast<double>(number) < to; ++number) {
      const Arc& old = arcs_[number % size];
      const double begin = std::max(from - static_cast<double>(number), 0.0);
      const double end = std::min(to - static_cast<double>(number), 1.0);
      if (!(begin < end)) continue;
      Arc arc = old;
      arc.from = old.at(begin);
      arc.to = old.at(end);
      arc.graded_ends = true;
      arcs.push_back(arc);
      // Where the curve needed points, its image does.
      std::vector<double> known;
      const double base = static_cast<double>(number % size);
      const auto first = std::upper_bound(parameters_.begin(), parameters_.end(), base + begin);
      const auto last = std::lower_bound(parameters_.begin(), parameters_.end(), base + end);
      for (auto at = first; at < last; ++at) known.push_back(arc.parameter_of(old.at(*at - base)));
      add_guide(arcs.size() - 1, std::move(known), guide);
    }
  }

  static void add_guide(std::size_t arc, std::vector<double> known, std::vector<double>& guide) {
    constexpr int evenly = 256;
    for (int k = 0; k < evenly; ++k) known.push_back(static_cast<double>(k) / evenly);
    std::sort(known.begin(), known.end());
    double before = -1;
    for (const double t : known) {
      if (!(t >= 0 && t < 1 - 1e-9) || !(t - before > 1e-9)) continue;
      guide.push_back(static_cast<double>(arc) + t);
      before = t;
    }
  }

  [[nodiscard]] TubeCurve traced() {
    std::vector<double> corners(arcs_.size() + 1);
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = static_cast<double>(k);
    if (guide_.empty()) {  // not cut: as before
      guide_ = parameters_;
      guide_.push_back(static_cast<double>(arcs_.size()));
    }
    const CurveSequence curve = [&](int, std::span<const double> t, std::span<Point> points) { evaluate(t, points); };
    TubeCurve result;
    result.image = std::move(images_of(
        curve, corners, tracing_, [](const CurveImage&) { return false; }, guide_)[0]);
    result.torn = true;
    guide_.clear();
    return result;
  }

  const Flow& flow_;
  Section section_;
  std::vector<NeckTubes> necks_;
  bool entry_;
  IntegrationOptions integration_;
  TornOptions options_;
  ImageOptions tracing_;
  std::vector<Rim> rims_;
  std::vector<Gate> gates_;
  // The present curve: arcs, where it was sampled, and where its image shall be.
  int level_ = 0, direction_ = 0;
  bool out_of_points_ = false;
  bool prepared_ = false;  // for the next image
  double lost_ = 0;        // area that was cut off so far
  std::vector<Arc> arcs_;
  std::vector<double> parameters_, guide_;
  std::vector<Point> points_;
};

TornImages::TornImages(const Flow& flow, const Section& section, std::span<const NeckTubes> necks, std::size_t neck,
                       bool entry, const TubeCurve& last, int level, const IntegrationOptions& integration,
                       const TornOptions& options)
    : tearing_(std::make_unique<Tearing>(flow, section, necks, neck, entry, last, level, integration, options)) {}

TornImages::~TornImages() = default;

std::size_t TornImages::prepare() {
  return tearing_->prepare();
}

std::optional<TubeCurve> TornImages::next() {
  return tearing_->next();
}

bool TornImages::out_of_points() const {
  return tearing_->out_of_points();
}

}  // namespace lober
