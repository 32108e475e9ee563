// Damage from outside to the store, the inputs and the memory of a batch.

#include <signal.h>
#include <sys/stat.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <future>
#include <sstream>
#include <thread>

#include "lober/curve/files.hpp"
#include "lober/curve/formats.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/programs.hpp"

namespace lober::cli {
namespace {

class BatchStore : public ProgramTest {
 protected:
  void write_curves(int count, std::size_t points) const {
    for (int k = 0; k < count; ++k) {
      write_curve("separ." + std::to_string(k), flower(points, 20 + k, 0.3, {0.001 * k, 0.002 * k}));
    }
    write("job.toml", "operation = \"overlay\"\ncurves = \"separ.*\"\noptions = { lobes = true }\n");
  }
  // Runs a line of the shell in the folder, in which $LOBER is the program.
  [[nodiscard]] Outcome shell(const std::string& line) const {
    write("line.sh", "LOBER='" + std::string(LOBER_PROGRAM) + "'\n" + line + "\n");
    const std::string command = "cd '" + folder().string() + "' && sh line.sh > out 2> err < /dev/null";
    const int status = std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe): one thread
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out"), read("err")};
  }
  [[nodiscard]] std::size_t partial_files() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder())) {
      if (entry.path().string().find(".part") != std::string::npos) ++count;
    }
    return count;
  }
};

TEST_F(BatchStore, StoresThatAreNotThere) {
  write_curves(2, 40);
  ASSERT_EQ(run({"batch", "run", "job.toml"}).status, 0);
  const std::string none = "nope: No such file or directory; a store is written by lober batch run";
  const std::string folder = "no/x: needs the folder no, which does not exist; make it first";
  for (const auto& [arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"status", "nope"}, none},
           {{"export", "nope"}, none},
           {{"merge", "x", "nope"}, none},
           {{"merge", "no/x", "job.results"}, folder},
           {{"run", "job.toml", "--store", "no/x"}, folder}}) {
    std::vector<std::string> line{"batch"};
    line.insert(line.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.status, 1) << arguments[0];
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(exists("x"));
  EXPECT_FALSE(exists("nope"));
}

TEST_F(BatchStore, DeletedWhileTheBatchRuns) {
  write_curves(40, 3000);
  Outcome outcome;
  // It may vanish so early that there is nothing to rescue: then once more.
  for (int attempt = 0; attempt < 20; ++attempt) {
    for (const char* const file : {"s", "s-wal", "s-shm"}) std::filesystem::remove(folder() / file);
    auto running = std::async(std::launch::async, [&] { return run({"batch", "run", "job.toml", "--store", "s"}); });
    while (!exists("s-wal") && running.wait_for(std::chrono::milliseconds(5)) != std::future_status::ready) {
    }
    std::filesystem::remove(folder() / "s");
    outcome = running.get();
    if (outcome.err.find("vanished while it was opened") == std::string::npos) break;
    EXPECT_EQ(outcome.status, 1) << outcome.err;
  }
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("s.rescued"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out.find("results in"), std::string::npos) << outcome.out;
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "s.rescued"}).status, 0);
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "whole"}).status, 0);
  EXPECT_EQ(run({"batch", "export", "s.rescued"}).out, run({"batch", "export", "whole"}).out);
}

