// Evaluations of the map that a sweep takes, against those of its values by themselves. One with a derivative counts
// three times; those of the map that is integrated to a hundredth of the tolerance, which judges points, count too.
// Prints a table, or a row of it: bench_sweep [SYSTEM PARAMETER FIRST LAST VALUES].
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lober/dynamics/systems.hpp"
#include "lober/transport/sweep.hpp"

namespace lober {
namespace {

class CountingMap final : public PlanarMap {
 public:
  CountingMap(std::shared_ptr<const PlanarMap> map, std::atomic<std::uint64_t>& count)
      : map_(std::move(map)), count_(count) {}
  void iterate(std::span<Point> points, int iterates) const override {
    add(points.size(), iterates);
    map_->iterate(points, iterates);
  }
  [[nodiscard]] bool is_defined_at(Point point) const override { return map_->is_defined_at(point); }
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    add(3, iterates);
    return map_->iterate_with_derivative(point, iterates, derivative);
  }
  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override {
    add(3 * points.size(), iterates);
    map_->iterate_with_derivatives(points, iterates, derivatives);
  }
  [[nodiscard]] std::optional<long double> action(Point from, Point to) const override {
    return map_->action(from, to);
  }
  [[nodiscard]] double action_accuracy() const override { return map_->action_accuracy(); }
  [[nodiscard]] double unit() const override { return map_->unit(); }
  [[nodiscard]] std::size_t batch() const override { return map_->batch(); }
  [[nodiscard]] std::unique_ptr<PlanarMap> finer() const override {
    std::shared_ptr<const PlanarMap> finer = map_->finer();
    return finer ? std::make_unique<CountingMap>(std::move(finer), count_) : nullptr;
  }
  [[nodiscard]] std::unique_ptr<PlanarMap> half() const override { return map_->half(); }
  [[nodiscard]] std::uint64_t work() const override { return map_->work(); }
  [[nodiscard]] std::uint64_t work_of_derivatives() const override { return map_->work_of_derivatives(); }

 private:
  void add(std::size_t points, int iterates) const {
    count_ += points * static_cast<std::uint64_t>(std::abs(iterates));
  }
  std::shared_ptr<const PlanarMap> map_;
  std::atomic<std::uint64_t>& count_;
};

struct Scene {
  const char* system;
  const char* parameter;
  double first, last;
  int values;
};

void count(const Scene& scene) {
  std::atomic<std::uint64_t> count{0};
  const Family family = [&](double value) -> FamilyMember {
    const System system = make_system(scene.system, {{scene.parameter, value}});
    if (!system.connection) throw std::runtime_error(system.no_connection);
    return {std::make_shared<CountingMap>(system.map, count), *system.connection, system.lattice};
  };
  std::vector<double> values;
  for (int k = 0; k < scene.values; ++k)
    values.push_back(scene.first + (scene.last - scene.first) * k / (scene.values - 1));
  const std::size_t failed = sweep(family, values).failures();
  const auto together = static_cast<double>(count.exchange(0));
  std::size_t failed_apart = 0;
  for (const double value : values) failed_apart += sweep(family, std::array{value}).failures();
  const auto apart = static_cast<double>(count.exchange(0));
  std::printf("| %s | %s | %g to %g | %d | %zu | %zu | %.0f | %.0f | %.2f |\n", scene.system, scene.parameter,
              scene.first, scene.last, scene.values, failed, failed_apart, together / scene.values,
              apart / scene.values, apart / together);
  std::fflush(stdout);
}

constexpr Scene scenes[] = {{"standard", "K", 0.9, 1.5, 31},     {"henon", "k", 0.3, 0.7, 21},
                            {"ovp", "gamma", 1.3, 1.5, 17},      {"ovp", "gamma", 0.5, 2, 31},
                            {"ovp1", "gamma", 0.5, 2, 31},       {"double-gyre", "eps", 0.1, 0.2, 9},
                            {"duffing", "eps", 0.1, 0.3, 21},    {"pendulum", "eps", 0.1, 0.3, 21},
                            {"pcr3bp", "mu", 0.0009, 0.001, 21}, {"pcr3bp", "energy", -1.54, -1.52, 9}};

}  // namespace
}  // namespace lober

int main(int argc, char** argv) {
  std::printf("| system | parameter | values | number | failed | by themselves | a value | by itself | ratio |\n");
  std::printf("|---|---|---|---:|---:|---:|---:|---:|---:|\n");
  if (argc == 6) {
    lober::count({argv[1], argv[2], std::atof(argv[3]), std::atof(argv[4]), std::atoi(argv[5])});
    return 0;
  }
  for (const lober::Scene& scene : lober::scenes) lober::count(scene);
}
