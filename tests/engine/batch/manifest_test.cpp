#include "engine/batch/manifest/manifest.hpp"

#include <algorithm>
#include <random>

#include "engine/batch/manifest/curve_set.hpp"
#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/work_queue.hpp"
#include "lober/batch.hpp"
#include "lober/curve/files.hpp"
#include "lober/curve/zone_names.hpp"
#include "tests/engine/batch/scratch_folder.hpp"
#include "tests/refusal.hpp"

namespace lober::detail {
namespace {

class ManifestTest : public ScratchFolder {
 protected:
  ManifestTest() {
    for (const char* const name : {"separ.0", "separ.1", "separ.2", "separ.10", "other.a", "other.b"}) {
      write(name, "0 0\n1 0\n0 1\n");
    }
    write_tecplot(path("zones.dat"), std::vector<Zone>{{"one", wavy(9, 0), 1}, {"two", wavy(9, 1), 1}});
  }
  Plan plan(const std::string& text) {
    write("job.toml", text);
    return make_plan(read_manifest(path("job.toml")));
  }
  // "first second" of each job.
  std::vector<std::string> pairs(const std::string& text) {
    const Plan all = plan(text);
    std::vector<std::string> names;
    for (const Job& job : all.jobs) {
      names.push_back(all.name(job.first) + (job.second == no_curve ? "" : " " + all.name(job.second)));
    }
    return names;
  }
  // The refusal, without the folder.
  std::string refusal(const std::string& text) {
    try {
      (void)plan(text);
    } catch (const UsageError& error) {
      return std::string(error.what()).substr(path("").size());
    }
    return "";
  }
};

using Names = std::vector<std::string>;

TEST_F(ManifestTest, AllPairsInThreeLines) {
  EXPECT_EQ(pairs("operation = \"overlay\"\ncurves = \"separ.*\"\npairs = \"all\"\n"),
            (Names{"separ.0 separ.1", "separ.0 separ.2", "separ.0 separ.10", "separ.1 separ.2", "separ.1 separ.10",
                   "separ.2 separ.10"}));
}

TEST_F(ManifestTest, ColumnsAndCurvesOfATable) {
  write("tracers.csv", "id,lon,lat\na,0,0\nb,5,5\na,1,0\nb,6,5\na,0,1\nb,5,6\n");
  const std::string head = "operation = \"overlay\"\ncurves = ";
  EXPECT_EQ(pairs(head + "\"tracers.csv:lon,lat,by=id#*\""),
            (Names{"tracers.csv:lon,lat,by=id#a tracers.csv:lon,lat,by=id#b"}));
  EXPECT_EQ(pairs(head + "[\"tracer*.csv:2,3,by=1#b\", \"separ.0\"]"), (Names{"tracers.csv:2,3,by=1#b separ.0"}));
  const Plan all = plan(head + "[\"tracers.csv:lon,lat,by=id#*\", \"tracers.csv:lat,lon,by=id#*\"]");
  EXPECT_TRUE(Plan::decoded(all.encoded()).encoded() == all.encoded());
  EXPECT_EQ(Plan::decoded(all.encoded()).curves[2].columns, "lat,lon,by=id");
  // The same file read in two ways is two inputs.
  const std::vector<std::string> lon_lat = digests_of({all.curves[0]}, path("job.toml")),
                                 lat_lon = digests_of({all.curves[2]}, path("job.toml"));
  EXPECT_NE(lon_lat, lat_lon);
  EXPECT_THROW((void)plan(head + "\"tracers.csv:lon,lit,by=id#*\""), DataError);
}

// The order of the file is that of the pairs, and no part of a name: `#0` is the drifter whose id is 0 wherever it
// stands.
TEST_F(ManifestTest, CurvesOfGroupsGoByTheIdThatReadsThemBack) {
  write("ids.csv", "id,x,y\n9,0,0\n9,1,0\n9,1,1\n0,0,0\n0,10,0\n0,10,10\n1,2,2\n1,3,2\n1,3,3\n");
  const std::string head = "operation = \"interior\"\ncurves = ";
  const Plan all = plan(head + "\"ids.csv:x,y,by=id#*\"");
  ASSERT_EQ(all.curves.size(), 3);
  EXPECT_EQ(all.curves[0].name(), "ids.csv:x,y,by=id#9");
  EXPECT_EQ(all.curves[1].name(), "ids.csv:x,y,by=id#0");
  EXPECT_EQ(all.curves[2].name(), "ids.csv:x,y,by=id#1");
  const Plan decoded = Plan::decoded(all.encoded());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(decoded.curves[k].name(), all.curves[k].name());
    EXPECT_EQ(read_curve(path("") + all.curves[k].name(), true).zone, k);
  }
  const Plan chosen = plan(head + "[\"ids.csv:x,y,by=id#0\", \"ids.csv:x,y,by=id#1\"]");
  ASSERT_EQ(chosen.curves.size(), 2);
  EXPECT_EQ(chosen.curves[0].name(), "ids.csv:x,y,by=id#0");
  EXPECT_EQ(chosen.curves[1].name(), "ids.csv:x,y,by=id#1");
  // The content is the same as before names were ids: results of older stores are found.
  EXPECT_TRUE(digests_of({chosen.curves[0]}, path("job.toml")).at(0).ends_with(":x,y,by=id#1"));
  EXPECT_EQ(refusal(head + "\"ids.csv:x,y,by=id#2\""),
            "job.toml:2: curves: ids.csv has no zone titled \"2\"; there are \"9\", \"0\", \"1\"");
}

// Titles that name no curve alone are not names.
TEST_F(ManifestTest, NamesOfZonesReadBack) {
  CurveFile file;
  file.path = "f";
  const auto titles = [&](bool grouped, std::vector<std::string> all) {
    file.titled_by_group = grouped;
    file.zones.clear();
    for (std::string& title : all) file.zones.push_back({std::move(title), {}});
    Names named;
    const ZoneNames names(file);
    for (std::size_t k = 0; k < file.zones.size(); ++k) {
      EXPECT_EQ(names.find(names.name(k)), k);
      named.push_back(names.name(k));
    }
    return named;
  };
  EXPECT_EQ(titles(true, {"7", "9", "0"}), (Names{"7", "9", "0"}));
  EXPECT_EQ(titles(true, {"1.5", "-2"}), (Names{"1.5", "-2"}));
  EXPECT_EQ(titles(true, {"b", "1", "a"}), (Names{"b", "1", "a"}));
  EXPECT_EQ(titles(true, {"b", "0", "a"}), (Names{"b", "1", "a"}));
  EXPECT_EQ(titles(true, {"a", "a", ""}), (Names{"0", "1", "2"}));
  EXPECT_EQ(titles(true, {"7", "7", "1"}), (Names{"0", "1", "2"}));
  EXPECT_EQ(titles(false, {"1", "0", "a"}), (Names{"0", "1", "2"}));
}

TEST_F(ManifestTest, KindsOfPairs) {
  const std::string head = "operation = \"overlay\"\ncurves = \"separ.*\"\n";
  EXPECT_EQ(pairs(head + "pairs = \"consecutive\""), (Names{"separ.0 separ.1", "separ.1 separ.2", "separ.2 separ.10"}));
  EXPECT_EQ(pairs(head + "pairs = { lag = 3 }"), (Names{"separ.0 separ.10"}));
  EXPECT_EQ(pairs("operation = \"overlay\"\ncurves = [\"other.*\", \"separ.1\"]\nwith = \"separ.[01]\"\npairs = "
                  "\"product\""),
            (Names{"other.a separ.0", "other.a separ.1", "other.b separ.0", "other.b separ.1", "separ.1 separ.0"}));
  EXPECT_EQ(pairs("operation = \"overlay\"\ncurves = \"separ.1\"\nwith = \"separ.[02]\""),
            (Names{"separ.1 separ.0", "separ.1 separ.2"}));
  EXPECT_EQ(
      pairs("operation = \"overlay\"\npairs = [[\"separ.2\", \"other.b\"], [\"zones.dat#1\", \"zones.dat#one\"]]"),
      (Names{"separ.2 other.b", "zones.dat#1 zones.dat#0"}));
  EXPECT_EQ(pairs("operation = \"densify\"\ncurves = \"other.?\"\noptions.max_length = 0.1"),
            (Names{"other.a", "other.b"}));
  EXPECT_EQ(pairs("operation = \"overlay\"\ncurves = \"zones.dat#*\""), (Names{"zones.dat#0 zones.dat#1"}));
}

TEST_F(ManifestTest, GroupsOptionsAndGrids) {
  const Plan all = plan(R"(curves = "separ.*"
options = { index = "tree" }
[[group]]
operation = "overlay"
pairs = "consecutive"
[[group]]
name = "fine"
operation = "interior"
pairs = { lag = 3 }
options = { method = "ends", index = "grid" }
grid = { passes = [1, 2], points = [10, 20] }
)");
  ASSERT_EQ(all.groups.size(), 5U);
  EXPECT_EQ(all.groups[0].options.to_string(),
            "areas_only=false discretisation=true index=tree check_simple=true verify=false smooth=false classes=false "
            "lobes=false");
  EXPECT_EQ(all.groups[1].options.to_string(),
            "method=ends passes=1 points=10 index=grid check_simple=true verify=false");
  EXPECT_EQ(all.groups[4].options.to_string(),
            "method=ends passes=2 points=20 index=grid check_simple=true verify=false");
  EXPECT_EQ(all.groups[4].name, "fine");
  EXPECT_EQ(all.jobs.size(), 3U + 4);
}

TEST_F(ManifestTest, RefusalsNameLineAndKey) {
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\npair = \"all\"").substr(0, 43),
            "job.toml:3: pair: there is no such key; the");
  std::string all;
  for (const OperationInfo& one : list_operations()) all += (all.empty() ? "" : ", ") + one.name;
  EXPECT_TRUE(all.starts_with("overlay, interior, regions, winding, tangle, manifold_tangle, densify, simplify, "));
  EXPECT_EQ(refusal("operation = \"overly\"\ncurves = \"separ.*\""),
            "job.toml:1: operation: there is no operation \"overly\" in this version; there are " + all +
                "; did you mean overlay?");
  EXPECT_EQ(refusal("curves = \"separ.*\""), "job.toml:1: operation: is missing");
  EXPECT_EQ(refusal("operation = \"overlay\""), "job.toml:1: curves: is missing");
  EXPECT_EQ(refusal("operation = \"densify\"\ncurves = \"separ.*\"\nwith = \"other.*\"\noptions.max_length = 1"),
            "job.toml:3: with: goes with pairs = \"product\" only");
  EXPECT_EQ(refusal("operation = \"overlay\"\n\ncurves = \"sepra.*\""), "job.toml:3: curves: there is no file sepra.*");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\npairs = \"al\"").substr(0, 72),
            "job.toml:3: pairs: \"al\" cannot be read as pairs; give all, consecutive, ");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\n[options]\nindex = \"gird\""),
            "job.toml:4: options.index: \"gird\" cannot be read as one of auto, tree, grid, kd; did you mean grid?");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurvs = \"separ.*\""),
            "job.toml:2: curvs: there is no such key; there are name, operation, curves, with, closed, periodic, "
            "pairs, options, "
            "grid and [[group]]; did you mean curves?");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\npairs = \"consecutiv\""),
            "job.toml:3: pairs: \"consecutiv\" cannot be read as pairs; give all, consecutive, product, single, "
            "{ lag = k } or a list of pairs; did you mean consecutive?");
  EXPECT_EQ(
      refusal("operation = \"overlay\"\ncurves = { system = \"henon\", manifld = \"stable\" }"),
      "job.toml:2: curves: a curve of a system has no manifld; it has system, parameters, manifold, from, branch, "
      "length, image_of, iterates, tolerance, integration_tolerance; did you mean manifold?");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\noptions.smoth = true"),
            "job.toml:3: options.smoth: there is no such option; there are areas_only, discretisation, index, "
            "check_simple, verify, classes, lobes; smooth is refused: batches keep no numbers of it; lober overlay "
            "shows them");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\noptions.verfy = true"),
            "job.toml:3: options.verfy: there is no such option; there are areas_only, discretisation, index, "
            "check_simple, verify, classes, lobes; did you mean verify?");
  // Jobs do not compute what no column keeps.
  EXPECT_NE(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\noptions.smooth = true")
                .find("smooth: batches keep no numbers of it; lober overlay shows them"),
            std::string::npos);
  EXPECT_NE(refusal("operation = \"transport\"\noptions = { system = \"ovp\", all_regions = true }")
                .find("all_regions: batches keep no numbers of it"),
            std::string::npos);
  for (const OperationInfo& one : list_operations()) {
    for (const OperationOption& option : one.options) {
      if (one.name == "overlay") {
        EXPECT_NE(option.key, "smooth");
      }
      if (one.name == "transport") {
        EXPECT_FALSE(option.key == "melnikov" || option.key == "all_regions") << option.key;
      }
    }
  }
  EXPECT_NE(refusal("operation = \"densify\"\ncurves = \"separ.*\"").find("no step is given; give \"simplify\""),
            std::string::npos);
  EXPECT_EQ(refusal("operation = \"interior\"\ncurves = \"separ.*\"\n[grid]\npasses = [1,\n  -1]"),
            "job.toml:5: options.passes: has to be at least 0");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.0\""),
            "job.toml:2: curves: this gives no pair of curves");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = [\"separ.0\", \"separ.0\"]"),
            "job.toml:2: curves: this gives no pair of curves: separ.0 is given twice, and counts once");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = [\"separ.0\", \"separ.1\"]\npairs = { lag = 99 }"),
            "job.toml:2: curves: this gives no pair of curves: there are 2, and lag = 99 has to be less than that");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.0\"\nwith = \"separ.0\"\npairs = \"product\""),
            "job.toml:2: curves: this gives no pair of curves: with has no other curve than separ.0");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"zones.dat#three\""),
            "job.toml:2: curves: zones.dat has no zone titled \"three\"; there are \"one\", \"two\"");
  EXPECT_EQ(refusal("operation = \"overlay\"\nsystem = \"standard\"").substr(0, 18), "job.toml:2: system");
  EXPECT_EQ(refusal("operation = \"tangle\"\ncurves = \"separ.*\"\nclosed = true"),
            "job.toml:3: closed: tangle takes open curves");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = = 3").substr(0, 11), "job.toml:2:");
  const std::string image = "operation = \"image\"\noptions = { system = \"standard\"";
  EXPECT_EQ(refusal(image + " }"),
            "job.toml:1: options: the curve is missing; \"circle\", \"rectangle\" or \"boundary\" takes its place");
  EXPECT_EQ(refusal(image + ", circle = [0, 0, -1] }"), "job.toml:1: options: \"circle\" X,Y,R: R has to be above 0");
  EXPECT_NE(refusal(image + ", circle = [0, 0, 1], boundary = true }").find("cannot be given together"),
            std::string::npos);
  EXPECT_NE(refusal(image + ", boundary = true, closed = false }").find("\"closed\" is for a curve"),
            std::string::npos);
  EXPECT_EQ(refusal("operation = \"densify\"\ncurves = \"separ.*\"\noptions = { max_length = 1, output = \"a.csv\" }"),
            "job.toml:1: options.output: a.csv ends in .csv, but the curve is written in NPY");
  EXPECT_EQ(refusal("operation = \"overlay\"\ncurves = \"separ.*\"\npairs = \"single\""),
            "job.toml:3: pairs: overlay takes two curves");
}

