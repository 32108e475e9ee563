#include "engine/batch/manifest/recipe.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <span>

#include "engine/base/json_text.hpp"
#include "engine/batch/operations/named_system.hpp"
#include "engine/batch/operations/provenance.hpp"
#include "lober/curve/files.hpp"
#include "lober/dynamics/manifolds.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t guessed_points = 100'000;  // points of a manifold that was never grown

System made_system(const CurveRecipe& recipe) {
  return system_of(recipe.system, recipe.parameters, recipe.integration_tolerance);
}

// A map that can be broken off within a batch of points, and that counts how many points of the present iterate have
// been computed: no more are in memory.
class WatchedMap final : public PlanarMap {
 public:
  WatchedMap(const PlanarMap& map, const Allowance& allowance) : map_(map), allowance_(allowance) {}

  void iterate(std::span<Point> points, int iterates) const override {
    allowance_.check();
    count_.fetch_add(points.size(), std::memory_order_relaxed);
    map_.iterate(points, iterates);
  }
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    return map_.iterate_with_derivative(point, iterates, derivative);
  }
  [[nodiscard]] std::optional<long double> action(Point from, Point to) const override { return map_.action(from, to); }
  [[nodiscard]] double unit() const override { return map_.unit(); }
  [[nodiscard]] bool takes_all_iterates() const override { return map_.takes_all_iterates(); }

  // Turns a report of growing, from the calling thread, into a booking: the finished part, the iterate before the
  // present one, which is the guide, and the present one.
  [[nodiscard]] bool report(const GrowthProgress& progress) {
    if (progress.iterates != iterates_) {
      iterates_ = progress.iterates;
      const std::size_t all = count_.load(std::memory_order_relaxed);
      guide_ = all - before_;
      before_ = all;
    }
    const std::size_t present = count_.load(std::memory_order_relaxed) - before_;
    const std::size_t points = progress.points + guide_ + present;
    allowance_.check();
    allowance_.book(
        std::min(computed_bytes_per_point * points, allowance_.most()));  // that is where growing itself stops
    return true;
  }

 private:
  const PlanarMap& map_;
  const Allowance& allowance_;
  mutable std::atomic<std::size_t> count_{0};
  int iterates_ = 0;
  std::size_t before_ = 0, guide_ = 0;
};

[[noreturn]] void stopped_early(const char* what, GrowthStop stop, const Allowance& allowance) {
  allowance.check();
  std::string reason(name(stop));
  if (stop == GrowthStop::points) {
    reason = "needs more points than " + std::to_string(allowance.most() >> 20) + " MiB of memory have room for";
  }
  throw DataError(std::string(what) + " stopped early: " + reason);
}

Curve grown(const CurveRecipe& recipe, const Allowance& allowance) {
  const System system = made_system(recipe);
  const ManifoldSide side = recipe.kind == CurveRecipe::Kind::stable ? ManifoldSide::stable : ManifoldSide::unstable;
  const Connection connection = system.connection.value_or(Connection{});
  WatchedMap map(*system.map, allowance);
  const LocalManifold local = local_manifold(map, recipe.saddle.value_or(connection.saddle(side)), side);
  Branch branch = recipe.branch < 0 ? Branch::minus : Branch::plus;
  if (recipe.branch == 0 && !recipe.saddle) branch = branch_towards(local, connection.direction(side));
  GrowthOptions options;
  options.tolerance = recipe.tolerance;
  options.iterates = recipe.iterates;
  if (recipe.length > 0) options.length = recipe.length;
  options.max_memory = allowance.most();
  options.progress = [&](const GrowthProgress& progress) { return map.report(progress); };
  GrownManifold manifold = grow(map, local, branch, options);
  if (manifold.stop != GrowthStop::iterates && manifold.stop != GrowthStop::length &&
      manifold.stop != GrowthStop::ended) {
    stopped_early("growing", manifold.stop, allowance);
  }
  return {{manifold.points.begin(), manifold.points.end()}, false, recipe.name()};
}

