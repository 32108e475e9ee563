// One class, and a little longer than other files for that: every step works on the same arcs and samples.
#include "engine/dynamics/escape/cut_images.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/escape/trajectory_arc.hpp"
#include "engine/dynamics/escape/work_meter.hpp"
#include "kernels/elementary.hpp"
#include "kernels/point.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/index.hpp"

namespace lober::detail {

class CutImages::Cutting {
 public:
  Cutting(const Flow& flow, const Section& section, std::span<const BottleneckTubes> bottlenecks,
          std::size_t bottleneck, bool entry, const TubeCurve& last, int level, const IntegrationOptions& integration,
          const CutImageOptions& options)
      : flow_(flow),
        section_(section),
        bottlenecks_(bottlenecks.begin(), bottlenecks.end()),
        entry_(entry),
        integration_(integration),
        options_(options) {
    tracing_.tolerance = options.tracing.tolerance;
    tracing_.max_points = options.tracing.max_points;
    tracing_.progress = [this](const GrowthProgress&) {
      return !work_.spent() && options_.tracing.progress(std::string());
    };
    arcs_.push_back({false, bottleneck, 0, 0, 1, false});
    for (const BottleneckTubes& tubes : bottlenecks_) {
      regularising_curves_.emplace_back(flow, section, tubes, options.strip, integration);
    }
    for (std::size_t j = 0; j < bottlenecks.size(); ++j) exits_.push_back(make_exit(j));
    level_ = level;
    direction_ = last.direction;
    sample(last);
  }

  std::optional<std::size_t> prepare(double max_work) {
    if (!prepared_ && !within(max_work, [&] { cut(); })) return std::nullopt;
    return guide_.empty() ? parameters_.size() : guide_.size();
  }

  std::optional<TubeCurve> next(double max_work) {
    if (!prepare(max_work)) return std::nullopt;
    prepared_ = false;
    TubeCurve result;
    if (!within(max_work, [&] { result = traced(); })) return std::nullopt;
    result.direction = direction_;
    result.cut_off = lost_;
    const bool failed = std::any_of(
        result.image.diagnostics.begin(), result.image.diagnostics.end(),
        [](const GrowthDiagnostic& diagnostic) { return diagnostic.cause == GrowthDiagnosticCause::failed; });
    out_of_points_ = result.image.stop == GrowthStop::points;
    if (failed || out_of_points_ || result.image.points.size() < 3) return std::nullopt;
    result.displacement_area = area_at_jumps(result.image);
    sample(result);
    return result;
  }
  [[nodiscard]] bool out_of_points() const { return out_of_points_; }
  [[nodiscard]] bool out_of_work() const { return out_of_work_; }
  [[nodiscard]] double work() const { return work_.done(); }

 private:
  template <typename Function>
  bool within(double max_work, const Function& function) {
    work_.limit_to(work_.done() + max_work);
    out_of_work_ = !work_.within(function);
    return !out_of_work_;
  }

  void cut() {
    for (const Exit& exit : exits_) {
      const BottleneckTubes& bottleneck = bottlenecks_[exit.bottleneck];
      if ((entry_ ? bottleneck.exit_direction : bottleneck.entry_direction) != direction_) continue;
      if (!guide_.empty()) sample(traced());  // another exit on this side has changed the curve
      if (cut_at(exit)) lost_ += options_.strip;
    }
    ++level_;
    direction_ = -direction_;
    prepared_ = true;
  }

  // Where arcs of one curve wind next to an orbit, rounding of where they begin and end becomes a jump that no
  // refinement removes, and turns show one after the other: what may lie between both ends of such a segment. Half of
  // it was missed at most (capsize, energies from 0.28 to 0.7, tolerances from 1e-4 to 1e-6). More than E
  // holds is not due to rounding: there the section tears the curve, which no bar makes good and comparisons show.
  [[nodiscard]] double area_at_jumps(const CurveImage& image) const {
    constexpr double share = 2;  // share of the square over a jump
    double area = 0;
    for (const GrowthDiagnostic& diagnostic : image.diagnostics) {
      if (diagnostic.cause == GrowthDiagnosticCause::left_box) continue;
      for (std::size_t k = diagnostic.first; k < diagnostic.first + diagnostic.count; ++k) {
        const Point gap = image.points[(k + 1) % image.points.size()] - image.points[k];
        area += share * (gap.x * gap.x + gap.y * gap.y);
      }
    }
    return area < options_.area ? area : 0;
  }

  struct Exit {
    std::size_t bottleneck;
    CurveImage regularising_curve;
    std::unique_ptr<IndexedCurve> index;
    Point middle;  // inside
  };

