// Files that do not close their curve, given to commands that need a closed one.

#include <cmath>

#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

constexpr const char* remark = "is not closed in its file";

// Half a circle of many points, which is open, and a whole one without its last segment, as files of closed curves are.
std::vector<Point> arc(double turns, std::size_t points) {
  std::vector<Point> result(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = turns * 6.283185307179586 * static_cast<double>(k) / static_cast<double>(points);
    result[k] = {std::cos(angle), std::sin(angle)};
  }
  return result;
}

class OpenFile : public ProgramTest {
 protected:
  void SetUp() override {
    write_curve("half", arc(0.5, 200));
    write_curve("whole", arc(1, 200));
    std::vector<Point> repeated = arc(0.5, 200);
    repeated.push_back(repeated.front());
    write_curve("repeated", repeated);
    write_curve("other", box(-0.3, -0.3, 0.4, 0.5));
  }
};

TEST_F(OpenFile, IsClosedByItsChordWithARemark) {
  for (const std::string command : {"overlay", "interior"}) {
    const Outcome text = run({command, "half", "other"});
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.out.find(std::string("C1 ") + remark), std::string::npos) << text.out;
    EXPECT_EQ(text.out.find(std::string("C2 ") + remark), std::string::npos) << text.out;
    const Json inputs = Json::parse(run({command, "other", "half", "--json", "-"}).out)["inputs"];
    EXPECT_EQ(inputs[0].count("remark"), 0U);
    EXPECT_EQ(inputs[1].at("remark").get<std::string>().find(remark), 0U) << inputs[1];
  }
  EXPECT_NE(run({"overlay", "half", "other", "--rule", "nonzero"}).out.find(remark), std::string::npos);
}

TEST_F(OpenFile, ClosedCurvesGetNone) {
  for (const std::string curve : {"whole", "repeated"}) {
    for (const std::string command : {"overlay", "interior"}) {
      EXPECT_EQ(run({command, curve, "other"}).out.find(remark), std::string::npos) << curve;
    }
  }
}

}  // namespace
}  // namespace lober::cli
