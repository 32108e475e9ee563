// Throughput of the batch engine: `lober batch run` on sets of curves, on one thread and on two, against a shell loop
// over single `lober` calls and against GEOS in a TBB loop. Everything counts: reading, the store, the commit at the
// end.
//
// The store's writer is a thread of its own, so one thread is measured on one core: left alone, its base would have a
// second core for the writing.
//
// usage: bench_batch [--quick]      prints Markdown

#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/batch/sets.hpp"
#include "bench/rivals/rival.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/batch/batch.hpp"
#include "lober/curve/files.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

namespace fs = std::filesystem;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Run {
  BatchReport report;
  double processor = 0;
};

// Keeps this thread, and those that it starts, to `cores` of the processor's cores.
class OnCores {
 public:
  explicit OnCores(int count) {
    sched_getaffinity(0, sizeof(before_), &before_);
    cpu_set_t some;
    CPU_ZERO(&some);
    for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&some) < count; ++cpu) {
      if (CPU_ISSET(cpu, &before_)) CPU_SET(cpu, &some);
    }
    sched_setaffinity(0, sizeof(some), &some);
  }
  ~OnCores() { sched_setaffinity(0, sizeof(before_), &before_); }
  OnCores(const OnCores&) = delete;
  OnCores& operator=(const OnCores&) = delete;

 private:
  cpu_set_t before_{};
};

// The best of several: other work on the machine only ever adds.
Run run_set(const fs::path& folder, int threads, int repeat) {
  const OnCores cores(threads);
  Run best;
  for (int k = 0; k < repeat; ++k) {
    for (const char* const end : {"", "-wal", "-shm"}) fs::remove(folder / (std::string("store") + end));
    const double before = processor_seconds();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    const Manifest manifest = read_manifest(folder / "job.toml");
    BatchOptions options;
    options.store = folder / "store";
    options.queue.threads = threads;
    const BatchReport report = with_threads(threads, [&] { return run_batch(manifest, options); });
    if (k == 0 || report.wall_seconds < best.report.wall_seconds) best = {report, processor_seconds() - before};
  }
  return best;
}

Pairs all_pairs(const CurveSet& set) {
  Pairs pairs;
  for (std::size_t i = 0; i < set.curves.size(); ++i) {
    for (std::size_t k = i + 1; k < set.curves.size(); ++k) pairs.emplace_back(i, k);
  }
  return pairs;
}

// A regular sample of all pairs.
Pairs sample(const CurveSet& set, std::size_t count) {
  const Pairs all = all_pairs(set);
  Pairs some;
  for (std::size_t k = 0; k < std::min(count, all.size()); ++k)
    some.push_back(all[k * all.size() / std::min(count, all.size())]);
  return some;
}

double shell_loop_seconds_a_pair(const fs::path& folder, const Pairs& pairs) {
  std::string script = "cd '" + folder.string() + "' || exit 1\n";
  for (const auto& [i, k] : pairs) {
    script += std::string(LOBER_PROGRAM) + " overlay curve." + std::to_string(i) + " curve." + std::to_string(k) +
              " > out.txt || exit 1\n";
  }
  write_file(folder / "loop.sh", script);
  const Stopwatch watch;
  if (std::system(("sh '" + (folder / "loop.sh").string() + "'").c_str()) != 0) return 0;
  return watch.seconds() / static_cast<double>(pairs.size());
}

double geos_seconds_a_pair(const CurveSet& set, const Pairs& pairs, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  std::atomic<std::size_t> ran{0};
  const Stopwatch watch;
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t k) {
    ran += run_geos(set.curves[pairs[k].first], set.curves[pairs[k].second]).ran ? 1U : 0U;
  });
  return ran == 0 ? 0 : watch.seconds() / static_cast<double>(pairs.size());
}

struct BareSeconds {
  double searches = 0, overlays = 0;
};

// The work that has to be done in any case: the searches of indexed curves, one after the other, parallel inside; and
// whole overlays of them, for totals only.
BareSeconds bare_seconds(const CurveSet& set, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  std::vector<std::unique_ptr<IndexedCurve>> indexed;
  for (const std::vector<Point>& curve : set.curves)
    indexed.push_back(std::make_unique<IndexedCurve>(CurveView{curve}));
  BareSeconds best;
  for (int repeat = 0; repeat < 3; ++repeat) {
    BareSeconds sum;
    for (const auto& [i, k] : all_pairs(set)) {
      OverlayOptions options;
      options.check_simple = false;
      options.pieces = false;
      const OverlayTiming timing = overlay(*indexed[i], *indexed[k], options).timing;
      sum.searches += timing.crossings + timing.order;
      sum.overlays += timing.total;
    }
    if (repeat == 0 || sum.searches < best.searches) best = sum;
  }
  return best;
}

// Peak resident bytes of `lober batch run --memory`, which computes the same in a process of its own.
double peak_megabytes(const fs::path& folder, const std::string& memory) {
  fs::remove(folder / "limited");
  std::fflush(stdout);
  const pid_t process = fork();
  if (process == 0) {
    const std::string manifest = folder / "job.toml", store = folder / "limited";
    if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(1);
    execl(LOBER_PROGRAM, LOBER_PROGRAM, "batch", "run", manifest.c_str(), "--store", store.c_str(), "--memory",
          memory.c_str(), static_cast<char*>(nullptr));
    _exit(1);
  }
  int status = 0;
  rusage usage{};
  wait4(process, &status, 0, &usage);
  return status == 0 ? static_cast<double>(usage.ru_maxrss) * 1024 / 1e6 : 0;
}