TEST_F(ManifestTest, ShardsAreAPartition) {
  const Plan all = plan(R"(curves = "separ.*"
[[group]]
operation = "overlay"
[[group]]
operation = "interior"
)");
  std::vector<int> seen(all.jobs.size());
  for (std::size_t k = 0; k < 5; ++k) {
    for (const std::uint32_t job : jobs_of(all, {k, 5})) ++seen[job];
  }
  EXPECT_EQ(seen, std::vector<int>(all.jobs.size(), 1));
}

TEST_F(ManifestTest, GridsTakeRanges) {
  const std::string head = "operation = \"densify\"\ncurves = \"separ.1\"\n";
  const Plan all = plan(head + "grid = { max_length = \"0.5:1.5:0.005\", passes = \"3:1:-2\" }");
  ASSERT_EQ(all.groups.size(), 201U * 2);
  EXPECT_EQ(all.groups.front().options.real("max_length"), 0.5);
  EXPECT_EQ(all.groups[2].options.real("max_length"), 0.505);
  EXPECT_EQ(all.groups.back().options.real("max_length"), 1.5);
  EXPECT_EQ(all.groups[0].options.whole("passes"), 3);
  EXPECT_EQ(all.groups[1].options.whole("passes"), 1);
  const auto refused = [&](const std::string& range) {
    return refusal(head + "grid = { max_length = " + range + " }");
  };
  for (const char* const bad : {"\"\"", "\"1:2\"", "\"1:2:3:4\"", "\"a:b:c\"", "\"1:2:inf\"", "\"1:2:1x\"", "3"}) {
    EXPECT_EQ(refused(bad), "job.toml:3: grid.max_length: has to be a list of values, or a range \"FIRST:LAST:STEP\"")
        << bad;
  }
  for (const char* const bad : {"\"1:2:0\"", "\"1:2:-1\"", "\"0:1:1e-9\""}) {
    EXPECT_NE(refused(bad).find("needs a step that leads from the first value to the last"), std::string::npos) << bad;
  }
  EXPECT_NE(refused("\"0.5:1.5:200\"").find("the third number is the step"), std::string::npos);
  EXPECT_NE(refused("\"-1:2:1\"").find("has to be above 0"), std::string::npos);
}

