// Numbers of a manifest come to the operation with the bits that they have there, whatever the locale of the program.

#include <array>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>

#include "engine/batch/batch.hpp"
#include "engine/batch/export/export.hpp"
#include "lober/curve/files.hpp"
#include "tests/engine/batch/scratch_folder.hpp"

namespace lober::detail {
namespace {

class DecimalComma : public std::numpunct<char> {
 protected:
  [[nodiscard]] char do_decimal_point() const override { return ','; }
};

bool comma() {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "%.1f", 0.5);
  return std::string(text.data()) == "0,5";
}

class UnderALocale : public ScratchFolder {
 protected:
  void SetUp() override {
    for (const char* const name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
      if (std::setlocale(LC_ALL, name) != nullptr && comma()) break;
    }
    if (!comma()) {  // made for this test
      const std::string make = "localedef -i de_DE -f UTF-8 '" + path("de_DE.UTF-8") + "' > /dev/null 2>&1";
      (void)!std::system(make.c_str());  // NOLINT(concurrency-mt-unsafe): one thread
      setenv("LOCPATH", path("").c_str(), 1);
      std::setlocale(LC_ALL, "de_DE.UTF-8");
    }
    before_ = std::locale::global(std::locale(std::locale(), new DecimalComma));
    // std::locale::global without a name leaves the locale of C alone.
    if (!comma()) GTEST_SKIP() << "there is no locale with a decimal comma, and none can be made";
  }
  void TearDown() override {
    std::locale::global(before_);
    std::setlocale(LC_ALL, "C");
  }
  std::locale before_;
};

TEST_F(UnderALocale, OptionsKeepTheirBits) {
  write_npy(path("a.npy"), wavy(20, 0));
  write("job.toml",
        "operation = \"densify\"\ncurves = \"a.npy\"\noptions = { min_length = 1e-310 }\ngrid = { max_length = [0.5, "
        "0.25, 1e-3] "
        "}\n");
  const Plan plan = make_plan(read_manifest(path("job.toml")));
  const Plan stored = Plan::decoded(plan.encoded());
  ASSERT_EQ(stored.groups.size(), 3U);
  for (const Plan& any : {plan, stored}) {
    EXPECT_EQ(any.groups[0].options.real("max_length"), 0.5);
    EXPECT_EQ(any.groups[2].options.real("max_length"), 1e-3);
    EXPECT_EQ(any.groups[0].options.real("min_length"), 1e-310);
  }
  EXPECT_NE(stored.groups[0].options.to_string().find("max_length=0.5 "), std::string::npos)
      << stored.groups[0].options.to_string();
  ASSERT_EQ(run_batch(read_manifest(path("job.toml")), {path("s"), {}, {}, {}}).queue.failed, 0U);
  export_results(Store::open(path("s")), path("out.csv"), ExportFormat::csv);
  std::ifstream lines(path("out.csv"));
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  for (; std::getline(lines, line); ++rows) EXPECT_NE(line.find("min_length=1e-310"), std::string::npos) << line;
  EXPECT_EQ(rows, 3);
}

}  // namespace
}  // namespace lober::detail
