// Images of curves, by the same machinery as manifolds.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/work_limit.hpp"
#include "engine/dynamics/manifolds/outcome.hpp"
#include "engine/dynamics/manifolds/trace.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t batch = 64;

TraceOptions options_for_tracing(const ImageOptions& given, const Samples& guide) {
  TraceOptions options;
  options.tolerance = given.tolerance;
  options.max_length = given.max_length;
  options.max_points = std::min<std::size_t>(given.max_points, (std::size_t{1} << 31) - 2) + 1;
  options.min_spacing = 64 * std::numeric_limits<double>::epsilon() *
                        std::max(std::fabs(guide.parameters.front()), std::fabs(guide.parameters.back()));
  options.box = box_of(given.box);
  if (!(options.box.width() >= 0)) {
    constexpr double most = std::numeric_limits<double>::max();
    options.box = Box::of({-most, -most}, {most, most});
  }
  return options;
}

// The last sample repeats the first. Where they have no image, there is a gap.
void close(CurveImage& image, bool ends_have_images) {
  if (image.stop == GrowthStop::points || image.points.size() < 2) return;
  if (ends_have_images) {
    image.points.pop_back();
    image.parameters.pop_back();
  } else {
    image.diagnostics.push_back({image.points.size() - 1, 1, GrowthDiagnosticCause::failed});
  }
}

// A trace keeps to its limit roughly: points that stay have whole numbers. Whether the image keeps to it now.
bool cut_to(CurveImage& image, std::size_t max_points) {
  if (image.points.size() <= max_points) return true;
  image.points.resize(max_points);
  image.parameters.resize(max_points);
  cut_diagnostics(image.diagnostics, max_points - 1);
  image.stop = GrowthStop::points;
  return false;
}

// A closed curve may go on at its start as smoothly as elsewhere.
enum class Ends : std::uint8_t { open, meet_in_a_corner, meet_smoothly };

Ends ends_of(const CurveFunction& curve, double first, double last) {
  constexpr double near = 1e-5, smooth = 1e-3;  // parts of the curve, and a turning that is not a corner's (radians)
  const double step = near * (last - first);
  const std::array<double, 4> parameters{first, first + step, last - step, last};
  std::array<Point, 4> at;
  curve(parameters, at);
  const Point begins = at[1] - at[0], ends = at[3] - at[2];
  return std::fabs(cross(ends, begins)) < smooth * (ends.x * begins.x + ends.y * begins.y) ? Ends::meet_smoothly
                                                                                           : Ends::meet_in_a_corner;
}

// The points beyond the ends of samples of a curve.
Beyond beyond_ends(const Samples& samples, Ends ends) {
  const std::size_t size = samples.points.size();
  if (ends != Ends::meet_smoothly || size < 4) return {};
  Beyond beyond{samples.points[size - 2], samples.points[1], true, false};
  forget_unknown(beyond);
  return beyond;
}

// Each curve of a sequence in turn: the points of one, carried on, show where the next one needs points. `at` gives
// curve k at parameters, `onward` turns points of curve k - 1 into those of curve k; a point of curve k costs
// `steps(k)` steps of the map, where there is one. `finished` takes each curve and says whether to go on.
template <typename Steps, typename Finished>
void trace_in_turn(const ImageOptions& given, Ends ends, Samples guide, std::vector<std::uint32_t> kept,
                   const CurveSequence& at, const CurveSequence& onward, const Steps& steps, const Finished& finished,
                   const PlanarMap* map = nullptr, std::function<bool()> spent = {}) {
  TraceOptions options = options_for_tracing(given, guide);
  const std::size_t together = map != nullptr ? std::max(batch, map->batch()) : batch;
  options.batch = together;
  options.spent = std::move(spent);
  std::uint64_t images = 0;
  for (int done = 0;; ++done) {
    const CurveFunction curve = [&](std::span<const double> parameters, std::span<Point> points) {
      at(done, parameters, points);
    };
    const auto count = [&](std::size_t evaluations, int each) {
      images += static_cast<std::uint64_t>(evaluations) * static_cast<std::uint64_t>(each);
      if (given.progress && !given.progress({done, 0, 0, images})) throw Cancelled();
    };
    options.evaluated = [&](std::size_t evaluations) { count(evaluations, steps(done)); };
    options.images_are_dear = map == nullptr || are_dear(*map, static_cast<std::uint64_t>(done));
    const Beyond beyond = beyond_ends(guide, ends);
    Trace trace = traced(std::move(guide), std::move(kept), beyond, curve, options);
    CurveImage result;
    result.images = images;
    if (trace.out_of_points) result.stop = GrowthStop::points;
    append_finite(trace, 0, 1, result.points, result.parameters, result.diagnostics);
    result.closed = ends != Ends::open;
    if (result.closed) close(result, is_finite(trace.samples.points.front()) && is_finite(trace.samples.points.back()));
    const bool fits = cut_to(result, given.max_points) && !trace.out_of_points;
    if (!finished(done, std::move(result)) || !fits) return;
    guide = std::move(trace.samples);
    kept = std::move(trace.kept);
    for_each_block(guide.points.size(), together, [&](std::size_t first, std::size_t last) {
      onward(done + 1, std::span(guide.parameters).subspan(first, last - first),
             std::span(guide.points).subspan(first, last - first));
    });
    count(guide.points.size(), 1);
  }
}