// The peak memory of runs under a memory budget. A process starts with the peak of the one that it was forked from, so
// this comes first, and the set is made in a process of its own.
void note_peaks(const fs::path& root, std::size_t points, std::vector<std::string>& notes) {
  const fs::path folder = root / "limited";
  fs::create_directory(folder);
  std::fflush(stdout);
  const pid_t process = fork();
  if (process == 0) {
    write_set(iterates("iterates", 10, points), folder);
    _exit(0);
  }
  int status = 0;
  if (waitpid(process, &status, 0) != process || status != 0) return;
  for (const char* const memory : {"1G", "400M", "200M", "100M", "40M"}) {
    char text[200];
    std::snprintf(text, sizeof(text), "45 overlaps of 10 iterates of %zu points with --memory %s: peak RSS %.0f MB",
                  points, memory, peak_megabytes(folder, memory));
    notes.emplace_back(text);
  }
  fs::remove_all(folder);
}

void print_set(const CurveSet& set, const fs::path& root, int repeat, std::size_t single_calls, std::size_t geos_pairs,
               std::vector<std::string>& notes) {
  const fs::path folder = root / "set";
  fs::create_directory(folder);
  write_set(set, folder);
  const Run one = run_set(folder, 1, repeat), two = run_set(folder, 2, repeat);
  const auto row = [&](const Run& run) {
    const QueueReport& queue = run.report.queue;
    const double wall = run.report.wall_seconds, available = wall * queue.threads;
    std::printf("| %s | %zu | %d | %.3f | %.0f | %.3g | %.2f | %.2f | %.1f | %.1f | %.1f | %.1f |\n", set.name.c_str(),
                queue.jobs, queue.threads, wall, static_cast<double>(queue.jobs) / wall,
                static_cast<double>(queue.points) / wall, one.report.wall_seconds / wall, run.processor / one.processor,
                100 * queue.cache.read_seconds / available, 100 * queue.cache.prepare_seconds / available,
                100 * queue.operation_seconds / available, 100 * run.report.store_seconds / available);
  };
  row(one);
  row(two);
  std::fflush(stdout);
  const double pair = two.report.wall_seconds / static_cast<double>(two.report.queue.jobs);
  std::string line =
      set.name + ": each file read at most " + std::to_string(two.report.queue.cache.max_reads) + " times";
  char text[200];
  const auto note = [&](const char* format, double value, double ratio) {
    std::snprintf(text, sizeof(text), format, value, ratio);
    line += text;
  };
  if (single_calls > 0) {
    const double loop = shell_loop_seconds_a_pair(folder, sample(set, single_calls));
    note("; shell loop %.3g ms a pair, %.0f times as long", 1e3 * loop, loop / pair);
  }
  if (geos_pairs > 0) {
    const double geos = geos_seconds_a_pair(set, sample(set, geos_pairs), 2);
    note("; GEOS on two threads %.3g ms a pair, %.0f times", 1e3 * geos, geos / pair);
  }
  const BareSeconds bare = bare_seconds(set, 2);
  note("; bare searches %.4f s, overlays of indexed curves %.2f times that", bare.searches,
       bare.overlays / bare.searches);
  const double in_jobs = two.report.queue.operation_seconds / 2;
  note(", the jobs on two threads %.4f s, %.2f times", in_jobs, in_jobs / bare.searches);
  note(", the whole run %.4f s, %.2f times", two.report.wall_seconds, two.report.wall_seconds / bare.searches);
  notes.push_back(std::move(line));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  using namespace lober::bench;
  const bool quick = count > 1 && std::string(arguments[1]) == "--quick";
  std::string root = (std::filesystem::temp_directory_path() / "lober-bench-XXXXXX").string();
  if (mkdtemp(root.data()) == nullptr) return 1;
  std::vector<std::string> notes;
  note_peaks(root, quick ? 100'000 : 1'000'000, notes);
  std::printf(
      "| set | pairs | threads | s | pairs/s | points/s | times one core | processor time | reading %% | indexing %% "
      "| jobs %% | storing %% |\n|:--|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  const int repeat = quick ? 3 : 7;
  const auto measure = [&](const CurveSet& set, int times, std::size_t single_calls, std::size_t geos_pairs) {
    print_set(set, root, times, single_calls, geos_pairs, notes);
  };
  measure(wavy_set("10^4 pairs of 10^3", 142, 1'000), repeat, 50, 300);
  if (!quick) measure(wavy_set("10^5 pairs of 10^3", 448, 1'000), 3, 50, 300);
  measure(wavy_set("10^3 pairs of 10^4", 46, 10'000), repeat, 50, 30);
  measure(iterates("iterates", 10, quick ? 100'000 : 1'000'000), repeat, 10, quick ? 2 : 1);
  measure(mixed_set("mixed"), repeat, 20, 0);
  std::printf("\n");
  for (const std::string& note : notes) std::printf("- %s\n", note.c_str());
  std::filesystem::remove_all(root);
  return 0;
}