  // The present curve is known at these points.
  void sample(const TubeCurve& curve) {
    points_.assign(curve.image.points.begin(), curve.image.points.end());
    parameters_.assign(curve.image.parameters.begin(), curve.image.parameters.end());
  }

  void evaluate(const TrajectoryArc& arc, int level, std::span<const double> u, std::span<Point> points) const {
    std::vector<FlowState> states(u.size());
    if (arc.of_regularising_curve) {
      for (std::size_t k = 0; k < u.size(); ++k) states[k] = regularising_curves_[arc.bottleneck].state(u[k]);
      const int crossing = level == arc.born ? -1 : level - arc.born;
      work_.add(flow_.to_section(states, {}, section_, entry_ ? crossing : -crossing, integration_));
    } else {
      const BottleneckTubes& bottleneck = bottlenecks_[arc.bottleneck];
      const Tube& tube = entry_ ? *bottleneck.unstable : *bottleneck.stable;
      work_.add(tube.crossings(entry_ ? bottleneck.in : bottleneck.out, section_, level + 1, u, states));
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

  [[nodiscard]] Exit make_exit(std::size_t j) const {
    Exit exit{j, {}, nullptr, {}};
    const TrajectoryArc arc{true, j, 0, 0, 1, false};
    const CurveSequence curve = [&](int, std::span<const double> u, std::span<Point> points) {
      evaluate(arc, 0, u, points);
    };
    const std::array<double, 2> ends{0, 1};
    exit.regularising_curve = std::move(images_of(curve, ends, tracing_, [](const CurveImage&) { return false; })[0]);
    if (!exit.regularising_curve.diagnostics.empty() || exit.regularising_curve.points.size() < 3) {
      throw DataError("trajectories about to leave by a bottleneck could not be followed back to the section");
    }
    exit.index = std::make_unique<IndexedCurve>(CurveView(exit.regularising_curve));
    for (const Point& p : exit.regularising_curve.points) {
      exit.middle.x += p.x / static_cast<double>(exit.regularising_curve.points.size());
      exit.middle.y += p.y / static_cast<double>(exit.regularising_curve.points.size());
    }
    return exit;
  }

  struct Crossing {
    double parameter;  // on the curve
    double u;          // on the regularising curve
  };

  // Newton's method for c(parameter) = r(u), r the regularising curve, with difference quotients, from segment k and
  // the nearest vertex of that.
  [[nodiscard]] Crossing crossing_in(const Exit& exit, std::size_t k) const {
    const double size = static_cast<double>(arcs_.size());
    const double from = parameters_[k];
    double to = k + 1 < parameters_.size() ? parameters_[k + 1] : size;
    const TrajectoryArc regularising_curve{true, exit.bottleneck, level_, 0, 1, false};
    const auto on_regularising_curve = [&](double u) {
      Point p;
      evaluate(regularising_curve, level_, {&u, 1}, {&p, 1});
      return p;
    };
    Crossing at_best{0.5 * (from + to), 0};
    const Point guess = at(at_best.parameter);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < exit.regularising_curve.points.size(); ++i) {
      const double distance =
          std::hypot(exit.regularising_curve.points[i].x - guess.x, exit.regularising_curve.points[i].y - guess.y);
      if (distance < nearest) {
        nearest = distance;
        at_best.u = exit.regularising_curve.parameters[i];
      }
    }
    Crossing here = at_best;
    double best = std::numeric_limits<double>::infinity();
    const double step = 1e-3 * (to - from), turn = 1e-5;
    for (int round = 0; round < 20; ++round) {
      const Point p = at(here.parameter), q = on_regularising_curve(here.u), r = p - q;
      const double size_of_rest = std::hypot(r.x, r.y);
      if (!(size_of_rest < best)) break;
      best = size_of_rest;
      at_best = here;
      const Point p2 = at(here.parameter + step), q2 = on_regularising_curve(here.u + turn);
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

  // Replaces the part in the exit by arcs of its regularising curve. False: no part lies there.
  bool cut_at(const Exit& exit) {
    std::vector<char> inside(points_.size());
    for_each_block(points_.size(), 512, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) inside[k] = contains(*exit.index, points_[k]);
    });
    const std::size_t count = points_.size();
    std::vector<std::size_t> enters, leaves;  // segments
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = k + 1 < count ? k + 1 : 0;
      if (!inside[k] && inside[next]) enters.push_back(k);
      if (inside[k] && !inside[next]) leaves.push_back(k);
    }
    if (leaves.empty()) return false;
    // Begin with a way out, so that arcs are leaves[i] ... enters[i].
    if (enters[0] < leaves[0]) std::rotate(enters.begin(), enters.begin() + 1, enters.end());
    std::vector<Crossing> out(leaves.size()), in(leaves.size());
    for_each_block(2 * leaves.size(), 1, [&](std::size_t k, std::size_t) {
      (k % 2 == 0 ? out : in)[k / 2] = crossing_in(exit, k % 2 == 0 ? leaves[k / 2] : enters[k / 2]);
    });
    std::vector<TrajectoryArc> arcs;
    std::vector<double> guide;
    std::vector<std::size_t> regularising_curves;
    double turns = 0;  // turns of the kept parts and the regularising curves, about the middle
    for (std::size_t i = 0; i < out.size(); ++i) {
      turns += turns_outside(leaves[i], enters[i], exit.middle);
      keep(out[i].parameter, in[i].parameter, arcs, guide);
      const Crossing& next = out[(i + 1) % out.size()];
      double way = next.u - in[i].u;
      way -= std::round(way);
      regularising_curves.push_back(arcs.size());
      arcs.push_back({true, exit.bottleneck, level_, in[i].u, in[i].u + way, false});
      turns += way * orientation_of(exit);
      add_guide(arcs.size() - 1, {}, guide);
    }
    // Small gaps between vertices and crossings do not matter to a whole number.
    const double excess = std::round(turns);
    arcs[regularising_curves[0]].to -= excess * orientation_of(exit);
    arcs_ = std::move(arcs);
    guide_ = std::move(guide);
    guide_.push_back(static_cast<double>(arcs_.size()));
    return true;
  }

