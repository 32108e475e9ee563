// Flows of one's own fields, and what a field does unless it says otherwise.
#include "lober/dynamics/vector_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/dynamics/maps/right_hand_sides.hpp"
#include "engine/dynamics/systems/library_checks.hpp"
#include "engine/dynamics/systems/own_field.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober {

namespace {

// Central differences of order 4, with steps of this part of the size of a state.
constexpr std::array<double, 4> offsets{1, -1, 2, -2};
constexpr double step_part = 1e-3;

double step_at(const VectorField& field, std::size_t count, const double* x, std::size_t k) {
  double size = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(field.dimension()); ++i) {
    size = std::max(size, std::fabs(x[i * count + k]));
  }
  return step_part * std::min(1 + size, field.extent());
}

}  // namespace

double unit_within(double extent) {
  constexpr double smallest = 1e-300, largest = 1e300;
  if (!(extent >= smallest && extent <= largest)) return 1;
  // Read from their decimal forms, so that they are those numbers and not ones beside them.
  const auto ten_to = [](int power) { return std::stod("1e" + std::to_string(power)); };
  const int power = static_cast<int>(std::lround(detail::elementary::log10(extent)));
  return ten_to(power) <= extent ? ten_to(power) : ten_to(power - 1);
}

void VectorField::jacobians(std::size_t count, const double* x, const double* t, double* jacobian) const {
  const auto n = static_cast<std::size_t>(dimension());
  // The derivatives along the axes, each as a tangent vector.
  std::vector<double> with_axes(n * (1 + n) * count), slopes(n * (1 + n) * count);
  std::copy_n(x, n * count, with_axes.begin());
  for (std::size_t j = 0; j < n; ++j)
    std::fill_n(with_axes.begin() + static_cast<std::ptrdiff_t>((n * (1 + j) + j) * count), count, 1.0);
  detail::velocities_with_tangents(*this, n, count, with_axes.data(), t, slopes.data());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      std::copy_n(slopes.data() + (n * (1 + j) + i) * count, count, jacobian + (i * n + j) * count);
    }
  }
}

void detail::velocities_with_tangents(const VectorField& field, std::size_t tangents, std::size_t count,
                                      const double* x, const double* t, double* dxdt) {
  // The point itself, and x + h v, x - h v, x + 2 h v and x - 2 h v for each tangent vector, some thousand at a time.
  constexpr std::size_t max_points = 16384;
  const auto n = static_cast<std::size_t>(field.dimension());
  const std::size_t each = 1 + offsets.size() * tangents, chunk = std::max<std::size_t>(1, max_points / each);
  std::vector<double> from, to, times, steps, lengths;
  for (std::size_t first = 0; first < count; first += chunk) {
    const std::size_t some = std::min(chunk, count - first), all = each * some;
    from.resize(n * all);
    to.resize(n * all);
    times.resize(all);
    steps.resize(some);
    lengths.resize(some);
    for (std::size_t k = 0; k < some; ++k) steps[k] = step_at(field, count, x, first + k);
    for (std::size_t i = 0; i < n; ++i) std::copy_n(x + i * count + first, some, from.data() + i * all);
    for (std::size_t column = 0; column < each; ++column) std::copy_n(t + first, some, times.data() + column * some);
    const auto length_of = [&](std::size_t m) {
      std::fill(lengths.begin(), lengths.end(), 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        const double* const v = x + (n * (1 + m) + i) * count + first;
        for (std::size_t k = 0; k < some; ++k) lengths[k] = std::max(lengths[k], std::fabs(v[k]));
      }
    };
    for (std::size_t m = 0; m < tangents; ++m) {
      length_of(m);
      for (std::size_t a = 0; a < offsets.size(); ++a) {
        const std::size_t column = (1 + m * offsets.size() + a) * some;
        for (std::size_t i = 0; i < n; ++i) {
          const double* const v = x + (n * (1 + m) + i) * count + first;
          double* const at = from.data() + i * all;
          for (std::size_t k = 0; k < some; ++k) {
            at[column + k] = at[k] + (lengths[k] > 0 ? offsets[a] * steps[k] * (v[k] / lengths[k]) : 0);
          }
        }
      }
    }
    field.velocities(all, from.data(), times.data(), to.data());
    for (std::size_t i = 0; i < n; ++i) std::copy_n(to.data() + i * all, some, dxdt + i * count + first);
    for (std::size_t m = 0; m < tangents; ++m) {
      length_of(m);
      for (std::size_t i = 0; i < n; ++i) {
        const double* const at = to.data() + i * all + (1 + m * offsets.size()) * some;
        double* const slope = dxdt + (n * (1 + m) + i) * count + first;
        for (std::size_t k = 0; k < some; ++k) {
          const double near = at[k] - at[some + k], far = at[2 * some + k] - at[3 * some + k];
          slope[k] = lengths[k] * ((8 * near - far) / (12 * steps[k]));
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
