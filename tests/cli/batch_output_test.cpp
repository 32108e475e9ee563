// The files that jobs of a batch write: where they may be, and what they may replace.

#include <unistd.h>

#include <filesystem>

#include "lober/curve/files.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

namespace fs = std::filesystem;

class BatchOutput : public ProgramTest {
 protected:
  BatchOutput() {
    fs::create_directory(folder() / "in");
    for (int k = 1; k <= 4; ++k) {
      write_npy((folder() / "in" / ("c" + std::to_string(k) + ".npy")).string(), flower(40, 2 + k, 0.3, {0.1 * k, 0}));
    }
  }
  void write_manifest(const std::string& output, const std::string& more = {}) const {
    write("in/job.toml", "operation = \"densify\"\ncurves = \"c*.npy\"\noptions = { max_length = 0.1, output = \"" +
                             output + "\" }\n" + more);
  }
  // Refused before anything is read or written, by `check` as by `run`, with `why`.
  void expect_refused(const std::string& output, const std::string& why, const std::string& more = {}) const {
    SCOPED_TRACE(output);
    write_manifest(output, more);
    for (const char* const verb : {"check", "run"}) {
      const Outcome outcome = run({"batch", verb, "in/job.toml"});
      EXPECT_EQ(outcome.status, 2) << outcome.err;
      EXPECT_NE(outcome.err.find("in/job.toml: options.output: "), std::string::npos) << outcome.err;
      EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(exists("in/job.results"));
  }
  [[nodiscard]] std::string inputs() const {
    std::string all;
    for (const char* const name : {"in/c1.npy", "in/c2.npy", "in/c3.npy", "in/c4.npy"}) all += read(name);
    return all;
  }
};

TEST_F(BatchOutput, NeverReplacesAnInput) {
  fs::create_symlink("c2.npy", folder() / "in" / "link.npy");
  fs::create_hard_link(folder() / "in" / "c3.npy", folder() / "in" / "hard.npy");
  fs::create_directory_symlink(".", folder() / "in" / "here");
  const std::string before = inputs();
  for (const char* const output :
       {"c1.npy", "{name}", "./c4.npy", "../in/c4.npy", "link.npy", "hard.npy", "here/c1.npy"}) {
    expect_refused(output, "would replace an input of the manifest");
  }
  EXPECT_EQ(inputs(), before);
  EXPECT_TRUE(fs::is_symlink(folder() / "in" / "link.npy"));
  // Neither does the report of a run that reads a part of the inputs only.
  write_manifest("fine_{name}");
  write("in/fine.toml", "operation = \"interior\"\ncurves = \"c*.npy\"\n");
  const Outcome report = run({"batch", "run", "in/fine.toml", "--shard", "1/6", "--json", "in/c4.npy"});
  EXPECT_EQ(report.status, 2) << report.err;
  EXPECT_EQ(inputs(), before);
}

TEST_F(BatchOutput, NeverReplacesItsStoreOrManifest) {
  for (const char* const output : {"job.results", "job.results-wal", "job.toml"}) {
    expect_refused(output, "would replace an input of the manifest, or its store");
  }
}

TEST_F(BatchOutput, StaysBelowItsFolder) {
  fs::create_directory(folder() / "out");
  fs::create_directory_symlink("../out", folder() / "in" / "away");
  write("victim", "precious");
  fs::create_symlink("../victim", folder() / "in" / "to_victim");
  fs::create_symlink("../nothing", folder() / "in" / "to_nothing");
  for (const std::string& output : std::vector<std::string>{"../{name}", (folder() / "out" / "{name}").string(),
                                                            "away/{name}", "to_victim", "../in2/{name}"}) {
    expect_refused(output, "lies outside of");
  }
  EXPECT_EQ(read("victim"), "precious");
  expect_refused("to_nothing", "would replace a file that is not a curve in NPY");
  expect_refused("nowhere/{name}", "which does not exist; make it first");
  EXPECT_TRUE(fs::is_empty(folder() / "out"));

  write_manifest("fine_{name}");
  EXPECT_EQ(run({"batch", "run", "in/job.toml", "--output-root", "out"}).status, 0);
  EXPECT_TRUE(exists("out/fine_c1.npy"));
  EXPECT_FALSE(exists("in/fine_c1.npy"));
  const Outcome nowhere = run({"batch", "run", "in/job.toml", "--output-root", "none", "--store", "s"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_NE(nowhere.err.find("none is not a folder; make it first"), std::string::npos) << nowhere.err;
  EXPECT_FALSE(exists("s"));
}

TEST_F(BatchOutput, ReplacesEarlierResultsAndNothingElse) {
  write("in/notes.npy", "not a curve");
  write("in/table.npy", read("in/c1.npy").replace(6, 1, "\2"));
  fs::create_directory(folder() / "in" / "folder.npy");
  for (const char* const output : {"notes.npy", "table.npy", "folder.npy"}) {
    expect_refused(output, "would replace a file that is not a curve in NPY");
  }
  EXPECT_EQ(read("in/notes.npy"), "not a curve");
  fs::create_directory(folder() / "out");
  write_manifest("fine_{name}");
  ASSERT_EQ(run({"batch", "run", "in/job.toml", "--output-root", "out"}).status, 0);
  const std::string fine = read("out/fine_c1.npy");
  write("in/job.toml",
        "operation = \"densify\"\ncurves = \"c*.npy\"\noptions = { max_length = 0.05, output = "
        "\"fine_{name}\" }\n");
  EXPECT_EQ(run({"batch", "run", "in/job.toml", "--output-root", "out"}).status, 0);
  EXPECT_GT(read("out/fine_c1.npy").size(), fine.size());
}

// The name of an input says nothing of the format of results; nor has an input without content a size.
TEST_F(BatchOutput, EndsInNpyWhateverItsInputIs) {
  write("in/sq.csv", "0,0\n1,0\n1,1\n0,1\n");
  write("in/empty.csv", "");
  write("in/job.toml",
        "operation = \"densify\"\ncurves = \"*.csv\"\noptions = { max_length = 0.3, output = \"fine_{name}\" }\n");
  const Outcome check = run({"batch", "check", "in/job.toml"});
  EXPECT_NE(check.out.find("about 4 points"), std::string::npos) << check.out;
  EXPECT_EQ(run({"batch", "run", "in/job.toml"}).status, 1);
  EXPECT_FALSE(exists("in/fine_sq.csv"));
  EXPECT_EQ(read("in/fine_sq.npy").substr(1, 5), "NUMPY");
}

TEST_F(BatchOutput, NeverEndsAsAnotherFormat) {
  for (const char* const ending : {".wkt", ".geojson", ".xy", ".tec", ".npz", ".mat", ".h5", ".nc", ".shp", ".TXT"}) {
    write_manifest(std::string("fine_{name}") + ending);
    const Outcome outcome = run({"batch", "run", "in/job.toml"});
    EXPECT_EQ(outcome.status, 2) << ending;
    EXPECT_NE(outcome.err.find(std::string(" ends in ") + ending + ", but the curve is written in NPY"),
              std::string::npos)
        << outcome.err;
  }
  write("in/sq.txt", "0 0\n1 0\n1 1\n0 1\n");
  const auto simplified = [&](const std::string& output) {
    write("in/job.toml",
          "operation = \"simplify\"\ncurves = \"sq.txt\"\noptions = { tolerance = 0, output = \"" + output + "\" }\n");
    return run({"batch", "run", "in/job.toml"}).status;
  };
  for (const char* const output : {"{name}_{tolerance}", "{name}.one.npy", "{name}_two", "{name}"}) {
    EXPECT_EQ(simplified(output), 0) << output;
  }
  for (const char* const name : {"sq_0.npy", "sq.one.npy", "sq_two", "sq.npy"}) {
    EXPECT_TRUE(exists(std::string("in/") + name)) << name;
  }
  EXPECT_EQ(simplified("{name}.wkt"), 2);
}

TEST_F(BatchOutput, IsOfOneJobOnly) {
  expect_refused("x.npy", "\"x.npy\" is the output of both job 0 and job 1; put {name}");
  expect_refused("x_{name}", "\"x_c1.npy\" is the output of both job 0 and job 1", "pairs = \"all\"\n");
  expect_refused("x_{name}", "is the output of both job 0 and job 4", "grid = { simplify = [0.0, 0.1] }\n");
  fs::create_symlink("x_c1.npy", folder() / "in" / "x_c2.npy");
  write_npy((folder() / "in" / "x_c1.npy").string(), flower(40, 2, 0.3, {0, 0}));
  expect_refused("x_{name}", "is the output of both job 0 and job 1");
  fs::remove(folder() / "in" / "x_c2.npy");

  write_manifest("y_{name}_{second}_{simplify}_{no}", "pairs = \"consecutive\"\ngrid = { simplify = [0.0, 0.125] }\n");
  EXPECT_EQ(run({"batch", "run", "in/job.toml"}).status, 0);
  for (const char* const name : {"y_c1.npy_c2.npy_0_{no}", "y_c3.npy_c4.npy_0.125_{no}"}) {
    EXPECT_TRUE(exists(std::string("in/") + name)) << name;
  }
}

}  // namespace
}  // namespace lober::cli
