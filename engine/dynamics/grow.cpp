#include "engine/dynamics/grow.hpp"

#include <algorithm>
#include <cmath>

#include "engine/densify/running_sums.hpp"
#include "engine/dynamics/outcome.hpp"
#include "engine/dynamics/trace.hpp"
#include "engine/error.hpp"

namespace lober {
namespace {

// What one point costs at the peak: two copies with their parameters, flags, counts and the next guide.
constexpr std::size_t bytes_per_point = 120;

// Parameters of P are told apart from here on: P rounds to so many ulps of the largest coordinate.
constexpr double ulps_apart = 64;

class Growth {
 public:
  Growth(const PlanarMap& map, const LocalManifold& local, Branch branch, const GrowthOptions& options)
      : map_(map), local_(local), options_(options), side_(static_cast<double>(branch)) {
    inverse_ = local.multiplier < 0;
    steps_ = local.image().steps;
    ratio_ = local.image().factor;
    set_up_tracing();
  }

  GrownManifold run() {
    try {
      Samples samples;  // of the generation before
      int short_generations = 0;
      for (int generation = 0; !done(generation); ++generation) {
        Samples guide = generation == 0 ? first_guide() : carried(std::move(samples), generation - 1);
        Trace trace = traced_generation(std::move(guide), generation);
        const bool out_of_points = trace.out_of_points;
        const double length = result_.length;
        append(trace, generation);
        short_generations = result_.length - length < options_.tolerance ? short_generations + 1 : 0;
        if (out_of_points) return stopped(GrowthStop::points);
        if (result_.length >= options_.length) return stopped(GrowthStop::length);
        if (!alive(trace.samples)) return stopped(GrowthStop::failed);
        if (short_generations >= 2) return stopped(GrowthStop::ended);
        samples = std::move(trace.samples);
      }
      return stopped(GrowthStop::iterates);
    } catch (const Cancelled&) {
      return stopped(GrowthStop::cancelled);
    }
  }

 private:
  void set_up_tracing() {
    std::vector<double> parameters(257);
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      parameters[k] = side_ * local_.reach * static_cast<double>(k) / static_cast<double>(parameters.size() - 1);
    }
    std::vector<Point> points(parameters.size());
    local_.points_at(parameters, points);
    const double extent = box_of(points).extent();
    double largest = 0;
    for (const Point point : points) largest = std::max({largest, std::fabs(point.x), std::fabs(point.y)});
    const double rounding = largest * std::numeric_limits<double>::epsilon();
    if (!(options_.tolerance > 8 * rounding)) {
      throw UsageError("grow: the tolerance is below what coordinates of this size resolve");
    }
    trace_options_.tolerance = options_.tolerance;
    trace_options_.longest = options_.longest > 0 ? options_.longest : extent / 50;
    trace_options_.least_spacing = ulps_apart * std::max(rounding, local_.reach * 1e-16);
    trace_options_.box = options_.box;
    if (!(options_.box.width() >= 0)) {
      const double reach = 100 * extent;
      trace_options_.box = Box::of({local_.saddle.x - reach, local_.saddle.y - reach},
                                   {local_.saddle.x + reach, local_.saddle.y + reach});
    }
    most_points_ = std::min(options_.most_points, options_.most_memory / bytes_per_point);
    most_points_ = std::min<std::size_t>(most_points_, (std::size_t{1} << 31) - 1);
    if (most_points_ < 2) throw UsageError("grow: there has to be room for two points");
  }

  // How many iterates a generation takes the end of the local manifold.
  [[nodiscard]] int iterates_of(int generation) const { return inverse_ ? 2 * generation : generation; }

  // Whether all generations before this one are all there are.
  [[nodiscard]] bool done(int generation) const {
    return options_.iterates >= 0 && generation > 0 && iterates_of(generation - 1) >= options_.iterates;
  }

  // The last parameter of a generation: less than the reach where the iterates end between two generations.
  [[nodiscard]] double end_of(int generation) const {
    const bool beyond = options_.iterates >= 0 && iterates_of(generation) > options_.iterates;
    return beyond ? local_.reach / std::fabs(local_.multiplier) : local_.reach;
  }