// The images under 1, 2, ... steps in one direction, from the curve itself on.
void trace_images(const PlanarMap& map, int direction, const ImageOptions& given, Ends ends, Samples guide,
                  std::vector<std::uint32_t> kept, const CurveFunction& curve,
                  const std::function<bool(int done, CurveImage&&)>& finished) {
  const CurveSequence at = [&](int done, std::span<const double> parameters, std::span<Point> points) {
    curve(parameters, points);
    if (done != 0) map.iterate(points, done * direction);
  };
  const CurveSequence onward = [&](int, std::span<const double>, std::span<Point> points) {
    map.iterate(points, direction);
  };
  const std::uint64_t before = map.work();
  std::uint64_t images = 0;
  const auto spent = [&] { return static_cast<double>(std::max(map.work() - before, images)) > given.max_work; };
  ImageOptions limited = given;
  limited.progress = [&](const GrowthProgress& so_far) {
    images = so_far.images;
    return !spent() && (!given.progress || given.progress(so_far));
  };
  int next = 0;
  const auto count_finished = [&](int done, CurveImage&& image) {
    next = done + 1;
    return finished(done, std::move(image));
  };
  const auto trace_all = [&] {
    trace_in_turn(
        limited, ends, std::move(guide), std::move(kept), at, onward, [](int done) { return done; }, count_finished,
        &map, spent);
  };
  if (!completes(trace_all, spent)) {
    CurveImage missing;
    missing.closed = ends != Ends::open;
    missing.stop = GrowthStop::work;
    finished(next, std::move(missing));
  }
}

// A curve by its function, and what the first trace of it starts from.
struct GivenCurve {
  CurveFunction function;
  Samples guide;
  std::vector<std::uint32_t> kept;
  Ends ends = Ends::meet_in_a_corner;
};

CurveImage last_image(const PlanarMap& map, int iterates, const ImageOptions& options, GivenCurve curve) {
  CurveImage last;
  trace_images(map, iterates < 0 ? -1 : 1, options, curve.ends, std::move(curve.guide), std::move(curve.kept),
               curve.function, [&](int done, CurveImage&& image) {
                 last = std::move(image);
                 return done != std::abs(iterates);
               });
  return last;
}

std::vector<CurveImage> all_images(const PlanarMap& map, int first, int last, const ImageOptions& options,
                                   const GivenCurve& curve) {
  if (first > last) throw UsageError("images: the first iterate has to come before the last one");
  std::vector<CurveImage> images;
  const auto add = [&](int direction, int from, int to) {
    trace_images(map, direction, options, curve.ends, curve.guide, curve.kept, curve.function,
                 [&](int done, CurveImage&& image) {
                   image.iterate = done * direction;
                   if (done >= from) images.push_back(std::move(image));
                   return done != to;
                 });
  };
  if (first < 0) {
    add(-1, std::max(0, -last), -first);
    std::reverse(images.begin(), images.end());
  }
  // The backward trace has brought the curve itself, unless points ran out there.
  if (last > 0) add(1, std::max(first < 0 ? 1 : 0, first), last);
  if (first == 0 && last == 0) add(1, 0, 0);
  return images;
}

void require_sensible(const ImageOptions& options) {
  if (!(options.tolerance > 0)) throw UsageError("image: the tolerance has to be positive");
  if (!(options.max_length > 0)) throw UsageError("image: the maximum length of a segment has to be positive");
  if (options.max_points < 3) throw UsageError("image: the maximum number of points has to be at least 3");
}

// A few points between any two corners; the corners are kept.
Samples first_guide(std::span<const double> corners, const CurveFunction& curve, std::vector<std::uint32_t>& kept) {
  if (corners.size() < 2) throw UsageError("image: the first and the last parameter of the curve have to be given");
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (!std::isfinite(corners[k]) || (k > 0 && !(corners[k] > corners[k - 1]))) {
      throw UsageError("image: parameters have to be finite and strictly ascending");
    }
  }
  constexpr std::size_t parts = 64;
  Samples guide;
  for (std::size_t j = 0; j + 1 < corners.size(); ++j) {
    kept.push_back(static_cast<std::uint32_t>(guide.parameters.size()));
    for (std::size_t k = 0; k < parts; ++k) {
      guide.parameters.push_back(corners[j] + (corners[j + 1] - corners[j]) * static_cast<double>(k) / parts);
    }
  }
  kept.push_back(static_cast<std::uint32_t>(guide.parameters.size()));
  guide.parameters.push_back(corners.back());
  guide.points.resize(guide.parameters.size());
  curve(guide.parameters, guide.points);
  return guide;
}