TEST_F(ManifestTest, ShardsThatDoNotExistAreRefused) {
  const Plan all = plan("operation = \"interior\"\ncurves = \"separ.*\"\n");
  for (const Shard none : {Shard{0, 0}, Shard{1, 1}, Shard{7, 5}, Shard{0, std::size_t{1} << 40}}) {
    EXPECT_NE(test::refusal<UsageError>([&] { (void)jobs_of(all, none); }).find("does not exist; count shards from 0"),
              std::string::npos);
    BatchOptions options;
    options.store = path("s");
    options.shard = none;
    EXPECT_THROW((void)run_batch(path("job.toml"), options), UsageError);
    EXPECT_FALSE(std::filesystem::exists(path("s")));
  }
}

TEST_F(ManifestTest, WorkQueueHandsOutEachJobOnceInShrinkingPortions) {
  const Plan all = plan("operation = \"densify\"\ncurves = \"separ.*\"\n[grid]\nmax_length = [" + [] {
    std::string lengths = "1";
    for (int k = 2; k < 1000; ++k) lengths += "," + std::to_string(k);
    return lengths;
  }() + "]");
  std::vector<std::uint32_t> numbers = jobs_of(all, {});
  WorkQueue queue(all, path("job.toml"), numbers);
  std::vector<std::uint32_t> dealt;
  std::size_t before = numbers.size();
  for (std::vector<std::uint32_t> portion = queue.next_portion(3); !portion.empty(); portion = queue.next_portion(3)) {
    EXPECT_LE(portion.size(), before);
    before = portion.size();
    dealt.insert(dealt.end(), portion.begin(), portion.end());
  }
  std::sort(dealt.begin(), dealt.end());
  EXPECT_EQ(dealt, numbers);
  EXPECT_LT(before, numbers.size() / 10);
}

