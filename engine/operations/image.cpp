// Images and pre-images of a curve under a system's map.
#include <algorithm>
#include <cmath>
#include <span>

#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"
#include "engine/operations/curve_of.hpp"
#include "engine/operations/followed_curve.hpp"
#include "engine/operations/growth_options.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/drawing.hpp"
#include "lober/dynamics/manifolds.hpp"

namespace lober::operations {

std::string CurveImages::One::name() const {
  return "f^" + std::to_string(image.iterate) + (curve > 0 ? " boundary " + std::to_string(curve + 1) : "");
}

}  // namespace lober::operations

namespace lober::detail::table {
using namespace operations;
namespace {

using FollowedImage = CurveImages::One;

// Some take the place of what ImageOptions has for them.
struct ImageHow : ImageOptions {
  ImageHow() { max_work = unasked_work; }
  bool closed = true, boundary = false;
  std::optional<std::vector<double>> circle{};
  std::optional<Rectangle> rectangle{}, box_given{};
  int first = 1;
  std::optional<std::int64_t> last{};
  std::optional<double> tolerance_given{}, max_segment{};
};

const OptionList<ImageHow>& image_options() {
  static const OptionList<ImageHow> options = [] {
    using How = ImageHow;
    OptionList<How> list;
    list.option("closed", &How::closed, "whether to join the last vertex of the curve to the first")
        .option(
            "circle", &How::circle,
            "circle about X,Y of radius R, in the coordinates of the map, counter-clockwise, which is followed as a "
            "circle, not as a polygon",
            {.otherwise = "the curve given", .value = "X,Y,R"})
        .option("rectangle", &How::rectangle, "corners of a rectangle, which is followed counter-clockwise",
                {.otherwise = "the curve given"})
        .option(
            "boundary", &How::boundary,
            "whether to follow the boundary that the system's tangle makes, from its manifolds: U up to the boundary "
            "intersection point and S from there; on a cylinder the upper and the lower one")
        .option("first", &How::first, "number of iterates of the first image; negative ones are pre-images",
                {.min = -1000, .max = 1000, .value = "N"})
        .option("last", &How::last, "number of iterates of the last image",
                {.min = -1000, .max = 1000, .otherwise = "that of the first", .value = "N"});
    add_tolerance_option(list, "maximum distance between an image and its polygon")
        .option("max_length", &How::max_segment, "maximum length of a segment, in units of the coordinates",
                {.min = 0, .above_min = true, .otherwise = "no maximum", .value = "LENGTH"})
        .option(
            "box", &How::box_given,
            "corners of the box in which the tolerance holds; outside it images are followed coarsely, and what comes "
            "back may be wrong or missing",
            {.otherwise = "the box of the curve and of the system's window, three times as wide and high"})
        .option("max_points", &How::max_points, "maximum number of points of an image, at which it ends",
                {.min = 3, .max = 2'147'483'646, .value = "N"});
    return add_work_option(list);
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

struct ImageDiagnostics {
  const CurveImage* image;
  GrowthDiagnosticCause cause;

  [[nodiscard]] std::size_t count() const {
    std::size_t sum = 0;
    for (const GrowthDiagnostic& one : image->diagnostics) sum += one.cause == cause ? one.count : 0;
    return sum;
  }
  [[nodiscard]] Point first_at() const {
    for (const GrowthDiagnostic& one : image->diagnostics) {
      if (one.cause == cause) return image->points[one.first];
    }
    return {};
  }
};

std::vector<ImageDiagnostics> diagnostics_by_cause(const FollowedImage& one) {
  std::vector<ImageDiagnostics> found;
  for (const GrowthDiagnosticCause cause : all_growth_causes) {
    if (const ImageDiagnostics of_it{&one.image, cause}; of_it.count() > 0) found.push_back(of_it);
  }
  return found;
}

std::vector<Field> image_fields() {
  Schema<ImagePart> part;
  part.field("points", "", "number of points", [](const ImagePart& p) { return p.points.size(); })
      .field("closed", "", "whether the last point is joined to the first one", &ImagePart::closed);
  Schema<ImageDiagnostics> diagnostic;
  diagnostic
      .field("cause", "", "failed: gaps, where points have no image; spacing, max_rounds or left-box",
             [](const ImageDiagnostics& d) { return std::string(name(d.cause)); })
      .field("count", "", "number of segments", &ImageDiagnostics::count)
      .field("first_at", "length", "point where the first segment begins", &ImageDiagnostics::first_at);
  Schema<FollowedImage> image;
  image
      .field("iterate", "", "number of iterates; negative for pre-images",
             [](const FollowedImage& o) { return o.image.iterate; })
      .field("curve", "", "0; 1 for the second boundary of a cylinder", &FollowedImage::curve)
      .field("points", "", "number of points", [](const FollowedImage& o) { return o.image.points.size(); })
      .field("length", "length", "length of all parts", &FollowedImage::length)
      .field("area", "area", "signed area of an image that is whole and meets the tolerance everywhere",
             &FollowedImage::area)
      .or_null()
      .field(
          "complete", "", "whether max_points and max_work sufficed for all of it",
          [](const FollowedImage& o) { return o.image.stop != GrowthStop::points && o.image.stop != GrowthStop::work; })
      .list("parts", "curves between gaps", part, &FollowedImage::parts)
      .list("diagnostics", "segments that do not meet the tolerance, by cause", diagnostic, diagnostics_by_cause)
      .field("polygon", "length", "the points",
             [](const FollowedImage& o) { return std::vector<Point>(o.image.points.begin(), o.image.points.end()); })
      .field("parameters", "", "parameter of each point: the number of a segment of the curve and a fraction of it",
             [](const FollowedImage& o) {
               return std::vector<double>(o.image.parameters.begin(), o.image.parameters.end());
             })
      .not_in_json();
  Schema<CurveImages> made;
  made.field("what", "", "the curve, in words, where none was given", &CurveImages::what)
      .not_in_json()
      .field("closed", "", "whether the curve is closed", &CurveImages::closed)
      .not_in_json()
      .list("images", "images in the order of iterates; of two curves, those of the first one come first", image,
            &CurveImages::images);
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

// The curve of the images has to be given exactly once.
void check_image(const Options& options, std::size_t inputs) {
  const ImageHow how = image_options().how(options);
  const int ways = (inputs > 1 ? 1 : 0) + (how.circle ? 1 : 0) + (how.rectangle ? 1 : 0) + (how.boundary ? 1 : 0);
  if (ways == 0) {
    throw UsageError(
        "the curve is missing; option \"circle\", option \"rectangle\" or option \"boundary\" takes its place");
  }
  if (ways > 1) {
    throw UsageError(
        "a curve, option \"circle\", option \"rectangle\" and option \"boundary\" cannot be given together");
  }
  if (!how.closed && inputs < 2) throw UsageError("option \"closed\" is for a curve that is given");
  if (how.circle && how.circle->size() != 3) throw UsageError("option \"circle\" takes three numbers X,Y,R");
  if (how.circle && !((*how.circle)[2] > 0)) throw UsageError("option \"circle\" X,Y,R: R has to be above 0");
  if (how.first > how.last.value_or(how.first)) {
    throw UsageError("option \"first\" has to come before option \"last\"");
  }
}

FollowedCurve followed(const ImageHow& how, std::span<const Input> inputs, const Context& context, CurveImages& found) {
  if (how.circle) return followed_circle(*how.circle, found);
  if (how.rectangle) return followed_rectangle(*how.rectangle, found);
  const System& system = *std::get<SystemInput>(inputs[0]).system;
  if (how.boundary) return followed_boundary(system, how.tolerance, context, found);
  const CurveView curve = curve_at(named("image"), inputs, 1, how.closed);
  found.closed = curve.closed;
  FollowedCurve given;
  given.points = curve.points;
  return given;
}

// A single image ends early where points run out; of several those that do are left out.
std::vector<CurveImage> followed_images(const PlanarMap& map, int first, int last, const FollowedCurve& given,
                                        bool closed, const ImageOptions& options) {
  const CurveView curve{given.points, closed};
  if (first < last) {
    return given.function ? images_of(map, first, last, given.function, given.corners, options)
                          : images_of(map, first, last, curve, options);
  }
  std::vector<CurveImage> one;
  one.push_back(given.function ? image_of(map, first, given.function, given.corners, options)
                               : image_of(map, first, curve, options));
  one.back().iterate = first;
  return one;
}

double length_of(const ImagePart& part) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < part.points.size(); ++k) {
    length += std::hypot(part.points[k + 1].x - part.points[k].x, part.points[k + 1].y - part.points[k].y);
  }
  if (part.closed) {
    length += std::hypot(part.points.front().x - part.points.back().x, part.points.front().y - part.points.back().y);
  }
  return length;
}

FollowedImage measured(CurveImage&& image, std::size_t curve, double tolerance) {
  FollowedImage one{std::move(image), curve};
  one.parts = parts_of(one.image);
  for (const ImagePart& part : one.parts) one.length += length_of(part);
  if (one.parts.size() == 1 && one.parts[0].closed && one.image.diagnostics.empty()) {
    one.area = {signed_area(CurveView{one.parts[0].points, true}), tolerance * one.length};
  }
  return one;
}

// A map that preserves area keeps that of the curve, as far as both polygons meet their tolerance.
void compare_image_areas(CurveImages& found, const PlanarMap& map) {
  Point image = found.images.empty() || found.images.front().image.points.empty()
                    ? Point{}
                    : found.images.front().image.points[0];
  const Point from = image;
  map.iterate({&image, 1}, 1);
  found.preserves_area = map.action(from, image).has_value();
  if (!found.preserves_area || !found.closed) return;
  const FollowedImage* base = nullptr;
  for (const FollowedImage& one : found.images) {
    if (!one.area) continue;
    if (base == nullptr) {
      base = &one;
      continue;
    }
    found.agreement.compare({"area enclosed by the curve", base->name(), one.name(), base->area->value, one.area->value,
                             base->area->error + one.area->error});
  }
}

// From a smaller curve one point would be left.
void require_larger_than(double tolerance, std::span<const Point> points) {
  const Box box = box_of(points);
  const double size = std::max(box.width(), box.height());
  if (!(size > 0 && tolerance > size)) return;
  throw UsageError("option \"tolerance\": " + format_number(tolerance) + " is more than the size of the curve, " +
                   format_rounded(size, 3) + "; give a smaller one");
}

Outcome run_image(std::span<const Input> inputs, const Options& options, const Context& context) {
  const System& system = *system_of(inputs).system;
  ImageHow how = image_options().how(options);
  const int last = static_cast<int>(how.last.value_or(how.first));
  how.tolerance = tolerance_in(system, how.tolerance_given);
  if (how.max_segment) how.max_length = *how.max_segment;
  how.max_points = std::min(how.max_points, std::max<std::size_t>(context.memory / (4 * sizeof(Point)), 1000));
  CurveImages found;
  const Stopwatch curve_watch;
  const FollowedCurve given = followed(how, inputs, context, found);
  found.curve_seconds = curve_watch.seconds();
  require_larger_than(how.tolerance, given.points);
  how.box = system.window;
  for (const Point& point : given.points) how.box.add(point);
  for (const Point& point : given.second) how.box.add(point);
  how.box = how.box_given.value_or(widened(how.box, 1));
  found.box = how.box;
  found.tolerance = how.tolerance;
  how.progress = [&](const GrowthProgress& at) {
    if (context.count) context.count(static_cast<double>(at.images), "images of points");
    return context.progress(std::string());
  };
  const Stopwatch image_watch;
  const auto add = [&](std::vector<CurveImage>&& images, std::size_t curve) {
    for (CurveImage& image : images) {
      if (image.stop == GrowthStop::cancelled) throw Cancelled();
      found.images.push_back(measured(std::move(image), curve, how.tolerance));
    }
  };
  add(followed_images(*system.map, how.first, last, given, found.closed, how), 0);
  if (!given.second.empty()) {
    FollowedCurve second;
    second.points = given.second;
    add(followed_images(*system.map, how.first, last, second, found.closed, how), 1);
  }
  found.image_seconds = image_watch.seconds();
  compare_image_areas(found, *system.map);
  const std::size_t wanted = static_cast<std::size_t>(last - how.first + 1) * (given.second.empty() ? 1 : 2);
  const std::size_t left_out = wanted - std::min(wanted, found.images.size());
  Outcome outcome = outcome_of(std::move(found), options);
  const auto add_reason = [&](const std::string& reason) {
    outcome.incomplete += (outcome.incomplete.empty() ? "" : "; ") + reason;
  };
  if (left_out > 0) {
    const std::string images = left_out == 1 ? "1 image is" : std::to_string(left_out) + " images are";
    add_reason(images + " left out, since max_points allows no more");
  }
  for (const FollowedImage& one : outcome.as<CurveImages>().images) {
    if (one.image.stop == GrowthStop::points) {
      add_reason(one.name() + " ends early, with " + std::to_string(one.image.points.size()) +
                 " points, since max_points allows no more");
    } else if (one.image.stop == GrowthStop::work) {
      add_reason(one.name() + " is left out, since max_work allows no more");
    } else if (one.image.stop == GrowthStop::failed) {
      add_reason(one.name() + " ends early: no point has an image near by");
    }
  }
  for (const char* const limit : {"max_points", "max_work"}) {
    if (outcome.incomplete.find(limit) != std::string::npos) add_reason(std::string("give a larger ") + limit);
  }
  outcome.chosen = {{"last", std::int64_t{last}}, {"box", outcome.as<CurveImages>().box}, {"tolerance", how.tolerance}};
  return outcome;
}

}  // namespace

Operation image_operation() {
  Operation operation;
  operation.name = "image";
  operation.revision = 4;  // max_points is kept to
  operation.title = "images and pre-images of a curve under a system's map";
  operation.summary =
      "Computes images and pre-images of a curve under a map, or a flow's Poincare map, to a tolerance.";
  operation.inputs = {{"system", InputKind::system, "the system whose map it is"},
                      {"curve", InputKind::curve, "a curve, in place of a circle, a rectangle or the boundary", true}};
  operation.options = image_options().specs();
  operation.result = image_fields();
  operation.examples = {{{"standard K=1.2"}, {{"circle", std::vector<double>{3.14159, 0, 1}}}, "the image of a circle"},
                        {{"ovp"}, {{"boundary", true}}, "of the boundary of the vortex pair"}};
  operation.check = check_image;
  operation.run = run_image;
  return operation;
}

}  // namespace lober::detail::table