GivenCurve by_function(const CurveFunction& curve, std::span<const double> corners, const ImageOptions& options) {
  require_sensible(options);
  GivenCurve given{curve, {}, {}};
  given.guide = first_guide(corners, curve, given.kept);
  given.ends = ends_of(curve, corners.front(), corners.back());
  return given;
}

// `curve` has to outlive it.
GivenCurve by_polygon(CurveView curve, const ImageOptions& options) {
  require_sensible(options);
  validate(curve, "image");
  const std::size_t size = curve.segments() + 1;
  const auto vertex = [curve](std::size_t k) { return curve.points[k < curve.points.size() ? k : 0]; };
  GivenCurve given;
  given.ends = curve.closed ? Ends::meet_in_a_corner : Ends::open;
  given.function = [vertex](std::span<const double> parameters, std::span<Point> points) {
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const double number = std::floor(parameters[k]), t = parameters[k] - number;
      const Point a = vertex(static_cast<std::size_t>(number));
      if (t == 0) {
        points[k] = a;
      } else {
        const Point b = vertex(static_cast<std::size_t>(number) + 1);
        points[k] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      }
    }
  };
  given.guide = {Buffer<double>(size), Buffer<Point>(size)};
  given.kept.resize(size);
  for (std::size_t k = 0; k < size; ++k) {
    given.guide.parameters[k] = static_cast<double>(k);
    given.guide.points[k] = vertex(k);
    given.kept[k] = static_cast<std::uint32_t>(k);
  }
  return given;
}

}  // namespace

CurveImage image_of(const PlanarMap& map, int iterates, const CurveFunction& curve, std::span<const double> corners,
                    const ImageOptions& options) {
  return last_image(map, iterates, options, by_function(curve, corners, options));
}
std::vector<CurveImage> images_of(const PlanarMap& map, int first, int last, const CurveFunction& curve,
                                  std::span<const double> corners, const ImageOptions& options) {
  return all_images(map, first, last, options, by_function(curve, corners, options));
}

std::vector<CurveImage> images_of(const CurveSequence& curves, std::span<const double> corners,
                                  const ImageOptions& options, const std::function<bool(const CurveImage&)>& goes_on,
                                  std::span<const double> guide) {
  require_sensible(options);
  const CurveFunction first = [&](std::span<const double> parameters, std::span<Point> points) {
    curves(0, parameters, points);
  };
  std::vector<std::uint32_t> kept;
  Samples samples;
  if (guide.empty()) {
    samples = first_guide(corners, first, kept);
  } else {
    samples.parameters.assign(guide.begin(), guide.end());
    samples.points.resize(guide.size());
    for (const double corner : corners) {
      kept.push_back(static_cast<std::uint32_t>(std::lower_bound(guide.begin(), guide.end(), corner) - guide.begin()));
    }
    for_each_block(guide.size(), batch, [&](std::size_t begin, std::size_t end) {
      first(guide.subspan(begin, end - begin), std::span(samples.points).subspan(begin, end - begin));
    });
  }
  std::vector<CurveImage> results;
  trace_in_turn(
      options, ends_of(first, corners.front(), corners.back()), std::move(samples), std::move(kept), curves, curves,
      [](int done) { return done + 1; },
      [&](int, CurveImage&& image) {
        results.push_back(std::move(image));
        return goes_on(results.back());
      });
  return results;
}

CurveImage image_of(const PlanarMap& map, int iterates, CurveView curve, const ImageOptions& options) {
  return last_image(map, iterates, options, by_polygon(curve, options));
}
std::vector<CurveImage> images_of(const PlanarMap& map, int first, int last, CurveView curve,
                                  const ImageOptions& options) {
  return all_images(map, first, last, options, by_polygon(curve, options));
}

std::vector<ImagePart> parts_of(const CurveImage& image) {
  std::vector<ImagePart> parts(1);
  std::size_t next = 0;
  const auto take_to = [&](std::size_t end) {
    Buffer<Point>& points = parts.back().points;
    points.insert(points.end(), image.points.begin() + static_cast<std::ptrdiff_t>(next),
                  image.points.begin() + static_cast<std::ptrdiff_t>(end));
    next = end;
  };
  for (const GrowthDiagnostic& diagnostic : image.diagnostics) {
    if (diagnostic.cause != GrowthDiagnosticCause::failed) continue;
    for (std::size_t k = 0; k < diagnostic.count; ++k) {
      take_to(diagnostic.first + k + 1);
      parts.emplace_back();
    }
  }
  take_to(image.points.size());
  parts.front().closed = image.closed && image.stop != GrowthStop::points && parts.size() == 1;
  // The last part of a closed curve goes on as the first one, through the first point.
  if (image.closed && image.stop != GrowthStop::points && parts.size() > 1) {
    Buffer<Point> joined = std::move(parts.back().points);
    joined.insert(joined.end(), parts.front().points.begin(), parts.front().points.end());
    parts.front().points = std::move(joined);
    parts.pop_back();
  }
  std::erase_if(parts, [](const ImagePart& part) { return part.points.size() < 2; });
  return parts;
}

}  // namespace lober
