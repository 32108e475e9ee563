// `lober batch` as a user runs it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <regex>

#include "lober/operations.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

constexpr const char* all_pairs = "operation = \"overlay\"\ncurves = \"separ.*\"\npairs = \"all\"\n";

class Batch : public ProgramTest {
 protected:
  void write_curves(int count, std::size_t points = 60) const {
    for (int k = 0; k < count; ++k) {
      write_curve("separ." + std::to_string(k), flower(points, 3 + k % 4, 0.3, {0.02 * k, 0.01 * k}));
    }
    write("job.toml", all_pairs);
  }
  // Runs the manifest and returns its report.
  nlohmann::json report(std::vector<std::string> arguments, int status = 0) const {
    arguments.insert(arguments.begin(), {"batch", "run"});
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
  std::string exported(const std::string& store, const std::string& format = "csv") const {
    const Outcome outcome = run({"batch", "export", store, "--format", format});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }
};

TEST_F(Batch, AllPairsInThreeLines) {
  write_curves(5);
  const nlohmann::json done = report({"job.toml"});
  EXPECT_EQ(done["run"], 10);
  EXPECT_EQ(done["failed"], 0);
  EXPECT_EQ(done["max_reads_of_a_file"], 1);
  EXPECT_EQ(done["curves_indexed"], 5);
  const std::string table = exported("job.results");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 11);

  // The same numbers as from the single command.
  const std::string lines = exported("job.results", "jsonl");
  const nlohmann::json first = nlohmann::json::parse(lines.substr(0, lines.find('\n')));
  const nlohmann::json single = overlay({"separ.0", "separ.1"});
  EXPECT_EQ(first["c1_minus_c2"], single["areas"]["c1_minus_c2"]);
  EXPECT_EQ(first["rounding_union"], single["error"]["rounding"]["union"]);
  EXPECT_EQ(first["discretisation_intersection"], single["error"]["discretisation"]["intersection"]);
  EXPECT_EQ(first["pieces_c1_minus_c2"], single["pieces"]["c1_minus_c2"].size());
}

// One box in longitudes from -180 to 180, one in those from 0 to 360, and one across the date line: each face says it.
TEST_F(Batch, LongitudesOfDifferentRangesAreWarnedOf) {
  const auto box = [&](const std::string& name, double west, double east) {
    const std::string w = std::to_string(west), e = std::to_string(east);
    write(name, "lon,lat\n" + w + ",10\n" + e + ",10\n" + e + ",14\n" + w + ",14\n");
  };
  box("west", -170, -166);
  box("east", 191, 195);
  box("line", 178, -178);
  const std::string manifest = "operation = \"overlay\"\ncurves = [\"west\", \"east\", \"line\"]\npairs = \"all\"\n";
  write("job.toml", manifest);
  const nlohmann::json warned = report({"job.toml"});
  ASSERT_EQ(warned["warnings"].size(), 2) << warned["warnings"];
  const std::string line = warned["warnings"][0], pair = warned["warnings"][1];
  EXPECT_NE(line.find("line: its segment 0 runs back across the whole map"), std::string::npos) << line;
  EXPECT_NE(pair.find("longitudes of west are from -170 to -166, those of east from 191 to 195"), std::string::npos)
      << pair;
  for (const std::string& one : {line, pair}) EXPECT_NE(one.find("periodic = \"x=360\""), std::string::npos) << one;
  const Outcome single = run({"overlay", "west", "east"});
  EXPECT_NE(single.err.find("give --periodic x=360"), std::string::npos) << single.err;

  write("job.toml", manifest + "periodic = \"x=360\"\n");
  EXPECT_EQ(report({"job.toml"})["warnings"].size(), 0);
  const std::string lines = exported("job.results", "jsonl");
  const nlohmann::json first = nlohmann::json::parse(lines.substr(0, lines.find('\n')));
  EXPECT_EQ(first["intersection"], 12);
  const Outcome mended = run({"overlay", "west", "east", "--periodic", "x=360"});
  EXPECT_EQ(mended.err.find("360"), std::string::npos) << mended.err;
  EXPECT_EQ(overlay({"line", "line", "--periodic", "x=360"})["areas"]["c1"], 16);
}

