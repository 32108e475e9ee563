// The answers of a store to SQL.

#include "engine/base/text.hpp"
#include "engine/batch/batch.hpp"
#include "engine/batch/export/export.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/batch/scratch_folder.hpp"
#include "tests/engine/batch/stored_plan.hpp"

namespace lober::detail {
namespace {

using Rows = std::vector<std::string>;

class StoreViews : public ScratchFolder {
 protected:
  StoreViews() {
    for (int k = 0; k < 4; ++k) write_npy(path("c." + std::to_string(k)), wavy(40, k));
  }
  BatchReport ran(const std::string& manifest, const std::string& store = "s", Shard shard = {}) const {
    write("job.toml", manifest);
    return run_batch(read_manifest(path("job.toml")), {path(store), shard, {.threads = 2}, {}});
  }
  Rows asked(const std::string& sql, const std::string& store = "s") const { return detail::asked(path(store), sql); }
  // "first second" of each row of the view, in the order of the jobs.
  Rows pairs(const std::string& store = "s") const {
    return asked("SELECT curve1, curve2 FROM overlaps ORDER BY job", store);
  }
  // The same of what is exported.
  Rows exported(const std::string& store = "s") const {
    export_results(Store::open(path(store)), path("out.csv"), ExportFormat::csv, "overlay");
    Rows rows;
    std::ifstream lines(path("out.csv"));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::vector<std::string> fields(1);
      for (const char c : line) c == ',' ? void(fields.emplace_back()) : void(fields.back() += c);
      if (fields[6] == "done") rows.push_back(fields[4] + " " + fields[5]);
    }
    return rows;
  }
};

constexpr const char* all_pairs_manifest = "operation = \"overlay\"\ncurves = \"c.*\"\n";

TEST_F(StoreViews, SayWhatTheExportSays) {
  ran(all_pairs_manifest);
  EXPECT_EQ(pairs(), (Rows{"c.0 c.1", "c.0 c.2", "c.0 c.3", "c.1 c.2", "c.1 c.3", "c.2 c.3"}));
  export_results(Store::open(path("s")), path("out.csv"), ExportFormat::csv);
  Rows areas;
  std::ifstream lines(path("out.csv"));
  std::string line;
  std::getline(lines, line);
  const auto field = [&](int number) {
    std::size_t begin = 0;
    for (int k = 0; k < number; ++k) begin = line.find(',', begin) + 1;
    return line.substr(begin, line.find(',', begin) - begin);
  };
  EXPECT_EQ(field(10), "intersection");
  while (std::getline(lines, line)) areas.push_back(field(10));
  Rows found;
  for (const std::string& row :
       asked("SELECT printf('%!.17g', area) FROM overlaps WHERE area = intersection ORDER BY job")) {
    found.push_back(format_number(std::stod(row)));
  }
  EXPECT_EQ(found, areas);
}

TEST_F(StoreViews, ThereIsOneForEachOperation) {
  ran(R"(curves = "c.*"
[[group]]
name = "areas"
operation = "overlay"
[[group]]
operation = "interior"
grid = { method = ["split", "ends"] }
[[group]]
operation = "densify"
options = { max_length = 0.01 }
[[group]]
operation = "tangle"
closed = false
pairs = [["c.0", "c.1"]]
[[group]]
operation = "transport"
options = { system = "henon", iterates = 2, tolerance = 1e-3 }
)");
  EXPECT_EQ(asked("SELECT count(*) FROM overlaps WHERE \"group\" = 'areas'"), Rows{"6"});
  EXPECT_EQ(asked("SELECT count(*) FROM interiors WHERE options LIKE '%method=ends%'"), Rows{"6"});
  EXPECT_EQ(asked("SELECT count(*), count(curve2), min(points_in) FROM densified"), Rows{"4 0 40"});
  const Rows counts = asked(
      "SELECT (SELECT count(*) FROM tangles) + (SELECT count(*) FROM transports) + (SELECT "
      "count(*) FROM failures)");
  EXPECT_EQ(counts, Rows{"2"});
  EXPECT_EQ(asked("SELECT count(*), count(DISTINCT job), count(DISTINCT key) FROM results"), Rows{"24 24 24"});
}

TEST_F(StoreViews, ListsCanBeLookedInto) {
  ran("operation = \"transport\"\noptions = { system = \"henon\", iterates = 3, tolerance = 1e-3 }\n");
  export_results(Store::open(path("s")), path("out.jsonl"), ExportFormat::json_lines, "transport");
  std::ifstream lines(path("out.jsonl"));
  std::string line;
  std::getline(lines, line);
  const std::string key = "\"a21\":[";
  const std::size_t begin = line.find(key) + key.size();
  ASSERT_GT(begin, key.size());
  const double first = std::stod(line.substr(begin));
  EXPECT_GT(first, 0);
  const Rows found = asked("SELECT printf('%!.17g', json_extract(lists, '$.a21[0]')) FROM transports");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(std::stod(found[0]), first);
}

// A grid varies what a table has a column for.
TEST_F(StoreViews, SweptValuesHaveColumns) {
  const auto lines = [&](const char* operation) {
    export_results(Store::open(path("s")), path("out.csv"), ExportFormat::csv, operation);
    Rows all;
    std::ifstream file(path("out.csv"));
    for (std::string line; std::getline(file, line);) all.push_back(line);
    return all;
  };
  ran("operation = \"transport\"\noptions = { system = \"henon\", iterates = 2, tolerance = 1e-3 }\n"
      "grid = { parameters.k = \"1.02:1.04:0.01\" }\n");
  const Rows transports = lines("transport");
  ASSERT_EQ(transports.size(), 4U);
  EXPECT_TRUE(transports[0].starts_with("job,group,operation,options,first,second,status,message,parameters.k,region,"))
      << transports[0];
  EXPECT_NE(transports[2].find(",,,done,,1.03,"), std::string::npos) << transports[2];
  EXPECT_EQ(asked("SELECT json_extract(settings, '$.parameters.k') AS k FROM transports ORDER BY k"),
            (Rows{"1.02", "1.03", "1.04"}));

  ran("operation = \"densify\"\ncurves = \"c.*\"\noptions = { points = 3, simplify = 0 }\n"
      "grid = { points = \"2:3:1\", interpolation = [\"linear\", \"spline\"], hobson = [true, false] }\n");
  const Rows densified = lines("densify");
  ASSERT_EQ(densified.size(), 1U + 4 * 8);
  EXPECT_NE(densified[0].find(",message,hobson,interpolation,options.points,signed_area,"), std::string::npos)
      << densified[0];
  EXPECT_NE(densified[5 * 4 + 1].find(",done,,"), std::string::npos) << densified[21];
  EXPECT_NE(
      densified[1].find(",failed,densify: points on the chords turn no corner; give the angle with an interpolation "
                        "other than linear,true,linear,2,"),
      std::string::npos)
      << densified[1];
  export_results(Store::open(path("s")), path("out.npy"), ExportFormat::npy);
  std::ifstream file(path("out.npy"), std::ios::binary);
  std::string head(600, '\0');
  file.read(head.data(), 600);
  EXPECT_NE(head.find("('hobson', '|b1'), ('interpolation', '|S6'), ('options.points', '<i8'), ('signed_area', '<f8')"),
            std::string::npos)
      << head;
}

TEST_F(StoreViews, FailuresAreNotAmongTheValues) {
  write("c.4", "0 0\n1 1\n1 0\n0 1\n");
  ran(all_pairs_manifest);
  EXPECT_EQ(asked("SELECT count(*) FROM overlaps"), Rows{"6"});
  EXPECT_EQ(asked("SELECT curve1, curve2 FROM failures ORDER BY job"),
            (Rows{"c.0 c.4", "c.1 c.4", "c.2 c.4", "c.3 c.4"}));
  EXPECT_EQ(asked("SELECT status, count(*) FROM results GROUP BY status"), (Rows{"done 6", "failed 4"}));
}

// Two files with the same contents have one result, and both pairs are in the view.
TEST_F(StoreViews, InputsWithTheSameContents) {
  write_npy(path("c.1"), wavy(40, 0));
  ran(all_pairs_manifest);
  EXPECT_EQ(pairs(), exported());
  EXPECT_EQ(pairs().size(), 6U);
  EXPECT_EQ(asked("SELECT count(*) FROM results_overlay"), Rows{"4"});
  ran(all_pairs_manifest);
  EXPECT_EQ(pairs(), exported());
  EXPECT_EQ(pairs().size(), 6U);
  for (std::size_t k = 0; k < 2; ++k) ran(all_pairs_manifest, "part" + std::to_string(k), {k, 2});
  Store joined = Store::create(path("joined"));
  std::vector<Store> parts;
  for (const char* const part : {"part0", "part1"}) parts.push_back(Store::open(path(part)));
  joined.merge(parts);
  EXPECT_EQ(pairs("joined"), pairs());
}

// Views follow the newest plan and the inputs as they are.
TEST_F(StoreViews, ResultsThatNoLongerHoldAreNotInThem) {
  ran(all_pairs_manifest);
  write_npy(path("c.2"), wavy(50, 9));
  EXPECT_EQ(ran(all_pairs_manifest).queue.jobs, 3U);
  EXPECT_EQ(pairs(), exported());
  EXPECT_EQ(pairs().size(), 6U);
  EXPECT_EQ(asked("SELECT count(*) FROM results_overlay"), Rows{"9"});
  std::filesystem::rename(path("c.0"), path("c.7"));
  EXPECT_EQ(ran(all_pairs_manifest).queue.jobs, 3U);  // in another order
  EXPECT_EQ(pairs(), (Rows{"c.1 c.2", "c.1 c.3", "c.1 c.7", "c.2 c.3", "c.2 c.7", "c.3 c.7"}));
  ran("operation = \"overlay\"\npairs = [[\"c.3\", \"c.7\"]]\n");
  EXPECT_EQ(pairs(), Rows{"c.3 c.7"});
  ran(all_pairs_manifest);
  EXPECT_EQ(pairs().size(), 6U);
  EXPECT_EQ(asked("SELECT count(*) FROM results_overlay"), Rows{"12"});
}

TEST_F(StoreViews, ShardsThatFollowEachOtherInOneStore) {
  ran(all_pairs_manifest, "s", {0, 2});
  EXPECT_EQ(pairs().size(), 3U);
  ran(all_pairs_manifest, "s", {1, 2});
  EXPECT_EQ(pairs(), exported());
  EXPECT_EQ(pairs().size(), 6U);
}

}  // namespace
}  // namespace lober::detail