  [[nodiscard]] CurveFunction image(int generation) const {
    return [this, generation](std::span<const double> parameters, std::span<Point> points) {
      std::vector<double> on_side(parameters.begin(), parameters.end());
      for (double& parameter : on_side) parameter *= side_;
      local_.points_at(on_side, points);
      if (generation > 0) map_.iterate(points, generation * steps_);
    };
  }

  // So many evaluations, each of so many steps.
  void count(std::size_t evaluations, int generations) {
    result_.images += static_cast<std::uint64_t>(evaluations) * static_cast<std::uint64_t>(generations) *
                      static_cast<std::uint64_t>(std::abs(steps_));
    if (!options_.progress) return;
    const GrowthProgress progress{iterates_, result_.points.size(), result_.length, result_.images};
    if (!options_.progress(progress)) throw Cancelled();
  }

  [[nodiscard]] Samples first_guide() const {
    constexpr std::size_t size = 65;
    Samples guide{Buffer<double>(size), Buffer<Point>(size)};
    for (std::size_t k = 0; k < size; ++k) {
      guide.parameters[k] = end_of(0) * static_cast<double>(k) / static_cast<double>(size - 1);
    }
    image(0)(guide.parameters, guide.points);
    // P(0) but for rounding; the other manifold of a homoclinic tangle begins there too.
    guide.points[0] = local_.saddle;
    return guide;
  }

  [[nodiscard]] Trace traced_generation(Samples guide, int generation) {
    TraceOptions options = trace_options_;
    options.most_points = most_points_ - std::min(most_points_, result_.points.size());
    if (options.most_points < 2) {
      Trace none;
      none.out_of_points = true;
      return none;
    }
    options.most_length = options_.length - result_.length;
    options.evaluated = [&](std::size_t evaluations) { count(evaluations, generation); };
    const auto last = static_cast<std::uint32_t>(guide.points.size() - 1);
    return traced(std::move(guide), {0, last}, image(generation), options);
  }

  // The next guide: what the points of the fundamental segment become in one more step.
  [[nodiscard]] Samples carried(Samples samples, int generation) {
    Samples guide;
    if (generation == 0) {
      const auto& given = samples.parameters;
      const auto first =
          static_cast<std::size_t>(std::upper_bound(given.begin(), given.end(), local_.reach / ratio_) - given.begin());
      guide = {Buffer<double>(given.size() - first + 1), Buffer<Point>(given.size() - first + 1)};
      guide.parameters[0] = local_.reach / ratio_;
      guide.points[0] = local_.at(side_ * guide.parameters[0]);
      std::copy(given.begin() + static_cast<std::ptrdiff_t>(first), given.end(), guide.parameters.begin() + 1);
      std::copy(samples.points.begin() + static_cast<std::ptrdiff_t>(first), samples.points.end(),
                guide.points.begin() + 1);
    } else {
      guide = std::move(samples);
    }
    if (const double end = end_of(generation + 1); end < local_.reach) {
      const auto size = static_cast<std::size_t>(
          std::lower_bound(guide.parameters.begin(), guide.parameters.end(), end) - guide.parameters.begin());
      guide.parameters.resize(size + 1);
      guide.points.resize(size + 1);
      guide.parameters.back() = end;
      image(generation)({&end, 1}, {&guide.points.back(), 1});
    }
    for_each_block(guide.points.size(), trace_options_.batch, [&](std::size_t first, std::size_t last) {
      map_.iterate(std::span(guide.points).subspan(first, last - first), steps_);
    });
    count(guide.points.size(), 1);
    return guide;
  }