// The numbers of a NetCDF or an HDF5 file are those of the CSV; it is read as a file of curves, two of its columns at a
// time.
TEST_F(BatchStore, ExportsNetCdfAndHdf5) {
  write_curves(6, 40);
  write("separ.5", "0 0\n1 1\n1 0\n0 1\n");  // not simple: its jobs fail
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "s", "-q"}).status, 1);
  std::vector<std::string> tables{"t.nc", "t.h5"};
  for (const FormatInfo& format : formats()) {
    if (format.format == Format::hdf5 && !format.missing.empty()) tables.pop_back();
  }
  for (const std::string& table : tables) {
    ASSERT_EQ(run({"batch", "export", "s", "-o", table}).status, 0);
    ASSERT_EQ(run({"batch", "export", "s", "-o", "again." + table}).status, 0);
    EXPECT_EQ(read(table), read("again." + table));
  }
  std::istringstream csv(run({"batch", "export", "s", "--format", "csv"}).out);
  const auto cells = [](const std::string& line) {
    std::vector<std::string> all(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      c == ',' && !quoted ? all.emplace_back() : all.back() += c;
    }
    return all;
  };
  std::string line;
  std::getline(csv, line);
  const std::vector<std::string> names = cells(line);
  std::vector<std::vector<std::string>> rows;
  while (std::getline(csv, line)) rows.push_back(cells(line));
  ASSERT_EQ(rows.size(), 15U);
  const auto c1 = static_cast<std::size_t>(std::find(names.begin(), names.end(), "c1") - names.begin());
  for (const char* column : {"c2", "intersection", "rounding_union", "crossings"}) {
    const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin());
    ASSERT_LT(at, names.size()) << column;
    for (const std::string& table : tables) {
      const CurveFile file = read_curve_file(folder() / table, {.columns = std::string("c1,") + column});
      std::size_t k = 0;
      for (const Zone& zone : file.zones) {  // parted where jobs have failed
        for (const Point& point : zone.points) {
          while (rows[k][at].empty()) ++k;
          EXPECT_EQ(point.x, std::stod(rows[k][c1]));
          EXPECT_EQ(point.y, std::stod(rows[k][at])) << column << ' ' << table;
          ++k;
        }
      }
    }
    EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [&](const auto& row) { return row[at].empty(); }), 5) << column;
  }
}

TEST_F(BatchStore, NamesAndOptionsThatAreEmptyOrKeepNothing) {
  write_curves(2, 20);
  for (const std::vector<std::string>& extra : std::vector<std::vector<std::string>>{
           {"--store", ":memory:"}, {"--store", ""}, {"--shard", ""}, {"--memory", ""}, {"--json", ""}}) {
    std::vector<std::string> arguments{"batch", "run", "job.toml"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << extra[0] << outcome.err;
  }
  EXPECT_FALSE(exists("job.results"));
  write("byte", "x");
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "byte"}).status, 1);
  EXPECT_EQ(read("byte"), "x");
}

TEST_F(BatchStore, ADamagedValueIsNamed) {
  write_curves(3, 200);
  ASSERT_EQ(run({"batch", "run", "job.toml", "--store", "s"}).status, 0);
  const std::string rows = run({"batch", "export", "s"}).out;
  const nlohmann::json first = nlohmann::json::parse(
      [lines = run({"batch", "export", "s", "--format", "jsonl"}).out] { return lines.substr(0, lines.find('\n')); }());
  const auto value = first["union"].get<double>();
  std::string bytes = read("s"), stored(reinterpret_cast<const char*>(&value), sizeof(value));
  std::reverse(stored.begin(), stored.end());  // as SQLite has it
  const std::size_t at = bytes.find(stored);
  ASSERT_NE(at, std::string::npos);
  bytes[at + 7] ^= 1;
  write("s", bytes);
  const Outcome status = run({"batch", "status", "s"}), table = run({"batch", "export", "s"});
  EXPECT_EQ(status.status, 0);
  EXPECT_NE(status.out.find("2 done, 0 failed, 1 to do"), std::string::npos) << status.out;
  for (const Outcome& any : {status, table}) {
    EXPECT_NE(any.err.find("s: the result of job "), std::string::npos) << any.err;
    EXPECT_NE(any.err.find("is damaged and counts as missing"), std::string::npos) << any.err;
  }
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "s"}).status, 0);
  EXPECT_EQ(run({"batch", "export", "s"}).out, rows);
}