  [[nodiscard]] static double orientation_of(const Exit& exit) {
    return signed_area(CurveView(exit.regularising_curve)) > 0 ? 1 : -1;
  }

  // The turns from segment `leave` to segment `enter` along the polygon.
  [[nodiscard]] double turns_outside(std::size_t leave, std::size_t enter, Point middle) const {
    double angle = 0;
    const std::size_t count = points_.size();
    std::size_t k = leave + 1 < count ? leave + 1 : 0;
    while (k != enter) {
      const std::size_t next = k + 1 < count ? k + 1 : 0;
      const Point a = points_[k] - middle, b = points_[next] - middle;
      angle += elementary::atan2(cross(a, b), a.x * b.x + a.y * b.y);
      k = next;
    }
    return angle / (2 * std::numbers::pi);
  }

  // The arcs between two parameters of the curve, the second one later, if need be after a round.
  void keep(double from, double to, std::vector<TrajectoryArc>& arcs, std::vector<double>& guide) const {
    const auto size = arcs_.size();
    if (to <= from) to += static_cast<double>(size);
    for (auto number = static_cast<std::size_t>(from); static_cast<double>(number) < to; ++number) {
      const TrajectoryArc& old = arcs_[number % size];
      const double begin = std::max(from - static_cast<double>(number), 0.0);
      const double end = std::min(to - static_cast<double>(number), 1.0);
      if (!(begin < end)) continue;
      TrajectoryArc arc = old;
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
    result.cut = true;
    guide_.clear();
    return result;
  }

  const Flow& flow_;
  Section section_;
  std::vector<BottleneckTubes> bottlenecks_;
  bool entry_;
  IntegrationOptions integration_;
  CutImageOptions options_;
  ImageOptions tracing_;
  std::vector<RegularisingCurve> regularising_curves_;
  std::vector<Exit> exits_;
  // The present curve: arcs, where it was sampled, and where its image shall be.
  int level_ = 0, direction_ = 0;
  bool out_of_points_ = false, out_of_work_ = false;
  mutable WorkMeter work_{std::numeric_limits<double>::infinity()};
  bool prepared_ = false;  // for the next image
  double lost_ = 0;        // area that was cut off so far
  std::vector<TrajectoryArc> arcs_;
  std::vector<double> parameters_, guide_;
  std::vector<Point> points_;
};

CutImages::CutImages(const Flow& flow, const Section& section, std::span<const BottleneckTubes> bottlenecks,
                     std::size_t bottleneck, bool entry, const TubeCurve& last, int level,
                     const IntegrationOptions& integration, const CutImageOptions& options)
    : cutting_(std::make_unique<Cutting>(flow, section, bottlenecks, bottleneck, entry, last, level, integration,
                                         options)) {}

CutImages::~CutImages() = default;

std::optional<std::size_t> CutImages::prepare(double max_work) {
  return cutting_->prepare(max_work);
}

std::optional<TubeCurve> CutImages::next(double max_work) {
  return cutting_->next(max_work);
}

bool CutImages::out_of_points() const {
  return cutting_->out_of_points();
}

bool CutImages::out_of_work() const {
  return cutting_->out_of_work();
}

double CutImages::work() const {
  return cutting_->work();
}

}  // namespace lober::detail