  void append(const Trace& trace, int generation) {
    const CancellationScope shield(CancellationScope::Shield{});  // half a generation could not be kept
    result_.generation_begin.push_back(result_.points.size());
    append_finite(trace, generation > 0 ? 1 : 0, result_.points, result_.parameters, result_.flaws);
    const std::size_t begin = result_.generation_begin.back();
    if (side_ < 0) {
      for_each_block(result_.parameters.size() - begin, densify_grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) result_.parameters[begin + k] *= side_;
      });
    }
    add_length(begin);
    iterates_ = std::min(iterates_of(generation), options_.iterates >= 0 ? options_.iterates : iterates_of(generation));
  }

  // The length of the segment behind point k, as far as it counts.
  [[nodiscard]] double length_behind(std::size_t k) const {
    const Point a = result_.points[k], b = result_.points[k + 1];
    if (!meet(Box::of(a, b), trace_options_.box)) return 0;
    return distance(a, b);
  }

  // Adds the length of the segments up to the points from number `begin` on, and ends the curve at the vertex where it
  // is long enough.
  void add_length(std::size_t begin) {
    const std::size_t first_segment = begin > 0 ? begin - 1 : 0;
    const std::size_t count = result_.points.empty() ? 0 : result_.points.size() - 1 - first_segment;
    std::vector<double> sums((count + densify_grain - 1) / densify_grain, 0);
    for_each_block(count, densify_grain, [&](std::size_t first, std::size_t last) {
      double sum = 0;
      for (std::size_t k = first; k < last; ++k) sum += length_behind(first_segment + k);
      sums[first / densify_grain] = sum;
    });
    for (std::size_t block = 0; block < sums.size(); ++block) {
      if (result_.length + sums[block] < options_.length) {
        result_.length += sums[block];
        continue;
      }
      const std::size_t last = first_segment + std::min(count, (block + 1) * densify_grain);
      for (std::size_t k = first_segment + block * densify_grain; k < last; ++k) {
        result_.length += length_behind(k);
        if (result_.length < options_.length) continue;
        result_.points.resize(k + 2);
        result_.parameters.resize(k + 2);
        cut_flaws(result_.flaws, k + 1);
        return;
      }
    }
  }

  // Whether any of the curve is left to grow.
  [[nodiscard]] bool alive(const Samples& samples) const {
    return std::any_of(samples.points.begin(), samples.points.end(), [&](Point point) {
      return std::isfinite(point.x) && std::isfinite(point.y) && meet(Box::of(point, point), trace_options_.box);
    });
  }

  [[nodiscard]] GrownManifold stopped(GrowthStop stop) {
    result_.stop = stop;
    result_.generation_begin.push_back(result_.points.size());
    return std::move(result_);
  }

  const PlanarMap& map_;
  const LocalManifold& local_;
  const GrowthOptions& options_;
  double side_;
  bool inverse_ = false;
  int steps_ = 1;
  double ratio_ = 1;  // of the parameters at the ends of a fundamental segment
  TraceOptions trace_options_;
  std::size_t most_points_ = 0;
  int iterates_ = 0;
  GrownManifold result_;
};

void require_sensible(const LocalManifold& local, const GrowthOptions& options) {
  if (!(options.tolerance > 0)) throw UsageError("grow: the tolerance has to be positive");
  if (!(options.longest >= 0)) throw UsageError("grow: the longest segment cannot be negative");
  if (!(options.length > 0)) throw UsageError("grow: the length has to be positive");
  if (options.iterates < 0 && !std::isfinite(options.length)) {
    throw UsageError("grow: either the number of iterates or the length has to be given");
  }
  if (!(std::fabs(local.multiplier) > 1) || !(local.reach > 0)) {
    throw UsageError("grow: this is no local manifold of a saddle");
  }
}

}  // namespace

Branch branch_towards(const LocalManifold& local, Point direction) {
  return local.tangent.x * direction.x + local.tangent.y * direction.y < 0 ? Branch::minus : Branch::plus;
}

std::string_view name(GrowthFlawCause cause) {
  switch (cause) {
    case GrowthFlawCause::failed:
      return "failed";
    case GrowthFlawCause::spacing:
      return "spacing";
    case GrowthFlawCause::most_rounds:
      return "most-rounds";
    case GrowthFlawCause::left_box:
      return "left-box";
  }
  return "";
}

std::string_view name(GrowthStop stop) {
  switch (stop) {
    case GrowthStop::iterates:
      return "iterates";
    case GrowthStop::length:
      return "length";
    case GrowthStop::points:
      return "points";
    case GrowthStop::ended:
      return "ended";
    case GrowthStop::failed:
      return "failed";
    case GrowthStop::cancelled:
      return "cancelled";
  }
  return "";
}

GrownManifold grow(const PlanarMap& map, const LocalManifold& local, Branch branch, const GrowthOptions& options) {
  require_sensible(local, options);
  return Growth(map, local, branch, options).run();
}

}  // namespace lober