// A limit on the size of files ends a program that does not care about the signal.
TEST_F(BatchStore, OutputsThatMayNotGrowAreErrorsAndLeaveNothing) {
  write_curves(6, 400);
  ASSERT_EQ(run({"batch", "run", "job.toml", "--store", "s"}).status, 0);
  for (const char* const command :
       {"overlay separ.0 separ.1 --json big.json", "overlay separ.0 separ.1 --lobes big.dat",
        "overlay separ.0 separ.1 --svg big.svg", "densify separ.0 --max-length 1e-3 -o big.npy",
        "densify separ.0 --max-length 1e-3 -o big.dat", "batch export s -o big.csv", "batch export s -o big.jsonl",
        "grow henon --unstable --iterates 5 --tolerance 1e-4 -o big.dat", "interior separ.0 separ.1 --json big.json"}) {
    const Outcome outcome = shell(std::string("ulimit -f 1; exec \"$LOBER\" ") + command);
    EXPECT_EQ(outcome.status, 1) << command << ": " << outcome.err;
    // For a store SQLite says it in its own words: its index in shared memory is a file too.
    const bool of_store = std::string_view(command).starts_with("batch");
    EXPECT_NE(outcome.err.find(of_store ? "disk I/O error" : "File too large"), std::string::npos)
        << command << ": " << outcome.err;
    EXPECT_EQ(partial_files(), 0U) << command;
    for (const char* const end : {"json", "npy", "svg", "dat", "csv", "jsonl"}) {
      EXPECT_FALSE(exists(std::string("big.") + end)) << command;
    }
  }
  const Outcome batch = shell("ulimit -f 40; exec \"$LOBER\" batch run job.toml --store small");
  EXPECT_EQ(batch.status, 1) << batch.err;
  EXPECT_NE(batch.err.find("small"), std::string::npos) << batch.err;
}

TEST_F(BatchStore, DevicesAndPipesAreNoCurves) {
  write_curves(2, 50);
  for (const char* const command :
       {"overlay /dev/zero separ.0", "interior separ.0 /dev/urandom", "tangle /dev/zero separ.0",
        "densify /dev/zero --max-length 1 -o fine.npy", "/dev/zero separ.0 rslt"}) {
    const Outcome outcome = shell(std::string("ulimit -v 4000000; exec timeout 60 \"$LOBER\" ") + command);
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_NE(outcome.err.find("is a device"), std::string::npos) << command << ": " << outcome.err;
  }
  const Outcome pipe = shell("mkfifo p; cat separ.0 > p & exec timeout 60 \"$LOBER\" overlay p separ.1");
  EXPECT_EQ(pipe.status, 0) << pipe.err;  // what has an end may come through a pipe
  const Outcome input = shell("exec \"$LOBER\" overlay -:2,1 separ.1 < separ.0"),
                file = run({"overlay", "separ.0:2,1", "separ.1"});
  EXPECT_EQ(input.status, 0) << input.err;
  EXPECT_EQ(file.status, 0) << file.err;
  write("job.toml",
        "operation = \"overlay\"\npairs = [[\"separ.0\", \"separ.1\"], [\"separ.0\", \"p\"], [\"/dev/zero\", "
        "\"separ.0\"]]\n");
  const Outcome batch = shell("exec timeout 60 \"$LOBER\" batch run job.toml --store s");
  EXPECT_EQ(batch.status, 1) << batch.err;
  EXPECT_NE(run({"batch", "status", "s"}).out.find("1 done, 2 failed, 0 to do"), std::string::npos);
}

// Files under /proc say that they have no bytes and give gigabytes.
TEST_F(BatchStore, FilesWhoseSizeIsNotKnownAreNoCurves) {
  write("empty", "");
  write("job.toml",
        "operation = \"densify\"\ncurves = [\"/proc/self/[a-df-z]*\", \"empty\"]\noptions.max_length = 1\n");
  const Outcome batch =
      shell("ulimit -d 300000; exec timeout 60 \"$LOBER\" batch run job.toml --store s --memory 100M");
  EXPECT_EQ(batch.status, 1) << batch.err;
  const std::string table = run({"batch", "export", "s"}).out;
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  std::size_t count = 0;
  for (; std::getline(lines, line); ++count) {
    if (line.find(": Permission denied") != std::string::npos) continue;
    EXPECT_NE(line.find("is empty, or has a size that is not known before it is read"), std::string::npos) << line;
  }
  EXPECT_GT(count, 10U);
}

TEST_F(BatchStore, InputsOfFinishedJobsAreHashedInPieces) {
  const std::vector<Point> points = flower(4'000'000, 7, 0.3, {0, 0});
  write("big", std::string_view(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point)));
  write("job.toml", "operation = \"densify\"\ncurves = \"big\"\noptions.max_length = 1\n");
  ASSERT_EQ(run({"batch", "run", "job.toml", "--store", "s"}).status, 0);
  const Outcome again = shell("ulimit -d 55000; exec \"$LOBER\" batch run job.toml --store s --threads 1");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("1 done before, 0 run"), std::string::npos) << again.out;
}

