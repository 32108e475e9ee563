#include "engine/jobs/recipe.hpp"

#include <cstdlib>
#include <span>

#include "engine/dynamics/grow.hpp"
#include "engine/jobs/provenance.hpp"
#include "engine/jobs/text.hpp"

namespace lober {
namespace {

constexpr std::size_t guessed_points = 100'000;  // of a manifold that was never grown
constexpr std::size_t growing_bytes = 120;       // a point, GrowthOptions::most_memory

System made_system(const CurveRecipe& recipe) {
  return system_of(recipe.system, recipe.parameters, recipe.integration_tolerance);
}

Curve grown(const CurveRecipe& recipe) {
  const System system = made_system(recipe);
  const ManifoldSide side = recipe.kind == CurveRecipe::Kind::stable ? ManifoldSide::stable : ManifoldSide::unstable;
  const Connection connection = system.connection.value_or(Connection{});
  const LocalManifold local = local_manifold(*system.map, recipe.saddle.value_or(connection.saddle(side)), side);
  Branch branch = recipe.branch < 0 ? Branch::minus : Branch::plus;
  if (recipe.branch == 0 && !recipe.saddle) branch = branch_towards(local, connection.direction(side));
  GrowthOptions options;
  options.tolerance = recipe.tolerance;
  options.iterates = recipe.iterates;
  if (recipe.length > 0) options.length = recipe.length;
  GrownManifold manifold = grow(*system.map, local, branch, options);
  if (manifold.stop != GrowthStop::iterates && manifold.stop != GrowthStop::length &&
      manifold.stop != GrowthStop::ended) {
    throw DataError("growing stopped early: " + std::string(name(manifold.stop)));
  }
  return {{manifold.points.begin(), manifold.points.end()}, false, recipe.name()};
}

Curve image(const CurveRecipe& recipe, const PlanarMap& map, const Curve& of) {
  ImageOptions options;
  options.tolerance = recipe.tolerance;
  const CurveImage made = image_of(map, recipe.iterates, CurveView(of), options);
  if (made.stop != GrowthStop::iterates) throw DataError("the image stopped early: " + std::string(name(made.stop)));
  for (const GrowthFlaw& flaw : made.flaws) {
    if (flaw.cause == GrowthFlawCause::failed) throw DataError("points of the curve have no image");
  }
  return {{made.points.begin(), made.points.end()}, of.closed, recipe.name(of.name)};
}

}  // namespace

std::string CurveRecipe::name(std::string_view of) const {
  std::string text = kind == Kind::unstable ? "unstable(" : kind == Kind::stable ? "stable(" : "image(";
  if (kind == Kind::image) text += std::string(of) + ", ";
  text += system;
  const auto add = [&](const std::string& key, const std::string& value) { text += ", " + key + "=" + value; };
  for (const auto& [key, value] : parameters) add(key, shortest(value));
  if (iterates >= 0 || kind == Kind::image) add("iterates", std::to_string(iterates));
  if (length > 0) add("length", shortest(length));
  add("tolerance", shortest(tolerance));
  if (integration_tolerance != CurveRecipe{}.integration_tolerance) {
    add("integration_tolerance", shortest(integration_tolerance));
  }
  if (saddle) add("saddle", "[" + shortest(saddle->x) + " " + shortest(saddle->y) + "]");
  if (branch != 0) add("branch", branch < 0 ? "-" : "+");
  return text + ")";
}

void CurveRecipe::put(ByteWriter& writer) const {
  writer.put(kind);
  writer.put_text(system);
  writer.put(std::uint64_t{parameters.size()});
  for (const auto& [key, value] : parameters) {
    writer.put_text(key);
    writer.put(value);
  }
  writer.put(iterates);
  writer.put(tolerance);
  writer.put(integration_tolerance);
  writer.put(length);
  writer.put(saddle.has_value());
  writer.put(saddle.value_or(Point{}));
  writer.put(branch);
}

CurveRecipe CurveRecipe::get(ByteReader& reader) {
  CurveRecipe recipe;
  recipe.kind = reader.get<Kind>();
  recipe.system = reader.get_text();
  for (auto left = reader.get<std::uint64_t>(); left != 0; --left) {
    std::string key = reader.get_text();
    recipe.parameters.emplace_back(std::move(key), reader.get<double>());
  }
  recipe.iterates = reader.get<int>();
  recipe.tolerance = reader.get<double>();
  recipe.integration_tolerance = reader.get<double>();
  recipe.length = reader.get<double>();
  const bool has_saddle = reader.get<bool>();
  const auto saddle = reader.get<Point>();
  if (has_saddle) recipe.saddle = saddle;
  recipe.branch = reader.get<int>();
  return recipe;
}

void check(const CurveRecipe& recipe) {
  const System system = made_system(recipe);
  if (!(recipe.tolerance > 0)) throw UsageError("tolerance has to be given and positive");
  if (recipe.kind == CurveRecipe::Kind::image) return;
  if (recipe.iterates < 0 && !(recipe.length > 0)) throw UsageError("a manifold needs iterates or length");
  if (!recipe.saddle && !system.connection) throw UsageError(recipe.system + " needs a saddle = [x, y]");
}

System system_of(const std::string& name, const ParameterValues& parameters, double integration_tolerance) {
  if (name.empty()) throw UsageError("the name of a system is missing");
  if (name.find('/') != std::string::npos || name.ends_with(".so")) {
    throw UsageError("systems from shared libraries are not for manifests");
  }
  IntegrationOptions options;
  options.tolerance = integration_tolerance;
  System system = make_system(name, parameters, options);
  if (!system.map) throw UsageError(name + " has no planar map");
  return system;
}

std::string recipe_digest(const CurveRecipe& recipe, std::string_view of) {
  if (recipe.kind == CurveRecipe::Kind::image && of.empty()) return {};
  const std::string text = "lober " + std::string(engine_version()) + '\n' + recipe.name(of);
  return sha256(std::as_bytes(std::span(text)));
}

CurveUnit manifold_unit(const CurveRecipe& recipe) {
  CurveUnit unit;
  unit.points = guessed_points;
  unit.reading_memory = growing_bytes * guessed_points;
  unit.load = [recipe](bool digests) {
    LoadedCurve loaded;
    if (digests) loaded.digest = recipe_digest(recipe);
    try {
      loaded.curve = std::make_shared<const Curve>(grown(recipe));
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
  unit.reading_memory = of.reading_memory + growing_bytes * unit.points;
  unit.load = [recipe, load = std::move(of.load)](bool digests) {
    std::vector<LoadedCurve> all = load(digests);
    const System system = made_system(recipe);
    for (LoadedCurve& one : all) {
      one.digest = recipe_digest(recipe, one.digest);
      if (!one.error.empty()) continue;
      try {
        one.curve = std::make_shared<const Curve>(image(recipe, *system.map, *one.curve));
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

}  // namespace lober