TEST_F(ManifestTest, PlanComesBackFromItsBytes) {
  const Plan all = plan("operation = \"overlay\"\ncurves = [\"separ.*\", \"zones.dat#*\"]");
  const std::string bytes = all.encoded();
  EXPECT_EQ(Plan::decoded(bytes).encoded(), bytes);
  EXPECT_THROW((void)Plan::decoded(bytes.substr(0, bytes.size() / 2)), DataError);
}

TEST(NaturalOrder, RunsOfDigitsAreNumbers) {
  EXPECT_TRUE(natural_less("a2", "a10"));
  EXPECT_FALSE(natural_less("a10", "a2"));
  EXPECT_TRUE(natural_less("a9.x", "a10.b"));
  EXPECT_TRUE(natural_less("a", "b"));
  EXPECT_TRUE(natural_less("a", "a1"));
  EXPECT_FALSE(natural_less("a1", "a1"));
}

// As printf writes them: %d, %02d and so on, also where a number is too long for the width.
TEST(NaturalOrder, NumbersOfAnyWidthAreInOrder) {
  for (const std::size_t width : {1U, 2U, 3U, 4U}) {
    std::vector<std::string> names;
    for (int number = 0; number <= 1200; ++number) {
      std::string digits = std::to_string(number);
      digits.insert(0, width - std::min(width, digits.size()), '0');
      names.push_back("separ." + digits + ".dat");
    }
    const std::vector<std::string> ordered = names;
    std::shuffle(names.begin(), names.end(), std::mt19937(5));
    std::sort(names.begin(), names.end(), natural_less);
    EXPECT_EQ(names, ordered) << "width " << width;
  }
}

TEST(NaturalOrder, LeadingZerosComeFirstAndCountAsDecimalPlaces) {
  const std::vector<std::string> ordered{"a", "a000", "a00", "a01", "a010", "a09", "a0", "a1", "a9", "a10"};
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    for (std::size_t k = 0; k < ordered.size(); ++k) {
      EXPECT_EQ(natural_less(ordered[i], ordered[k]), i < k) << ordered[i] << ' ' << ordered[k];
    }
  }
}

}  // namespace
}  // namespace lober::detail
