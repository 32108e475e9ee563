// Common parts of the tests of `lober tangle`.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cli/program.hpp"
#include "tests/paths.hpp"

namespace lober::cli {

inline const std::string demo = LOBER_SOURCE_DIR "/examples/manifolds.dat";

// S zigzags back along U: pips at x = 2, 4, 6, 7.5, lobes that are triangles.
inline const std::vector<Point> straight{{0, 0}, {10, 0}};
inline const std::vector<Point> zigzag{{9, 3}, {7, -1}, {5, 1}, {3, -1}, {1.9, 0.1}};

class TangleProgram : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("u", straight);
    write_curve("s", zigzag);
  }
  // A failure with one line on standard error.
  void expect_failure(const std::vector<std::string>& arguments, int status, const std::string& words) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
  // The JSON that it prints when it warns.
  [[nodiscard]] Json warned(std::vector<std::string> arguments, const std::string& words) const {
    arguments.insert(arguments.begin(), "tangle");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    const Json result = Json::parse(outcome.out);
    EXPECT_NE(result["remarks"].dump().find(words), std::string::npos);
    return result;
  }
  static std::vector<double> column(const Json& list, const char* name) {
    std::vector<double> values;
    for (const Json& element : list) values.push_back(element[name]);
    return values;
  }
};

}  // namespace lober::cli
