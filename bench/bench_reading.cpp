// How fast curves are read and written: bytes of file per second. The files lie in the temporary folder, that
// is, in the page cache.
//
// Single-threaded rows say what the parser does; the others what a user waits for.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"

namespace {

using lober::Point;

constexpr std::size_t points_per_file = 1'000'000;
constexpr int all_threads = 0;

std::vector<Point> random_points() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  std::vector<Point> points(points_per_file);
  for (Point& point : points) point = {coordinate(random), coordinate(random)};
  return points;
}

/// A file that exists as long as the benchmark runs.
class TemporaryFile {
 public:
  explicit TemporaryFile(const char* name) : path_(std::filesystem::temp_directory_path() / name) {}
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }
  [[nodiscard]] std::size_t size() const { return std::filesystem::file_size(path_); }

 private:
  std::filesystem::path path_;
};

void print_file(const std::string& path, const char* line_format) {
  std::string text;
  for (const Point& point : random_points()) {
    char line[160];
    const int size = std::snprintf(line, sizeof line, line_format, point.x, point.y);
    text.append(line, static_cast<std::size_t>(size));
  }
  lober::write_file(path, text);
}

void read_repeatedly(benchmark::State& state, const TemporaryFile& file, int threads, bool hash) {
  lober::detail::with_threads(threads, [&] {
    for (auto _ : state) benchmark::DoNotOptimize(lober::read_curve_file(file.path(), {.hash = hash}));
  });
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file.size()));
}

/// Seventeen digits: what a program prints that loses nothing.
void read_17_digits(benchmark::State& state, int threads, bool hash) {
  const TemporaryFile file("lober-bench-17.txt");
  print_file(file.path(), "%.17g %.17g\n");
  read_repeatedly(state, file, threads, hash);
}
BENCHMARK_CAPTURE(read_17_digits, one_thread, 1, false)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_17_digits, one_thread_hashed, 1, true)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_17_digits, all_threads, all_threads, false)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_17_digits, all_threads_hashed, all_threads, true)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Thirty digits behind the point: as Lober 1.8 writes them.
void read_30_digits(benchmark::State& state, int threads) {
  const TemporaryFile file("lober-bench-30.txt");
  print_file(file.path(), "%33.30f\t%33.30f\n");
  read_repeatedly(state, file, threads, false);
}
BENCHMARK_CAPTURE(read_30_digits, one_thread, 1)->UseRealTime()->Unit(benchmark::kMillisecond);

void read_npy(benchmark::State& state, int threads) {
  const TemporaryFile file("lober-bench.npy");
  lober::write_npy(file.path(), random_points());
  read_repeatedly(state, file, threads, false);
}
BENCHMARK_CAPTURE(read_npy, one_thread, 1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_npy, all_threads, all_threads)->UseRealTime()->Unit(benchmark::kMillisecond);

void write_text(benchmark::State& state, int threads) {
  const TemporaryFile file("lober-bench-out.txt");
  const std::vector<Point> points = random_points();
  lober::detail::with_threads(threads, [&] {
    for (auto _ : state) lober::write_text(file.path(), points);
  });
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file.size()));
}
BENCHMARK_CAPTURE(write_text, one_thread, 1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_text, all_threads, all_threads)->UseRealTime()->Unit(benchmark::kMillisecond);

void hash(benchmark::State& state) {
  const std::vector<std::byte> bytes(std::size_t{1} << 24, std::byte{'7'});
  for (auto _ : state) benchmark::DoNotOptimize(lober::sha256(bytes));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(hash)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
