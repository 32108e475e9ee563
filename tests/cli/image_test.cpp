// `lober image`: images and pre-images of curves.
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <sstream>

#include "lober/dynamics/systems.hpp"
#include "tests/cli/program.hpp"

namespace lober::cli {
namespace {

class ImageProgram : public ProgramTest {
 protected:
  [[nodiscard]] Json image(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "image");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(ImageProgram, KeepsTheAreaOfACircle) {
  const Json found = image({"standard", "--param", "K=1.2", "--circle", "3.14159,0,1", "--iterates", "-4:3",
                            "--tolerance", "1e-6", "-o", "circle.dat"});
  ASSERT_EQ(found["images"].size(), 8U);
  for (int n = -4; n <= 3; ++n) {
    const Json& one = found["images"][static_cast<std::size_t>(n + 4)];
    EXPECT_EQ(one["iterate"], n);
    EXPECT_EQ(one["parts"], Json::array({{{"points", one["points"]}, {"closed", true}}}));
    EXPECT_NEAR(one["area"].get<double>(), std::numbers::pi, 1e-5);
    EXPECT_LE(std::fabs(one["area"].get<double>() - std::numbers::pi), one["area_error"].get<double>());
  }
  EXPECT_EQ(found["agreement"], true);
  const std::string zones = read("circle.dat");
  EXPECT_NE(zones.find("ZONE T=\"f^-4\""), std::string::npos);
  EXPECT_NE(zones.find("ZONE T=\"f^3\""), std::string::npos);
}

// T(3) of the vortex pair by the overlap of the boundary with its third image, against the action of orbits.
TEST_F(ImageProgram, OfABoundaryGivesTheFlux) {
  const Json found = image({"ovp", "--boundary", "--iterates", "-1:3", "--tolerance", "1e-5", "-o", "boundary.dat"});
  EXPECT_EQ(found["curve"]["closed"], true);
  const Json areas = overlay({"boundary.dat#f^0", "boundary.dat#f^3", "--areas-only"})["areas"];
  EXPECT_NEAR(areas["c1"].get<double>(), 4.5732702376385334, 1e-4);
  EXPECT_NEAR(areas["c1_minus_c2"].get<double>(), 0.746356722605078, 3e-4);
  EXPECT_NEAR(areas["c2_minus_c1"].get<double>(), 0.746356722605078, 3e-4);
  const Json back = overlay({"boundary.dat#f^0", "boundary.dat#f^-1", "--areas-only"})["areas"];
  EXPECT_NEAR(back["c1_minus_c2"].get<double>(), 0.254106277099507, 1e-4);
}

// On a cylinder the region lies between two boundaries. (x, y) -> (-x, -y) takes the one to the other.
TEST_F(ImageProgram, OfACylinderTakesBothBoundaries) {
  const Json found = image(
      {"standard", "--param", "K=1.2", "--boundary", "--iterates", "0:1", "--tolerance", "1e-4", "-o", "both.dat"});
  EXPECT_EQ(found["curve"]["closed"], false);
  ASSERT_EQ(found["images"].size(), 4U);
  for (const std::size_t k : {0U, 1U, 2U, 3U}) {
    EXPECT_EQ(found["images"][k]["curve"], k / 2);
    EXPECT_EQ(found["images"][k]["iterate"], k % 2);
  }
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_NEAR(found["images"][k]["length"].get<double>(), found["images"][k + 2]["length"].get<double>(), 1e-3);
  }
  EXPECT_NE(read("both.dat").find("ZONE T=\"f^1 boundary 2\""), std::string::npos);
  (void)image(
      {"standard", "--param", "K=1.2", "--boundary", "--iterates", "1", "--tolerance", "1e-3", "-o", "b{n}.csv"});
  // The upper one lies above p = 0, the lower one below.
  const auto second_of_middle = [](const std::string& text) {
    const std::size_t line = text.find('\n', text.size() / 2) + 1;
    return std::stod(text.substr(text.find(',', line) + 1));
  };
  EXPECT_GT(second_of_middle(read("b1.csv")), 0);
  EXPECT_LT(second_of_middle(read("b1-boundary2.csv")), 0);
}

TEST_F(ImageProgram, OfAFileIsTheImageOfItsPoints) {
  write("open.csv", "x,y\n1,0.5\n2,0.25\n2.5,0.75\n");
  const Json found = image({"standard", "open.csv", "--open", "--param", "K=0.5", "--iterates", "1", "--tolerance",
                            "1e-3", "-o", "image{n}.csv"});
  EXPECT_EQ(found["images"][0]["area"], nullptr);
  EXPECT_EQ(found["curve"]["file"], "open.csv");
  // p' = p + K sin x, x' = x + p'.
  const auto line = [](double x, double p) {
    const double next = p + 0.5 * std::sin(x);
    return std::pair{x + next, next};
  };
  const std::string points = "\n" + read("image1.csv");
  for (const auto& [x, p] : {line(1, 0.5), line(2, 0.25), line(2.5, 0.75)}) {
    char text[80];
    std::snprintf(text, sizeof text, "\n%.12g", x);
    EXPECT_NE(points.find(std::string(text).substr(0, 12)), std::string::npos) << points.substr(0, 300);
  }
  EXPECT_FALSE(exists("image{n}.csv"));
}

TEST_F(ImageProgram, WritesPartsBetweenGaps) {
  const Json found = image({"capsize", "--circle", "0,0,0.4", "--iterates", "0:3", "--tolerance", "1e-3", "-o",
                            "gaps{n}.npy", "--svg", "gaps.svg"});
  const Json& last = found["images"][3];
  ASSERT_GT(last["parts"].size(), 1U);
  EXPECT_EQ(last["area"], nullptr);
  EXPECT_EQ(last["diagnostics"][0]["cause"], "failed");
  EXPECT_EQ(last["diagnostics"][0]["count"], last["parts"].size());
  for (std::size_t part = 1; part <= last["parts"].size(); ++part) {
    EXPECT_EQ(last["parts"][part - 1]["closed"], false);
    EXPECT_TRUE(exists("gaps3-part" + std::to_string(part) + ".npy"));
  }
  EXPECT_FALSE(exists("gaps3.npy"));
  EXPECT_TRUE(exists("gaps2.npy"));
  EXPECT_NE(read("gaps.svg").find("points in " + std::to_string(last["parts"].size()) + " parts"), std::string::npos);
  const Outcome text = run({"image", "capsize", "--circle", "0,0,0.4", "--iterates", "3", "--tolerance", "1e-3"});
  EXPECT_NE(text.out.find("gaps, where points have no image"), std::string::npos) << text.out;
}

TEST_F(ImageProgram, SaysWhereTheToleranceDoesNotHold) {
  const Json found = image({"henon", "--rectangle", "-3,-3,3,3", "--iterates", "0:2", "--tolerance", "1e-3"});
  EXPECT_EQ(found["images"][0]["area"], 36.0);
  EXPECT_EQ(found["images"][2]["area"], nullptr);
  EXPECT_EQ(found["images"][2]["diagnostics"][0]["cause"], "left-box");
  const Json wide = image(
      {"henon", "--rectangle", "-3,-3,3,3", "--iterates", "0:2", "--tolerance", "1e-3", "--box", "-500,-500,500,500"});
  EXPECT_NEAR(wide["images"][2]["area"].get<double>(), 36, wide["images"][2]["area_error"].get<double>());
  const Json few =
      image({"henon", "--rectangle", "-3,-3,3,3", "--iterates", "0:2", "--tolerance", "1e-3", "--max-points", "20"});
  EXPECT_EQ(few["images"].back()["complete"], false);
  const Outcome limited = run({"image", "henon", "--rectangle", "-3,-3,3,3", "--iterates", "0:2", "--tolerance", "1e-3",
                               "--max-points", "20", "--json", "-"});
  EXPECT_EQ(limited.status, 0);
  EXPECT_NE(limited.err.find("max_points allows no more; give a larger max_points\n"), std::string::npos)
      << limited.err;
}

TEST_F(ImageProgram, SaysOfAllImagesThatEndEarly) {
  const Outcome both = run({"image", "capsize", "--circle", "0.1,0,0.15", "--iterates=-2:2", "--max-points", "700"});
  EXPECT_EQ(both.status, 0);
  for (const std::string said :
       {"f^-1 ends early", "f^1 ends early", "2 images are left out", "a larger max_points\n"}) {
    EXPECT_NE(both.err.find(said), std::string::npos) << both.err;
  }
}

TEST_F(ImageProgram, HasTheSameBytesForAnyNumberOfThreads) {
  std::set<std::string> seen;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome = run({"image", "duffing", "--circle", "1,0,0.3", "--iterates", "-2:4", "--tolerance", "1e-5",
                                 "--threads", threads, "-o", "images.dat", "--json", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    seen.insert(without_timing(outcome.out) + read("images.dat"));
  }
  EXPECT_EQ(seen.size(), 1U);
}

TEST_F(ImageProgram, RefusesWhatMakesNoSense) {
  write_curve("square.dat", box(0, 0, 2, 2));
  const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& words) {
    arguments.insert(arguments.begin(), "image");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused({"henon", "--tolerance", "1e-3"}, 2, "the curve is missing");
  refused({"nosuch", "square.dat", "--tolerance", "1e-3"}, 2, "nosuch");
  refused({"henon", "nowhere", "--tolerance", "1e-3"}, 1, "nowhere: ");
  refused({"henon", "square.dat", "--circle", "0,0,1", "--tolerance", "1e-3"}, 2, "cannot be given together");
  refused({"henon", "--circle", "0,0,0", "--tolerance", "1e-3"}, 2, "R has to be above 0");
  refused({"henon", "--circle", "0,0,1e-9"}, 2, "tolerance: 1e-05 is more than the size of the curve, 2e-09");
  refused({"henon", "--rectangle", "0,0,0,1", "--tolerance", "1e-3"}, 2, "x0 < x1");
  refused({"henon", "square.dat", "--iterates", "3:1", "--tolerance", "1e-3"}, 2, "FIRST has to come before LAST");
  refused({"henon", "square.dat", "--iterates", "1.5", "--tolerance", "1e-3"}, 2, "not a whole number");
  refused({"henon", "square.dat", "--iterates", "1:2", "--tolerance", "1e-3", "-o", "x.npy"}, 2, "{n}");
  refused({"henon", "square.dat", "--tolerance", "1e-3", "-o", "square.dat"}, 2, "overwrite");
  refused({"capsize", "--boundary", "--tolerance", "1e-3"}, 2, "no tangle");
  refused({"henon", "--circle", "0,0,1", "--open", "--tolerance", "1e-3"}, 2, "--open");
}

// A single image is one curve, which any format takes.
TEST_F(ImageProgram, WritesASingleImageInAnyFormat) {
  for (const char* const name : {"im.npy", "im.csv", "im.dat"}) {
    const Outcome outcome =
        run({"image", "standard", "--circle", "2,0.5,0.01", "--tolerance", "1e-4", "--iterates", "2", "-o", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(exists(name)) << name;
  }
  const Outcome two = run({"image", "standard", "--circle", "2,0.5,0.01", "--iterates", "1:2", "-o", "two.npy"});
  EXPECT_EQ(two.status, 2);
  EXPECT_NE(two.err.find("several curves need a format that holds several"), std::string::npos) << two.err;
}

// The bip q of the vortex pair, and f^-1(q), which the map takes to it.
TEST_F(ImageProgram, MarksTheBipOfABoundaryAndItsImages) {
  const Outcome outcome = run({"image", "ovp", "--boundary", "--tolerance", "1e-3", "--iterates", "-1:0", "--picture",
                               "b.svg", "--data", "b.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(read("b.svg").find("bip q and its images"), std::string::npos);
  std::vector<Point> bips;
  std::istringstream lines(read("b.csv"));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("bips,")) continue;
    const std::size_t x = line.find(",,") + 2, y = line.find(',', x) + 1;
    bips.push_back({std::stod(line.substr(x)), std::stod(line.substr(y))});
  }
  ASSERT_EQ(bips.size(), 2U);
  const System ovp = make_system("ovp");
  ovp.map->iterate(std::span<Point>(bips.data(), 1), 1);
  EXPECT_NEAR(bips[0].x, bips[1].x, 1e-9);
  EXPECT_NEAR(bips[0].y, bips[1].y, 1e-9);
  EXPECT_NEAR(bips[1].x, 0, 1e-9);
  EXPECT_NEAR(bips[1].y, 2.068482945180626534, 1e-9);
}

}  // namespace
}  // namespace lober::cli
