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

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/maps/formula_map.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/library_checks.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The arguments with which a library's functions are called.
struct Loaded {
  Library library;
  const lober_system* system;
  std::vector<double> parameters;
};

/// A map of a library, for FormulaMap.
class LoadedMap {
 public:
  explicit LoadedMap(Loaded loaded) : loaded_(std::make_shared<const Loaded>(std::move(loaded))) {}

  Point forward(Point z) const { return apply(loaded_->system->map->forward, z); }
  Point backward(Point z) const { return apply(loaded_->system->map->backward, z); }
  Matrix2 derivative(Point z) const {
    const std::array<double, 2> from{z.x, z.y};
    std::array<double, 4> d{};
    if (loaded_->system->map->derivative(loaded_->parameters.data(), from.data(), d.data()) != 0) d.fill(nan);
    return {d[0], d[1], d[2], d[3]};
  }

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
};

/// One that has a generating function.
class LoadedMapWithAction : public LoadedMap {
 public:
  using LoadedMap::LoadedMap;
  long double action(Point from, Point to) const {
    return loaded().system->map->action(loaded().parameters.data(), from.x, to.x);
  }
};

/// A flow of a library as a field (right_hand_sides.hpp), which gets the time if it is periodic.
template <int N, bool periodic>
class LoadedField {
 public:
  static constexpr int dimension = N;
  static constexpr std::size_t forcings = periodic ? 1 : 0;
  static constexpr bool in_lanes = false;

  explicit LoadedField(Loaded loaded) : loaded_(std::make_shared<const Loaded>(std::move(loaded))) {
    const lober_flow& flow = *loaded_->system->flow;
    if (flow.hamiltonian == nullptr) return;
    for (std::size_t k = 0; k < flow.pair_count; ++k) {
      const lober_conjugate_pair& pair = flow.pairs[k];
      pairs_.push_back({pair.q, pair.p, pair.factor != nullptr ? pair.factor(parameters()) : 1});
    }
  }

  [[nodiscard]] double period() const {
    if constexpr (!periodic) return 0;
    return loaded_->system->flow->period(parameters());
  }
  void forcing(double t, double* force) const {
    if constexpr (periodic) force[0] = t;
  }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return pairs_; }
  void velocity(const double* x, double* dxdt, const double* force) const {
    if (loaded_->system->flow->velocity(parameters(), x, time(force), dxdt) != 0) std::fill_n(dxdt, N, nan);
  }
  /// The velocities at several points, by velocity_batch.
  template <int elements, InstructionSet isa>
  void velocity(const Wide<elements, isa>* x, Wide<elements, isa>* dxdt, const Wide<elements, isa>* force) const {
    double from[N][elements], to[N][elements], t[elements] = {};
    for (int i = 0; i < N; ++i) store_number(from[i], x[i]);
    if constexpr (periodic) store_number(t, force[0]);
    loaded_->system->flow->velocity_batch(parameters(), elements, from[0], t, to[0]);
    for (int i = 0; i < N; ++i) dxdt[i] = load_number<Wide<elements, isa>>(to[i]);
  }
  template <int M>
  void velocity(const Jet<M, double>* x, Jet<M, double>* dxdt, const double* force) const {
    std::array<double, N> at{}, speed{};
    std::array<double, static_cast<std::size_t>(N * N)> jacobian{};
    for (std::size_t i = 0; i < N; ++i) at[i] = x[i].value;
    velocity(at.data(), speed.data(), force);
    if (loaded_->system->flow->jacobian(parameters(), at.data(), time(force), jacobian.data()) != 0) jacobian.fill(nan);
    for (std::size_t i = 0; i < N; ++i) {
      dxdt[i] = Jet<M>(speed[i]);
      for (std::size_t j = 0; j < N; ++j) {
        for (int k = 0; k < M; ++k) dxdt[i].slope[k] += jacobian[i * N + j] * x[j].slope[k];
      }
    }
  }
  /// Steps of trajectories: eight at a time if there is a velocity_batch, however many are wanted, so that each has the
  /// same bits in any company.
  static void steps(const AlongFlow<LoadedField>& rhs, StepBlock<N>& block, std::size_t count) {
    const lober_system& system = *rhs.field.loaded_->system;
    if (system.abi < 3 || system.flow->velocity_batch == nullptr) {
      steps_one_by_one(rhs, block, count);
    } else {
      extrapolation_step<Wide<block_lanes, InstructionSet::baseline>>(rhs, block, 0);
    }
  }
  double hamiltonian(const double* x, const double* force) const {
    return loaded_->system->flow->hamiltonian(parameters(), x, time(force));
  }

 private:
  static double time(const double* force) {
    if constexpr (!periodic) return 0;
    return force[0];
  }
  [[nodiscard]] const double* parameters() const { return loaded_->parameters.data(); }

  std::shared_ptr<const Loaded> loaded_;
  std::vector<ConjugatePair> pairs_;
};

