// Flows of one's own fields, and what a field does unless it says otherwise.
#include "lober/dynamics/vector_field.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/dynamics/systems/library_checks.hpp"
#include "engine/dynamics/systems/own_field.hpp"
#include "lober/base/error.hpp"

namespace lober {

void VectorField::jacobians(std::size_t count, const double* x, const double* t, double* jacobian) const {
  // At x + h, x - h, x + 2 h and x - 2 h along each coordinate, some thousand points at a time.
  constexpr std::size_t around = 4, max_points = 8192;
  constexpr double offsets[around] = {1, -1, 2, -2};
  constexpr double part = 1e-3;
  const auto n = static_cast<std::size_t>(dimension());
  const std::size_t each = around * n, chunk = std::max<std::size_t>(1, max_points / each);
  std::vector<double> from, to, times, steps;
  for (std::size_t first = 0; first < count; first += chunk) {
    const std::size_t some = std::min(chunk, count - first), all = each * some;
    from.resize(n * all);
    to.resize(n * all);
    times.resize(all);
    steps.resize(some);
    for (std::size_t k = 0; k < some; ++k) {
      double size = 0;
      for (std::size_t i = 0; i < n; ++i) size = std::max(size, std::fabs(x[i * count + first + k]));
      steps[k] = part * std::min(1 + size, extent());
    }
    for (std::size_t moved = 0; moved < n; ++moved) {
      for (std::size_t a = 0; a < around; ++a) {
        const std::size_t column = (moved * around + a) * some;
        for (std::size_t k = 0; k < some; ++k) {
          for (std::size_t i = 0; i < n; ++i) from[i * all + column + k] = x[i * count + first + k];
          from[moved * all + column + k] += offsets[a] * steps[k];
          times[column + k] = t[first + k];
        }
      }
    }
    velocities(all, from.data(), times.data(), to.data());
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const double* const at = to.data() + i * all + j * around * some;
        for (std::size_t k = 0; k < some; ++k) {
          const double near = at[k] - at[some + k], far = at[2 * some + k] - at[3 * some + k];
          jacobian[(i * n + j) * count + first + k] = (8 * near - far) / (12 * steps[k]);
        }
      }
    }
  }
}

void VectorField::hamiltonians(std::size_t /*count*/, const double* /*x*/, const double* /*t*/, double* /*h*/) const {
  throw UsageError("the vector field has conjugate pairs, but no Hamiltonian");
}

namespace {

template <bool periodic>
std::shared_ptr<const Flow> flow_of_field(std::shared_ptr<const VectorField> field) {
  const auto of_dimension = [&]<int N>() -> std::shared_ptr<const Flow> {
    return std::make_shared<detail::FlowOf<detail::OwnField<N, periodic>>>(
        detail::OwnField<N, periodic>(std::move(field)));
  };
  switch (field->dimension()) {
    case 1:
      return of_dimension.template operator()<1>();
    case 2:
      return of_dimension.template operator()<2>();
    case 3:
      return of_dimension.template operator()<3>();
    case 4:
      return of_dimension.template operator()<4>();
    case 5:
      return of_dimension.template operator()<5>();
    default:
      return of_dimension.template operator()<6>();
  }
}

}  // namespace

std::shared_ptr<const Flow> make_flow(std::shared_ptr<const VectorField> field) {
  const int dimension = field->dimension();
  if (dimension < 1 || dimension > max_flow_dimension)
    throw UsageError("the dimension of a vector field is not 1 to 6");
  for (const ConjugatePair& pair : field->conjugate_pairs()) {
    if (std::min(pair.q, pair.p) < 0 || std::max(pair.q, pair.p) >= dimension) {
      throw UsageError("a conjugate pair names a coordinate beyond the dimension");
    }
  }
  return field->period() != 0 ? flow_of_field<true>(std::move(field)) : flow_of_field<false>(std::move(field));
}

System make_system(std::shared_ptr<const VectorField> field, System described, const FieldMap& map,
                   const IntegrationOptions& given) {
  const Rectangle& window = described.window;
  const double farthest =
      std::max({std::fabs(window.min_x), std::fabs(window.max_x), std::fabs(window.min_y), std::fabs(window.max_y)});
  IntegrationOptions options = given;
  if (options.escape == IntegrationOptions{}.escape) options.escape = std::max(options.escape, 1e3 * farthest);
  const VectorField& checked = *field;  // the flow keeps it alive
  described.flow = make_flow(std::move(field));
  if (described.section) {
    described.map = described.flow->section_map(*described.section, map.energy, options);
  } else if (checked.dimension() == 2 && checked.period() != 0) {
    if (!(checked.period() > 0)) throw UsageError("system " + described.info.name + ": its period is not positive");
    described.map = described.flow->stroboscopic_map(map.phase, options);
  }
  if (described.picture.empty()) described.picture = described.window;
  detail::check_flow(checked, described, map.energy);
  return described;
}

}  // namespace lober