Curve image(const CurveRecipe& recipe, const PlanarMap& of_system, const Curve& of, const Allowance& allowance) {
  WatchedMap map(of_system, allowance);
  ImageOptions options;
  options.tolerance = recipe.tolerance;
  options.max_points =
      std::min(options.max_points, std::max<std::size_t>(allowance.most() / computed_bytes_per_point, 3));
  options.progress = [&](const GrowthProgress& progress) { return map.report(progress); };
  const CurveImage made = image_of(map, recipe.iterates, CurveView(of), options);
  if (made.stop != GrowthStop::iterates) stopped_early("the image", made.stop, allowance);
  for (const GrowthDiagnostic& diagnostic : made.diagnostics) {
    if (diagnostic.cause == GrowthDiagnosticCause::failed) throw DataError("points of the curve have no image");
  }
  return {{made.points.begin(), made.points.end()}, of.closed, recipe.name(of.name)};
}

}  // namespace

std::string CurveRecipe::name(std::string_view of) const {
  std::string text = kind == Kind::unstable ? "unstable(" : kind == Kind::stable ? "stable(" : "image(";
  if (kind == Kind::image) text += std::string(of) + ", ";
  text += system;
  const auto add = [&](const std::string& key, const std::string& value) { text += ", " + key + "=" + value; };
  for (const auto& [key, value] : parameters) add(key, format_number(value));
  if (iterates >= 0 || kind == Kind::image) add("iterates", std::to_string(iterates));
  if (length > 0) add("length", format_number(length));
  add("tolerance", format_number(tolerance));
  if (integration_tolerance != CurveRecipe{}.integration_tolerance) {
    add("integration_tolerance", format_number(integration_tolerance));
  }
  if (saddle) add("from", "[" + format_number(saddle->x) + " " + format_number(saddle->y) + "]");
  if (branch != 0) add("branch", branch < 0 ? "-" : "+");
  return text + ")";
}

void check(const CurveRecipe& recipe) {
  const System system = made_system(recipe);
  if (!(recipe.tolerance > 0)) throw UsageError("tolerance has to be given and positive");
  if (recipe.kind == CurveRecipe::Kind::image) return;
  if (recipe.iterates < 0 && !(recipe.length > 0)) throw UsageError("a manifold needs iterates or length");
  if (!recipe.saddle && !system.connection)
    throw UsageError(recipe.system + " names no manifolds" +
                     (system.no_connection.empty() ? "" : " at these parameters (" + system.no_connection + ")") +
                     ": from = [x, y] has to be given");
}

std::string recipe_digest(const CurveRecipe& recipe, std::string_view of) {
  if (recipe.kind == CurveRecipe::Kind::image && of.empty()) return {};
  const std::string text = "lober " + std::string(engine_version()) + '\n' + recipe.name(of);
  return sha256(std::as_bytes(std::span(text)));
}

CurveUnit manifold_unit(const CurveRecipe& recipe) {
  CurveUnit unit;
  unit.points = guessed_points;
  unit.reading_memory = computed_bytes_per_point * guessed_points;
  unit.load = [recipe](const Loading& loading) {
    LoadedCurve loaded;
    if (loading.digests) loaded.digest = recipe_digest(recipe);
    try {
      loaded.curve = std::make_shared<const Curve>(grown(recipe, loading.allowance));
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      loaded.error = recipe.name() + ": " + error.what();
    }
    return std::vector<LoadedCurve>{std::move(loaded)};
  };
  return unit;
}

CurveUnit image_unit(const CurveRecipe& recipe, CurveUnit of) {
  CurveUnit unit = of;
  unit.points = of.points * static_cast<std::size_t>(1 + std::abs(recipe.iterates));
  unit.reading_memory = of.reading_memory + computed_bytes_per_point * unit.points;
  unit.load = [recipe, load = std::move(of.load)](const Loading& loading) {
    std::vector<LoadedCurve> all = load(loading);
    const System system = made_system(recipe);
    for (LoadedCurve& one : all) {
      one.digest = recipe_digest(recipe, one.digest);
      if (!one.error.empty()) continue;
      try {
        one.curve = std::make_shared<const Curve>(image(recipe, *system.map, *one.curve, loading.allowance));
      } catch (const Cancelled&) {
        throw;
      } catch (const Error& error) {
        one.error = recipe.name(one.curve->name) + ": " + error.what();
      }
    }
    return all;
  };
  return unit;
}

}  // namespace lober::detail
