// The maps and flows that are made of a library's functions, and the system with all that the description adds.
#include "engine/dynamics/systems/loaded_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/dynamics/maps/formula_map.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/library_checks.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/periodic_orbit.hpp"
#include "lober/dynamics/vector_field.hpp"

namespace lober::detail {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The arguments with which a library's functions are called.
struct Loaded {
  Library library;
  const lober_system* system;
  std::vector<double> parameters;

  /// The larger side of its window.
  [[nodiscard]] double extent() const {
    return std::max(system->window[2] - system->window[0], system->window[3] - system->window[1]);
  }
};

/// A map of a library, for FormulaMap.
class LoadedMap {
 public:
  explicit LoadedMap(Loaded loaded)
      : loaded_(std::make_shared<const Loaded>(std::move(loaded))), unit_(unit_within(loaded_->extent())) {}

  Point forward(Point z) const { return apply(loaded_->system->map->forward, z); }
  Point backward(Point z) const { return apply(loaded_->system->map->backward, z); }
  Matrix2 derivative(Point z) const {
    const std::array<double, 2> from{z.x, z.y};
    std::array<double, 4> d{};
    if (loaded_->system->map->derivative(loaded_->parameters.data(), from.data(), d.data()) != 0) d.fill(nan);
    return {d[0], d[1], d[2], d[3]};
  }
  [[nodiscard]] double unit() const { return unit_; }

 protected:
  [[nodiscard]] const Loaded& loaded() const { return *loaded_; }

 private:
  [[nodiscard]] Point apply(int (*function)(const double*, const double*, double*), Point z) const {
    const std::array<double, 2> from{z.x, z.y};
    std::array<double, 2> to{};
    if (function(loaded_->parameters.data(), from.data(), to.data()) != 0) return lost_point;
    return {to[0], to[1]};
  }

  std::shared_ptr<const Loaded> loaded_;
  double unit_;
};

/// One that has a generating function.
class LoadedMapWithAction : public LoadedMap {
 public:
  using LoadedMap::LoadedMap;
  long double action(Point from, Point to) const {
    return loaded().system->map->action(loaded().parameters.data(), from.x, to.x);
  }
};

/// The vector field of a library.
class LoadedField final : public VectorField {
 public:
  explicit LoadedField(Loaded loaded) : loaded_(std::move(loaded)) {
    const lober_flow& flow = given();
    if (flow.period != nullptr) period_ = flow.period(parameters());
    if (flow.hamiltonian == nullptr) return;
    for (std::size_t k = 0; k < flow.pair_count; ++k) {
      const lober_conjugate_pair& pair = flow.pairs[k];
      pairs_.push_back({pair.q, pair.p, pair.factor != nullptr ? pair.factor(parameters()) : 1});
    }
  }

  [[nodiscard]] int dimension() const override { return given().dimension; }
  [[nodiscard]] double extent() const override { return loaded_.extent(); }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] std::span<const ConjugatePair> conjugate_pairs() const override { return pairs_; }
  void velocities(std::size_t count, const double* x, const double* t, double* dxdt) const override {
    if (count > 1 && batch() > 1) {
      given().velocity_batch(parameters(), count, x, t, dxdt);
    } else {
      each(given().velocity, count, x, t, static_cast<std::size_t>(dimension()), dxdt);
    }
  }
  void jacobians(std::size_t count, const double* x, const double* t, double* jacobian) const override {
    each(given().jacobian, count, x, t, static_cast<std::size_t>(dimension()) * static_cast<std::size_t>(dimension()),
         jacobian);
  }
  [[nodiscard]] bool has_jacobian() const override { return true; }
  void hamiltonians(std::size_t count, const double* x, const double* t, double* h) const override {
    const auto value = [this](const double* parameters, const double* at, double time, double* to) {
      *to = given().hamiltonian(parameters, at, time);
      return 0;
    };
    each(value, count, x, t, 1, h);
  }
  [[nodiscard]] std::size_t batch() const override {
    return loaded_.system->abi >= 3 && given().velocity_batch != nullptr ? 8 : 1;
  }

 private:
  [[nodiscard]] const lober_flow& given() const { return *loaded_.system->flow; }
  [[nodiscard]] const double* parameters() const { return loaded_.parameters.data(); }

  /// Calls a function of one point, which gives `numbers` numbers, for each of some points.
  template <typename Function>
  void each(const Function& function, std::size_t count, const double* x, const double* t, std::size_t numbers,
            double* to) const {
    double at[LOBER_MAX_DIMENSION] = {}, found[LOBER_MAX_DIMENSION * LOBER_MAX_DIMENSION] = {};
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(dimension()); ++i) at[i] = x[i * count + k];
      if (function(parameters(), at, t[k], found) != 0) std::fill_n(found, numbers, nan);
      for (std::size_t i = 0; i < numbers; ++i) to[i * count + k] = found[i];
    }
  }

  Loaded loaded_;
  double period_ = 0;
  std::vector<ConjugatePair> pairs_;
};