// Whatever there is not enough memory for, the other jobs are done.
TEST_F(BatchStore, MemoryThatRunsOutFailsOneJobOnly) {
  write_curves(4, 100);
  {  // two curves of a million points; their indexes come after them
    const std::vector<Point> one = flower(1'000'000, 7, 0.3, {0, 0}), two = flower(1'000'000, 5, 0.2, {0.1, 0});
    for (const auto& [name, points] : {std::pair{"big.1", &one}, std::pair{"big.2", &two}}) {
      write(name, std::string_view(reinterpret_cast<const char*>(points->data()), points->size() * sizeof(Point)));
    }
  }
  write("job.toml",
        "[[group]]\noperation = \"overlay\"\ncurves = \"separ.*\"\n"
        "[[group]]\noperation = \"overlay\"\ncurves = \"big.*\"\n");
  int starved = 0;
  for (int megabytes = 40; megabytes <= 400; megabytes += 8) {
    const Outcome outcome = shell("ulimit -v " + std::to_string(megabytes * 1000) +
                                  "; rm -f t t-*; exec timeout 60 \"$LOBER\" batch run job.toml --store t --threads 1");
    if (outcome.status == 0) break;
    if (!exists("t")) continue;  // not even enough for the program itself
    ASSERT_EQ(outcome.status, 1) << megabytes << ": " << outcome.err;
    if (outcome.err.find("failed, see") == std::string::npos) continue;
    EXPECT_NE(run({"batch", "status", "t"}).out.find("6 done, 1 failed, 0 to do"), std::string::npos)
        << megabytes << ": " << run({"batch", "status", "t"}).out;
    ++starved;
  }
  EXPECT_GT(starved, 0);
}

TEST_F(BatchStore, InputsThatAreTruncatedWhileTheyAreRead) {
  write_curves(3, 100);
  const std::vector<Point> points = flower(300'000, 7, 0.3, {0, 0});
  const std::string_view bytes(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point));
  write("separ.9", bytes);
  std::atomic<bool> end{false};
  std::thread truncating([&] {
    const std::string name = (folder() / "separ.9").string();
    while (!end) {
      if (truncate(name.c_str(), 4096) != 0 || truncate(name.c_str(), static_cast<off_t>(bytes.size())) != 0) return;
    }
  });
  for (int round = 0; round < 5; ++round) {
    const std::string store = "s" + std::to_string(round);
    const Outcome outcome = run({"batch", "run", "job.toml", "--store", store});
    // It may be whole at that moment; it must not end the program, nor the jobs of the other files.
    EXPECT_TRUE(outcome.status == 1 || outcome.status == 0) << outcome.status << ": " << outcome.err;
    const std::string status = run({"batch", "status", store}).out;
    EXPECT_TRUE(status.starts_with("3 done, 3 failed") || status.starts_with("6 done")) << status;
  }
  end = true;
  truncating.join();
}

TEST_F(BatchStore, CheckWarnsOfWhatThereIsNoMemoryFor) {
  write_curves(1, 100);
  const auto warnings = [&](const std::string& manifest) {
    write("job.toml", manifest);
    const Outcome outcome = run({"batch", "check", "job.toml", "--memory", "200M"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  const auto image = [&](const std::string& parameters, int iterates) {
    return warnings(
        "operation = \"densify\"\noptions = { max_length = 1 }\ncurves = { system = \"standard\", parameters = " +
        parameters + ", image_of = \"separ.0\", tolerance = 1e-5, iterates = " + std::to_string(iterates) + " }\n");
  };
  const auto finer = [&](const std::string& length) {
    return warnings("operation = \"densify\"\ncurves = \"separ.0\"\noptions = { max_length = " + length + " }\n");
  };
  EXPECT_NE(image("{ K = 1e308 }", 3).find("no room in 200 MiB"), std::string::npos);
  EXPECT_NE(image("{ K = 1.2 }", 59).find("no room in 200 MiB"), std::string::npos);
  EXPECT_EQ(image("{ K = 1.2 }", 2), "");
  EXPECT_NE(finer("1e-300").find("too many points of separ.0"), std::string::npos);
  EXPECT_EQ(finer("1e-3"), "");
}

}  // namespace
}  // namespace lober::cli
