// Systems and images of points, for C.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "engine/c/call.hpp"
#include "engine/c/model.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::c {
namespace {

// Images of `from` into `to`, which may be the same and stays as it is where the work is cancelled. Integrations ask by
// themselves whether it is; a formula does not, so it takes some steps at a time.
void iterate(const lober_model& model, const PlanarMap& map, std::span<const Point> from, Point* to, int iterates) {
  constexpr std::size_t together = 4096;
  const std::int64_t all = std::abs(std::int64_t{iterates});
  Buffer<Point> points(from.begin(), from.end());
  std::atomic<double> done{0};
  run_watched(done, [&] {
    for_each_block(points.size(), together, [&](std::size_t begin, std::size_t end) {
      const std::span<Point> block = std::span(points).subspan(begin, end - begin);
      const double share = static_cast<double>(block.size()) / static_cast<double>(points.size());
      const std::int64_t at_once = model.system().flow ? all : std::int64_t{16 * together} / std::ssize(block);
      for (std::int64_t k = 0; k < all; k += at_once) {
        throw_if_cancelled();
        const std::int64_t steps = std::min(at_once, all - k);
        map.iterate(block, static_cast<int>(iterates < 0 ? -steps : steps));
        done += share * static_cast<double>(steps) / static_cast<double>(all);
      }
    });
  });
  std::copy(points.begin(), points.end(), to);
}

}  // namespace

const PlanarMap& map_of(const lober_model* model) {
  if (!model) throw UsageError("no model is given");
  if (!model->system().map) throw DataError("system " + model->system().info.name + " has no map for these parameters");
  return *model->system().map;
}

}  // namespace lober::detail::c

int lober_model_open(const char* name, const char* parameters, const char* options, lober_model** model) {
  using namespace lober::detail::c;
  if (model) *model = nullptr;
  return guarded([&] {
    if (!name || !model) throw lober::UsageError("name or model is a null pointer");
    lober::ParameterValues values;
    for (const auto& [parameter, value] : words_of(parameters))
      values.emplace_back(parameter, number_of(parameter, value));
    Options given(options);
    lober::IntegrationOptions integration;
    integration.tolerance = given.number("tolerance", integration.tolerance);
    given.require_all_known();
    *model = new lober_model{lober::operations::system_input(name, values, integration)};
  });
}

void lober_model_free(lober_model* model) {
  delete model;
}

int lober_systems(lober_result** result) {
  using namespace lober::detail::c;
  return operation(nullptr, result, [](Options&) {
    return [](lober_result& made) {
      std::string names, summaries;
      for (const lober::SystemInfo& info : lober::list_systems()) {
        names += (names.empty() ? "" : "\n") + info.name;
        summaries += (summaries.empty() ? "" : "\n") + info.summary;
      }
      made.add("names", std::move(names));
      made.add("summaries", std::move(summaries));
    };
  });
}

int lober_iterate(const lober_model* model, double* points, size_t n, int iterates) {
  using namespace lober::detail::c;
  return guarded([&] {
    iterate(*model, map_of(model), points_of(points, n, "points"), reinterpret_cast<lober::Point*>(points), iterates);
  });
}