template <bool periodic>
std::shared_ptr<const Flow> make_flow(Loaded loaded) {
  const auto of_dimension = [&]<int N>() -> std::shared_ptr<const Flow> {
    return std::make_shared<FlowOf<LoadedField<N, periodic>>>(LoadedField<N, periodic>(std::move(loaded)));
  };
  switch (loaded.system->flow->dimension) {
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

/// Sets the planar map of a flow, if its description says which.
void set_map(System& made, const lober_system& system, std::span<const double> values,
             const IntegrationOptions& options) {
  const lober_flow& flow = *system.flow;
  if (flow.section != nullptr) {
    const int energy = flow.section->energy_parameter;
    made.section = section_of(*flow.section, system.abi);
    made.map =
        made.flow->section_map(*made.section, energy < 0 ? 0 : values[static_cast<std::size_t>(energy)], options);
  } else if (flow.dimension == 2 && flow.period != nullptr) {
    if (!(made.flow->period() > 0))
      throw UsageError(std::string("system ") + system.name + ": its period is not positive");
    double phase = 0;
    for (std::size_t k = 0; k < system.parameter_count; ++k) {
      if (std::string_view(system.parameters[k].name) == "phase") phase = values[k];
    }
    made.map = made.flow->stroboscopic_map(phase, options);
  }
}

Point point_of(const double (&numbers)[2]) {
  return {numbers[0], numbers[1]};
}

bool is_finite(const lober_connection& given) {
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
    if (!is_finite(found)) throw DataError(where + " has a number that is not finite for these parameters");
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

/// Options whose limit for lost trajectories is far outside the window, in whatever units that is.
IntegrationOptions reaching_beyond(const Rectangle& window, IntegrationOptions options) {
  const double farthest =
      std::max({std::fabs(window.min_x), std::fabs(window.max_x), std::fabs(window.min_y), std::fabs(window.max_y)});
  if (options.escape == IntegrationOptions{}.escape) options.escape = std::max(options.escape, 1e3 * farthest);
  return options;
}

}  // namespace

System make_loaded_system(const Library& library, const lober_system& system, std::span<const double> values,
                          const IntegrationOptions& options) {
  const Loaded loaded{library, &system, {values.begin(), values.end()}};
  System made;
  made.window = window(system.window[0], system.window[1], system.window[2], system.window[3]);
  made.lattice = {system.lattice[0], system.lattice[1]};
  if (system.abi >= 4) made.second_lattice = {system.second_lattice[0], system.second_lattice[1]};
  set_connections(made, system, values);
  if (system.kind == LOBER_FLOW) {
    const bool periodic = system.flow->period != nullptr && system.flow->period(values.data()) != 0;
    made.flow = periodic ? make_flow<true>(loaded) : make_flow<false>(loaded);
    set_map(made, system, values, reaching_beyond(made.window, options));
    check_library_flow(system, made, values);
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