TEST_F(Batch, CheckListsTheFirstSettingsOfAGrid) {
  write("job.toml",
        "operation = \"escape\"\noptions = { system = \"capsize\" }\ngrid = { energy = \"0.251:0.30:0.001\" }\n");
  const Outcome outcome = run({"batch", "check", "job.toml"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_LT(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 20) << outcome.out;
  EXPECT_NE(outcome.out.find("and 40 more settings"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("the time of escapes is judged by "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("jobs without curves are counted with"), std::string::npos) << outcome.out;
  write("job.toml", "operation = \"transport\"\noptions = { system = \"standard\" }\n");
  const Outcome usual = run({"batch", "check", "job.toml"});
  EXPECT_NE(usual.out.find("jobs without curves are counted with"), std::string::npos) << usual.out;
}

TEST_F(Batch, OperationsAreListedWithTheirOptions) {
  const auto list = nlohmann::json::parse(run({"batch", "operations", "--json", "-"}).out)["operations"];
  ASSERT_EQ(list.size(), operations::all().size());
  const std::string table = run({"batch", "operations"}).out;
  for (const nlohmann::json& operation : list) {
    const std::string name = operation["name"];
    SCOPED_TRACE(name);
    EXPECT_NE(operation["summary"], "");
    EXPECT_FALSE(operation["columns"].empty());
    EXPECT_NE(table.find(name), std::string::npos);
    const std::string details = run({"batch", "operations", name}).out;
    for (const nlohmann::json& option : operation["options"]) {
      EXPECT_NE(option["meaning"], "") << option["key"];
      EXPECT_NE(details.find("  " + option["key"].get<std::string>() + " "), std::string::npos);
    }
  }
  EXPECT_EQ(list[0]["options"][1]["default"], "true");  // overlay: discretisation
  EXPECT_EQ(list[4]["options"][1]["max"], 1e6);         // tangle: period
  const Outcome unknown = run({"batch", "operations", "nosuch"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find(
                "there are overlay, interior, regions, winding, tangle, manifold_tangle, densify, simplify, transport"),
            std::string::npos);
  EXPECT_NE(run({"batch", "manifest"}).out.find("image_of"), std::string::npos);
}

// Curves that were stored modulo a period, as the single command reads them.
TEST_F(Batch, CurvesHavePeriods) {
  std::string seam, right;
  for (int k = 0; k < 60; ++k) {
    const double x = 0.95 + 0.2 * std::cos(k * 0.10472), y = 0.2 * std::sin(k * 0.10472);
    seam += std::to_string(x >= 1 ? x - 1 : x) + " " + std::to_string(y) + "\n";
    right += std::to_string(0.05 + 0.2 * std::cos(k * 0.10472)) + " " + std::to_string(y) + "\n";
  }
  write("seam", seam);
  write("right", right);
  const auto manifest = [](const std::string& periodic) {
    return "operation = \"overlay\"\npairs = [[\"seam\", \"right\"]]\n" + periodic;
  };
  write("job.toml", manifest("periodic = \"x=1\"\n"));
  EXPECT_EQ(report({"job.toml"})["failed"], 0);
  const nlohmann::json found = nlohmann::json::parse(exported("job.results", "jsonl"));
  const nlohmann::json single = overlay({"seam", "right", "--periodic", "x=1"});
  EXPECT_GT(found["intersection"], 0.01);
  EXPECT_EQ(found["intersection"], single["areas"]["intersection"]);
  EXPECT_EQ(report({"job.toml"})["run"], 0);
  // Other periods are other inputs; without them the curve that jumps is not simple.
  write("job.toml", manifest("periodic = [\"x=1\", \"y=2pi\"]\n"));
  EXPECT_EQ(report({"job.toml"})["run"], 1);
  write("job.toml", manifest(""));
  EXPECT_EQ(report({"job.toml"}, 1)["failed"], 1);
  write("job.toml", manifest("periodic = \"x=0\"\n"));
  const Outcome wrong = run({"batch", "run", "job.toml"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("job.toml:3: periodic: has to be \"x=PERIOD\""), std::string::npos) << wrong.err;
}

// Areas that may be incomplete are warned of by each face, with the names of the curves.
TEST_F(Batch, CurvesThatAreWiderThanAPeriodAreWarnedOf) {
  const auto circle = [&](const std::string& name, double x, double radius) {
    std::string text;
    for (int k = 0; k < 60; ++k) {
      const double at = x + radius * std::cos(k * 0.10472);
      text += std::to_string(at - std::floor(at)) + " " + std::to_string(radius * std::sin(k * 0.10472)) + "\n";
    }
    write(name, text);
  };
  circle("big", 0.5, 0.6);
  circle("small", 0.05, 0.2);
  circle("near", 0.5, 0.2);
  circle("wind", 0.4, 0.1);
  const std::string warning =
      "the curves big and small are together wider than the period of x: they could also meet where one of them is "
      "moved by a period, which is not counted";
  write("job.toml",
        "operation = \"overlay\"\npairs = [[\"big\", \"small\"], [\"near\", \"wind\"]]\nperiodic = \"x=1\"\n");
  EXPECT_EQ(report({"job.toml"})["warnings"], nlohmann::json::array({warning}));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"overlay"}, {"overlay", "--rule", "nonzero"}, {"interior"}, {"regions"}}) {
    SCOPED_TRACE(command.front());
    std::vector<std::string> arguments{command.front(), "big", "small", "--periodic", "x=1", "--json", "found.json"};
    arguments.insert(arguments.end(), command.begin() + 1, command.end());
    const Outcome single = run(arguments);
    EXPECT_EQ(single.status, 0) << single.err;
    EXPECT_NE(single.err.find("warning: " + warning + "\n"), std::string::npos) << single.err;
    EXPECT_EQ(nlohmann::json::parse(read("found.json"))["warnings"], nlohmann::json::array({warning}));
  }
  EXPECT_EQ(overlay({"near", "wind", "--periodic", "x=1"}).count("warnings"), 0U);
  const Outcome dense =
      run({"densify", "big", "small", "-o", "d.npy", "--crossings", "--periodic", "x=1", "--json", "dense.json"});
  EXPECT_NE(dense.err.find("warning: " + warning + "\n"), std::string::npos) << dense.err;
  EXPECT_EQ(nlohmann::json::parse(read("dense.json"))["warnings"], nlohmann::json::array({warning}));
}

TEST_F(Batch, ResultsOfAnotherManifestAreSaidToBeHidden) {
  write_curves(4);
  write("other.toml", "operation = \"interior\"\ncurves = \"separ.*\"\npairs = \"consecutive\"\n");
  const nlohmann::json first = report({"job.toml", "--store", "s"});
  EXPECT_EQ(first["hidden"], 0);
  EXPECT_EQ(first["stored_meanwhile"], 0);
  EXPECT_EQ(report({"other.toml", "--store", "s"})["hidden"], 6);
  EXPECT_EQ(report({"other.toml", "--store", "s"})["hidden"], 6);
  const Outcome back = run({"batch", "run", "job.toml", "--store", "s"});
  EXPECT_NE(back.out.find("6 jobs: 6 done before, 0 run, 0 failed"), std::string::npos) << back.out;
  EXPECT_NE(back.out.find("it has 3 results of another manifest or of earlier inputs too: "), std::string::npos)
      << back.out;
  // Shards of one manifest do not hide each other.
  for (const char* const shard : {"1/2", "2/2"}) {
    EXPECT_EQ(report({"job.toml", "--store", "t", "--shard", shard})["hidden"], 0) << shard;
  }
}

// A number behind '#' is that of a group where a column parts curves, as the single command has it.
TEST_F(Batch, GroupsAreChosenByTheirNumbers) {
  write("ids.csv", "id,x,y\n7,0,0\n7,2,0\n7,2,2\n0,5,5\n0,6,5\n0,6,7\n");
  write("job.toml", "operation = \"overlay\"\npairs = [[\"ids.csv:x,y,by=id#7\", \"ids.csv:x,y,by=id#0\"]]\n");
  EXPECT_EQ(report({"job.toml"})["failed"], 0);
  const nlohmann::json found = nlohmann::json::parse(exported("job.results", "jsonl"));
  EXPECT_EQ(found["c1"], 2);
  EXPECT_EQ(found["c2"], 1);
  write("job.toml", "operation = \"overlay\"\npairs = [[\"ids.csv:x,y,by=id#7\", \"ids.csv:x,y,by=id#1\"]]\n");
  EXPECT_EQ(run({"batch", "run", "job.toml"}).status, 2);
}

TEST_F(Batch, FinishedWorkIsSkippedAndEditedInputsAreNot) {
  write_curves(5);
  report({"job.toml"});
  EXPECT_EQ(report({"job.toml"})["run"], 0);
  const std::string before = exported("job.results");
  write_curve("separ.2", flower(61, 5, 0.2, {0, 0}));
  const nlohmann::json again = report({"job.toml"});
  EXPECT_EQ(again["run"], 4);
  EXPECT_EQ(again["finished_before"], 6);
  EXPECT_NE(exported("job.results"), before);
  write_curve("separ.2", flower(60, 5, 0.3, {0.04, 0.02}));  // as it was
  EXPECT_EQ(report({"job.toml"})["run"], 0);
  EXPECT_EQ(exported("job.results"), before);
}

TEST_F(Batch, SameBytesForAnyThreadsMemoryShardsAndOrder) {
  write_curves(9, 300);
  report({"job.toml", "--store", "one", "--threads", "1"});
  report({"job.toml", "--store", "two", "--threads", "4"});
  report({"job.toml", "--store", "small", "--threads", "2", "--memory", "40k"});
  for (const char* const shard : {"1", "3", "2"}) {
    report({"job.toml", "--store", std::string("part") + shard, "--shard", std::string(shard) + "/3"});
  }
  EXPECT_EQ(run({"batch", "merge", "joined", "part2", "part1", "part3"}).status, 0);
  for (const char* const format : {"csv", "jsonl", "npy"}) {
    const std::string one = exported("one", format);
    EXPECT_EQ(exported("two", format), one);
    EXPECT_EQ(exported("small", format), one);
    EXPECT_EQ(exported("joined", format), one);
  }
}

TEST_F(Batch, MergeThatFailsLeavesNoStore) {
  write_curves(4, 50);
  report({"job.toml", "--store", "part", "--shard", "1/2"});
  write("other.toml", "operation = \"overlay\"\ncurves = \"separ.*\"\npairs = \"consecutive\"\n");
  report({"other.toml", "--store", "other"});
  for (const char* const second : {"missing", "other", "job.toml"}) {
    EXPECT_EQ(run({"batch", "merge", "joined", "part", second}).status, 1) << second;
    EXPECT_FALSE(exists("joined")) << second;
    EXPECT_FALSE(exists("joined-wal")) << second;
  }
}

TEST_F(Batch, AStoreIsMergedOnce) {
  write_curves(4, 50);
  report({"job.toml", "--store", "s"});
  const auto runs = [&](const std::string& store) {
    const std::string status = run({"batch", "status", store}).out;
    return std::count(status.begin(), status.end(), '\n') - 1;
  };
  std::filesystem::create_symlink("s", folder() / "link");
  for (const std::vector<std::string>& same : std::vector<std::vector<std::string>>{
           {"s", "s"}, {"s", "./s"}, {"s", "link"}, {"joined", "s", "s"}, {"joined", "link", "s"}}) {
    std::vector<std::string> arguments{"batch", "merge"};
    arguments.insert(arguments.end(), same.begin(), same.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << same.back();
    EXPECT_NE(outcome.err.find("are the same store; name each store once"), std::string::npos) << outcome.err;
    EXPECT_FALSE(exists("joined"));
  }
  EXPECT_EQ(runs("s"), 1);
  for (int round = 0; round < 2; ++round) {  // as when a shard has got further
    EXPECT_EQ(run({"batch", "merge", "joined", "s"}).status, 0);
    EXPECT_EQ(runs("joined"), 1);
  }
}

TEST_F(Batch, AHardLinkToAStoreIsNamed) {
  write_curves(4, 50);
  report({"job.toml", "--store", "s"});
  std::filesystem::create_hard_link(folder() / "s", folder() / "hard");
  EXPECT_EQ(run({"batch", "export", "hard"}).out, exported("s"));
  const Outcome twice = run({"batch", "merge", "joined", "s", "hard"});
  EXPECT_EQ(twice.status, 2);
  EXPECT_NE(twice.err.find("s and hard are the same store"), std::string::npos) << twice.err;
  const Outcome written = run({"batch", "run", "job.toml", "--store", "hard"});
  EXPECT_EQ(written.status, 1);
  EXPECT_NE(written.err.find("hard: has 2 names (hard links)"), std::string::npos) << written.err;
  std::filesystem::remove(folder() / "hard");
  EXPECT_EQ(report({"job.toml", "--store", "s"})["finished_before"], 6);
}

TEST_F(Batch, AnExportReplacesNoCurve) {
  std::filesystem::create_directory(folder() / "in");
  for (int k = 0; k < 3; ++k) write_curve("in/c" + std::to_string(k) + ".csv", flower(50, 3 + k, 0.3, {0.1 * k, 0}));
  write("in/job.toml", "operation = \"overlay\"\ncurves = \"c*.csv\"\n");
  report({"in/job.toml", "--store", "s"});
  std::filesystem::create_hard_link(folder() / "in" / "c2.csv", folder() / "other.csv");
  const std::string before = read("in/c1.csv") + read("in/c2.csv");
  for (const char* const name : {"in/c1.csv", "./in/c2.csv", "other.csv"}) {
    const Outcome outcome = run({"batch", "export", "s", "-o", name});
    EXPECT_EQ(outcome.status, 2) << name;
    EXPECT_NE(outcome.err.find("a curve of this batch; name another file"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(read("in/c1.csv") + read("in/c2.csv"), before);
  for (int round = 0; round < 2; ++round) EXPECT_EQ(run({"batch", "export", "s", "-o", "in/table.csv"}).status, 0);
}

TEST_F(Batch, FailuresAreRecordedAndTheRestGoesOn) {
  write_curves(4);
  write("separ.9", "0 0\n1 1\n1 0\n0 1\n");  // crosses itself
  write("separ.11", "0 0\nnonsense\n");
  const nlohmann::json done = report({"job.toml"}, 1);
  EXPECT_EQ(done["run"], 15);
  EXPECT_EQ(done["failed"], 9);
  const Outcome status = run({"batch", "status", "job.results"});
  EXPECT_NE(status.out.find("6 done, 9 failed, 0 to do"), std::string::npos) << status.out;
  EXPECT_NE(status.out.find("separ.0 separ.9: separ.9: is not simple"), std::string::npos) << status.out;
  EXPECT_NE(
      status.out.find("separ.9: is not simple: segments 0 and 2 meet at (0.5, 0.5); operation = \"regions\" takes "
                      "such curves\n"),
      std::string::npos)
      << status.out;
  EXPECT_NE(status.out.find("separ.11:2:"), std::string::npos) << status.out;
  EXPECT_NE(exported("job.results").find(",failed,"), std::string::npos);
  write_curve("separ.11", flower(60, 3, 0.1, {0, 0}));
  EXPECT_EQ(report({"job.toml"}, 1)["failed"], 5);  // the self-crossing one fails again
}

// A file that cannot be read is known by its content too: the second run forgot that it had failed.
TEST_F(Batch, UnreadableInputsStayFailures) {
  write_curves(3);
  write("separ.bad", "0,0\n1,0\nnan,1\n");
  EXPECT_EQ(report({"job.toml"}, 1)["failed"], 3);
  const std::string first = run({"batch", "status", "job.results"}).out, table = exported("job.results");
  EXPECT_NE(first.find("3 done, 3 failed, 0 to do"), std::string::npos) << first;
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(report({"job.toml"}, 1)["failed"], 3);
    const std::string status = run({"batch", "status", "job.results"}).out;
    EXPECT_NE(status.find("3 done, 3 failed, 0 to do"), std::string::npos) << status;
    EXPECT_EQ(exported("job.results"), table);
  }
  write("separ.bad", "0,0\n2,0\n0,2\n");
  EXPECT_EQ(report({"job.toml"})["failed"], 0);
}

TEST_F(Batch, SeveralOperationsGridsAndZones) {
  write_curves(3);
  write("job.toml", R"(curves = "separ.*"
[[group]]
name = "areas"
operation = "overlay"
options = { lobes = true }
[[group]]
operation = "interior"
grid = { method = ["split", "ends"] }
[[group]]
operation = "densify"
options = { max_length = 0.01, output = "fine_{name}.npy" }
)");
  EXPECT_EQ(report({"job.toml"})["run"], 3 + 6 + 3);
  EXPECT_TRUE(exists("fine_separ.1.npy"));
  EXPECT_EQ(run({"batch", "export", "job.results"}).status, 2);  // which of them?
  const std::string which = run({"batch", "export", "job.results"}).err;
  EXPECT_NE(which.find("the plan has several operations; choose one of "), std::string::npos) << which;
  for (const char* const words : {"interior", "densify", "--operation", "or JSON lines"}) {
    EXPECT_NE(which.find(words), std::string::npos) << which;
  }
  for (const char* const format : {"csv", "jsonl"}) {
    const Outcome slip = run({"batch", "export", "job.results", "--format", format, "--operation", "interor"});
    EXPECT_EQ(slip.status, 2);
    EXPECT_NE(slip.err.find("the plan has no operation interor; it has "), std::string::npos) << slip.err;
    EXPECT_NE(slip.err.find("; did you mean interior?"), std::string::npos) << slip.err;
  }
  const Outcome some = run({"batch", "export", "job.results", "--operation", "interior"});
  EXPECT_EQ(std::count(some.out.begin(), some.out.end(), '\n'), 7);
  const std::string lines = exported("job.results", "jsonl");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 12);
  const nlohmann::json first = nlohmann::json::parse(lines.substr(0, lines.find('\n')));
  EXPECT_EQ(first["lobes_c1_minus_c2"].size(), first["pieces_c1_minus_c2"]);
}

TEST_F(Batch, StatusSaysAFailureOnce) {
  write("job.toml",
        "operation = \"transport\"\noptions = { system = \"henon\", tolerance = 1e-3 }\n"
        "grid = { parameters.k = [-2, -1.5, -1.2, 1.02] }\n");
  (void)report({"job.toml"}, 1);
  const std::string status = run({"batch", "status", "job.results"}).out;
  EXPECT_NE(status.find("1 done, 3 failed, 0 to do"), std::string::npos) << status;
  EXPECT_NE(
      status.find("3 jobs failed, first parameters.k=-2: system henon has no tangle of its own at these parameters: "),
      std::string::npos)
      << status;
  EXPECT_EQ(std::count(status.begin(), status.end(), '\n'), 4) << status;
  EXPECT_NE(status.find("lober batch export job.results --format jsonl lists every job that failed"), std::string::npos)
      << status;
}

TEST_F(Batch, FilesInThePlaceOfASubcommandAreExplained) {
  write_curves(2);
  write("a.csv", "0,0\n1,0\n0,1\n");
  const Outcome curves = run({"batch", "./a.csv", "./b.csv"}), manifest = run({"batch", "job.toml"});
  EXPECT_EQ(curves.status, 2);
  EXPECT_NE(curves.err.find("write a manifest of three lines, operation = \"overlay\", curves = \"./*.csv\""),
            std::string::npos)
      << curves.err;
  EXPECT_EQ(manifest.status, 2);
  EXPECT_NE(manifest.err.find("give lober batch run job.toml"), std::string::npos) << manifest.err;
}

// The needs of numpy.load: a header that is aligned and a body of whole rows.
TEST_F(Batch, NpyExportIsAStructuredArray) {
  write_curves(4);
  write("separ.7", "0 0\n1 1\n1 0\n0 1\n");  // fails
  report({"job.toml"}, 1);
  ASSERT_EQ(run({"batch", "export", "job.results", "-o", "table.npy"}).status, 0);
  const std::string bytes = read("table.npy");
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x02\x00", 8));
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 8, sizeof(length));
  EXPECT_EQ((12 + length) % 64, 0U);
  const std::string header = bytes.substr(12, length);
  EXPECT_EQ(header.back(), '\n');
  EXPECT_NE(header.find("'shape': (10,)"), std::string::npos);
  std::size_t row = 0;
  const std::regex field("\\('\\w+', '[<|](i|f|S|b)(\\d+)'\\)");
  for (std::sregex_iterator at(header.begin(), header.end(), field), end; at != end; ++at) row += std::stoul((*at)[2]);
  EXPECT_EQ(bytes.size(), 12 + length + 10 * row);
  std::int64_t job = 0;
  std::memcpy(&job, bytes.data() + 12 + length + 9 * row, sizeof(job));
  EXPECT_EQ(job, 9);
}

TEST_F(Batch, CheckSaysHowMuchItIs) {
  write_curves(5);
  const Outcome outcome = run({"batch", "check", "job.toml"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.substr(0, 35), "10 jobs on 5 curves of 5 files\n    ");
  EXPECT_NE(outcome.out.find("about 300 points, 1.2e+03 over all jobs"), std::string::npos) << outcome.out;
  write("job.toml", "operation = \"overlay\"\ncurves = \"separ.*\"\npairs = \"none\"\n");
  const Outcome wrong = run({"batch", "check", "job.toml"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("job.toml:3: pairs: \"none\" cannot be read as"), std::string::npos) << wrong.err;
  EXPECT_EQ(std::count(wrong.err.begin(), wrong.err.end(), '\n'), 1);
}

TEST_F(Batch, BadCommandsAreRefused) {
  write_curves(3);
  for (const std::vector<std::string>& bad :
       std::vector<std::vector<std::string>>{{"batch"},
                                             {"batch", "walk"},
                                             {"batch", "run"},
                                             {"batch", "run", "job.toml", "--shard", "4/3"},
                                             {"batch", "run", "job.toml", "--shard", "1/4294967296"},
                                             {"batch", "run", "job.toml", "--memory", "much"},
                                             {"batch", "export", "job.results", "-o", "table.xls"}}) {
    EXPECT_EQ(run(bad).status, 2) << bad.back();
  }
  EXPECT_EQ(run({"batch", "run", "none.toml"}).status, 1);
  EXPECT_EQ(run({"batch", "status", "none"}).status, 1);
  write("text", "this is no store, but long enough to be looked at\n");
  EXPECT_EQ(run({"batch", "run", "job.toml", "--store", "text"}).status, 1);
  EXPECT_EQ(read("text"), "this is no store, but long enough to be looked at\n");
}

}  // namespace
}  // namespace lober::cli