Section section_of(const lober_section& section, unsigned abi) {
  return {.coordinate = section.coordinate,
          .value = section.value,
          .direction = section.direction,
          .chart_x = section.chart_x,
          .chart_y = section.chart_y,
          .solved = section.solved,
          .bound_coordinate = section.bound_coordinate,
          .bound = section.bound,
          .bound_side = section.bound_side,
          .period = abi >= 4 ? section.period : 0};
}

/// The map of a flow, where its description says which.
FieldMap field_map_of(const lober_system& system, std::span<const double> values) {
  FieldMap how;
  if (system.flow->section != nullptr && system.flow->section->energy_parameter >= 0) {
    how.energy = values[static_cast<std::size_t>(system.flow->section->energy_parameter)];
  }
  for (std::size_t k = 0; k < system.parameter_count; ++k) {
    if (std::string_view(system.parameters[k].name) == "phase") how.phase = values[k];
  }
  return how;
}

Point point_of(const double (&numbers)[2]) {
  return {numbers[0], numbers[1]};
}

bool has_finite_numbers(const lober_connection& given) {
  bool finite = all_finite(given.from) && all_finite(given.u_direction) && all_finite(given.to) &&
                all_finite(given.s_direction) && (given.has_bip == 0 || all_finite(given.bip));
  for (std::size_t k = 0; k < given.corner_count; ++k) finite = finite && all_finite(given.corners[k]);
  return finite;
}

/// Sets the connections that a library of version 2 describes.
void set_connections(System& made, const lober_system& system, std::span<const double> values) {
  if (system.abi < 2) return;
  for (std::size_t k = 0; k < system.connection_count; ++k) {
    lober_connection found{};
    const std::string where = std::string("system ") + system.name + ": connection " + std::to_string(k);
    if (system.connection(values.data(), k, &found) != 0) throw DataError(where + " is not given for these parameters");
    if (found.corner_count > LOBER_MAX_CORNERS) throw DataError(where + " has too many corners");
    if (!has_finite_numbers(found)) throw DataError(where + " has a number that is not finite for these parameters");
    Connection connection{point_of(found.from), point_of(found.u_direction), point_of(found.to),
                          point_of(found.s_direction)};
    if (found.has_bip != 0) connection.bip = point_of(found.bip);
    for (std::size_t corner = 0; corner < found.corner_count; ++corner)
      connection.closure.push_back(point_of(found.corners[corner]));
    if (k == 0) {
      made.connection = std::move(connection);
    } else {
      made.further.push_back(std::move(connection));
    }
  }
  made.further_needed = system.all_bound_region_1 != 0;
}

/// Sets the saddles that a library of version 5 describes; the flow is made.
void set_saddles(System& made, const lober_system& system, std::span<const double> values) {
  if (system.abi < 5) return;
  for (std::size_t k = 0; k < system.saddle_count; ++k) {
    const std::string where = std::string("system ") + system.name + ": saddle " + std::to_string(k);
    FlowState state{};
    if (system.saddle(values.data(), k, state.data()) != 0) {
      throw DataError(where + " is not given for these parameters");
    }
    const std::span<const ConjugatePair> pairs = made.flow->conjugate_pairs();
    const auto is_nan = [&](const ConjugatePair& pair) { return std::isnan(state[static_cast<std::size_t>(pair.p)]); };
    if (std::all_of(pairs.begin(), pairs.end(), is_nan)) {
      const auto position = [&](std::size_t pair) { return state[static_cast<std::size_t>(pairs[pair].q)]; };
      state = state_at_rest(*made.flow, {position(0), position(1)});
    }
    if (!all_finite(state)) throw DataError(where + " has a number that is not finite for these parameters");
    made.saddles.push_back(state);
  }
}

}  // namespace

System make_loaded_system(const Library& library, const lober_system& system, std::span<const double> values,
                          const IntegrationOptions& options) {
  const Loaded loaded{library, &system, {values.begin(), values.end()}};
  System made;
  made.info.name = system.name;
  made.window = window(system.window[0], system.window[1], system.window[2], system.window[3]);
  made.lattice = {system.lattice[0], system.lattice[1]};
  if (system.abi >= 4) made.second_lattice = {system.second_lattice[0], system.second_lattice[1]};
  set_connections(made, system, values);
  if (system.kind == LOBER_FLOW) {
    const lober_flow& flow = *system.flow;
    if (flow.dimension == 2 && flow.section == nullptr && flow.period != nullptr && !(flow.period(values.data()) > 0)) {
      throw UsageError("system " + made.info.name + ": its period is not positive");
    }
    if (flow.section != nullptr) made.section = section_of(*flow.section, system.abi);
    made = make_system(std::make_shared<LoadedField>(loaded), std::move(made), field_map_of(system, values), options);
    set_saddles(made, system, values);
    return made;
  }
  if (system.map->action != nullptr) {
    made.map = std::make_shared<FormulaMap<LoadedMapWithAction>>(LoadedMapWithAction(loaded));
  } else {
    made.map = std::make_shared<FormulaMap<LoadedMap>>(LoadedMap(loaded));
  }
  check_library_map(system, made, values);
  return made;
}

}  // namespace lober::detail
