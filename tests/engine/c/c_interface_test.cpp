// The C interface gives what the C++ one gives, and survives what a caller may do wrong.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "lober/curve/files.hpp"
#include "lober/dynamics/orbits.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/lober.h"
#include "lober/overlay/overlap_matrix.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/transport/transport.hpp"

namespace lober {
namespace {

struct Free {
  void operator()(lober_result* result) const { lober_result_free(result); }
  void operator()(lober_model* model) const { lober_model_free(model); }
};
using Result = std::unique_ptr<lober_result, Free>;
using Model = std::unique_ptr<lober_model, Free>;

// The result of the call; fails the test with the message if there is none.
template <typename Call>
Result made(const Call& call) {
  lober_result* result = nullptr;
  EXPECT_EQ(call(&result), LOBER_OK) << lober_message();
  return Result(result);
}

Model model(const char* name, const char* parameters = nullptr) {
  lober_model* opened = nullptr;
  EXPECT_EQ(lober_model_open(name, parameters, nullptr, &opened), LOBER_OK) << lober_message();
  return Model(opened);
}

std::vector<double> circle_coordinates(double x, double y, double radius, int count) {
  std::vector<double> points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    points.push_back(x + radius * std::cos(angle));
    points.push_back(y + radius * std::sin(angle));
  }
  return points;
}

lober_array array_of(const Result& result, const char* name) {
  lober_array array{};
  EXPECT_EQ(lober_array_named(result.get(), name, &array), LOBER_OK) << lober_message();
  return array;
}

std::vector<double> doubles_of(const Result& result, const char* name) {
  const lober_array array = array_of(result, name);
  EXPECT_EQ(array.type, LOBER_DOUBLES);
  const auto* const data = static_cast<const double*>(array.data);
  return {data, data + array.rows * array.columns};
}

ClosedCurve curve_of(const std::vector<double>& points) {
  std::vector<Point> list;
  for (std::size_t k = 0; k < points.size(); k += 2) list.push_back({points[k], points[k + 1]});
  return ClosedCurve(list);
}

TEST(CInterface, OverlapMatrixIsThatOfCpp) {
  std::vector<double> points;
  std::vector<std::size_t> begin{0};
  for (int k = 0; k < 8; ++k) {
    const std::vector<double> circle = circle_coordinates(0.4 * k, 0.1 * k, 1 - 0.05 * k, 30 + k);
    points.insert(points.end(), circle.begin(), circle.end());
    begin.push_back(points.size() / 2);
  }
  const std::span<const Point> all(reinterpret_cast<const Point*>(points.data()), points.size() / 2);
  std::vector<CurveView> curves;
  for (std::size_t k = 0; k < 8; ++k) curves.push_back({all.subspan(begin[k], begin[k + 1] - begin[k])});
  OverlapOptions options;
  options.measures = {OverlapMeasure::union_, OverlapMeasure::crossings};
  const OverlapMatrix expected = overlap_matrix(std::span(curves).first(3), std::span(curves).subspan(3), options);
  const auto call = [&](const char* how, lober_result** result) {
    return lober_overlap_matrix(points.data(), begin.data(), 3, points.data(), &begin[3], 5, how, result);
  };
  const Result sparse = made([&](lober_result** result) { return call("what=union,crossings threads=2", result); });
  const lober_array values = array_of(sparse, "union"), column = array_of(sparse, "column");
  ASSERT_EQ(values.rows, expected.column.size());
  ASSERT_EQ(array_of(sparse, "begin").rows, 4u);
  for (std::size_t k = 0; k < values.rows; ++k) {
    EXPECT_EQ(static_cast<const double*>(values.data)[k], expected.numbers[0].values[k]);
    EXPECT_EQ(static_cast<const std::int64_t*>(column.data)[k], expected.column[k]);
  }
  const Result dense = made([&](lober_result** result) { return call("what=union,crossings dense=1", result); });
  const lober_array matrix = array_of(dense, "error.rounding.union");
  EXPECT_EQ(matrix.rows, 3u);
  EXPECT_EQ(matrix.columns, 5u);
  EXPECT_EQ(static_cast<const double*>(matrix.data)[0], expected.dense_bounds(0)[0]);
  EXPECT_EQ(lober_number(dense.get(), "pairs"), static_cast<double>(expected.pairs));
}

TEST(CInterface, OverlapMatrixRefusesAndIsCancelled) {
  const std::vector<double> circle = circle_coordinates(0, 0, 1, 500);
  const std::vector<std::size_t> begin{0, 250, 500}, wrong{0, 300, 200};
  lober_result* result = nullptr;
  const auto of_one_set = [&](const std::size_t* at, const char* how) {
    return lober_overlap_matrix(circle.data(), at, 2, nullptr, nullptr, 0, how, &result);
  };
  EXPECT_EQ(of_one_set(wrong.data(), nullptr), LOBER_USAGE_ERROR);
  EXPECT_EQ(of_one_set(nullptr, nullptr), LOBER_USAGE_ERROR);
  EXPECT_EQ(of_one_set(begin.data(), "what=area"), LOBER_USAGE_ERROR);
  EXPECT_TRUE(std::string(lober_message()).find("intersection, union") != std::string::npos) << lober_message();
  EXPECT_EQ(of_one_set(begin.data(), "what="), LOBER_USAGE_ERROR);
  EXPECT_EQ(of_one_set(begin.data(), "dense=2"), LOBER_USAGE_ERROR);
  const std::vector<double> bow{0, 0, 1, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::vector<std::size_t> of_bow{0, 4, 7};
  const auto of_a_bow = [&](const char* how) {
    return lober_overlap_matrix(bow.data(), of_bow.data(), 2, nullptr, nullptr, 0, how, &result);
  };
  EXPECT_EQ(of_a_bow(nullptr), LOBER_DATA_ERROR);
  EXPECT_STREQ(lober_message(), "curve 0: is not simple: segments 0 and 2 meet");
  ASSERT_EQ(of_a_bow("keep_going=1 dense=1"), LOBER_OK);
  const Result kept(result);
  EXPECT_EQ(array_of(kept, "failures.row").rows, 1u);
  EXPECT_TRUE(std::isnan(static_cast<const double*>(array_of(kept, "intersection").data)[1]));
  lober_set_progress([](double, void*) { return 0; }, nullptr);
  EXPECT_EQ(of_one_set(begin.data(), nullptr), LOBER_CANCELLED);
  lober_set_progress(nullptr, nullptr);
  EXPECT_EQ(result, nullptr);
}

TEST(CInterface, OverlayIsThatOfCpp) {
  const std::vector<double> one = circle_coordinates(0, 0, 1, 500), two = circle_coordinates(0.7, 0.1, 0.9, 400);
  const Result result = made(
      [&](lober_result** to) { return lober_overlay(one.data(), 500, two.data(), 400, "threads=2 outlines=1", to); });
  const Overlay expected = overlay(curve_of(one), curve_of(two));
  EXPECT_EQ(lober_number(result.get(), "areas.c1_minus_c2"), expected.areas.c1_minus_c2);
  EXPECT_EQ(lober_number(result.get(), "areas.union"), expected.areas.union_);
  EXPECT_EQ(lober_number(result.get(), "error.rounding.intersection"), expected.rounding.intersection);
  EXPECT_EQ(array_of(result, "crossings.list.x").rows, expected.nodes.size());
  EXPECT_EQ(doubles_of(result, "crossings.list.y").at(0), expected.nodes[0].begin.y);
  const auto areas = expected.pieces(Pairing::c1_minus_c2).areas();
  EXPECT_EQ(doubles_of(result, "pieces.c1_minus_c2.area"), std::vector<double>(areas.begin(), areas.end()));
  const Result polygon = made([&](lober_result** to) { return lober_outline(result.get(), "intersection", 0, to); });
  const auto outlines = outline(expected, Pairing::intersection, 0);
  EXPECT_EQ(array_of(polygon, "begin").rows, outlines.size());
  EXPECT_EQ(doubles_of(polygon, "points").at(0), outlines[0][0].x);
  double area = 0;
  ASSERT_EQ(lober_signed_area(doubles_of(polygon, "points").data(), array_of(polygon, "points").rows, &area), LOBER_OK);
  EXPECT_NEAR(area, expected.areas.intersection, 1e-15);
}

TEST(CInterface, InteriorRegionsAndWindingAgree) {
  const std::vector<double> one = circle_coordinates(0, 0, 1, 300), two = circle_coordinates(0.7, 0.1, 0.9, 200);
  const auto with = [&](auto function) {
    return made([&](lober_result** to) { return function(one.data(), 300, two.data(), 200, nullptr, to); });
  };
  const Result overlaid = with(lober_overlay), interior = with(lober_interior), regions = with(lober_regions);
  for (const char* const name : {"areas.c1", "areas.c2", "areas.intersection", "areas.union", "areas.c2_minus_c1"}) {
    EXPECT_NEAR(lober_number(interior.get(), name), lober_number(overlaid.get(), name), 1e-14) << name;
    EXPECT_NEAR(lober_number(regions.get(), name), lober_number(overlaid.get(), name), 1e-14) << name;
  }
  // A figure of eight: one loop each way.
  const std::vector<double> eight{0, 0, 2, 2, 2, 0, 0, 2};
  const Result of_one =
      made([&](lober_result** to) { return lober_regions(eight.data(), 4, nullptr, 0, nullptr, to); });
  EXPECT_EQ(lober_number(of_one.get(), "areas.c1"), 2);
  const std::vector<double> at{1.8, 1, 0.2, 1, 5, 5, 0, 0};
  const Result winding =
      made([&](lober_result** to) { return lober_winding(eight.data(), 4, at.data(), 4, nullptr, to); });
  const auto* const numbers = static_cast<const std::int64_t*>(array_of(winding, "points.winding").data);
  const auto* const on = static_cast<const std::int64_t*>(array_of(winding, "points.on").data);
  EXPECT_EQ(numbers[0], -1);
  EXPECT_EQ(numbers[1], 1);
  EXPECT_EQ(numbers[2], 0);
  EXPECT_EQ(on[3], 1);
  EXPECT_NEAR(doubles_of(winding, "points.j")[0], -2 * std::numbers::pi, 1e-14);
}

TEST(CInterface, DensifySimplifyAndFiles) {
  const std::vector<double> coarse = circle_coordinates(0, 0, 1, 40);
  const Result dense = made([&](lober_result** to) { return lober_densify(coarse.data(), 40, "max_length=0.05", to); });
  const lober_array points = array_of(dense, "points");
  EXPECT_EQ(points.rows, 160U);  // segments of 0.157, four parts each
  const auto* const data = static_cast<const double*>(points.data);
  const Result fewer = made([&](lober_result** to) { return lober_simplify(data, points.rows, "tolerance=1e-9", to); });
  EXPECT_EQ(array_of(fewer, "points").rows, 40U);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "lober_c_interface";
  std::filesystem::create_directories(folder);
  for (const char* const name : {"curve.npy", "curve.csv", "curve.raw", "curve.f64", "curve.txt"}) {
    const std::string path = folder / name;
    ASSERT_EQ(lober_write(path.c_str(), data, points.rows), LOBER_OK) << lober_message();
    const Result back = made([&](lober_result** to) { return lober_read(path.c_str(), "closed=1", to); });
    EXPECT_EQ(doubles_of(back, "points"), doubles_of(dense, "points")) << name;
  }
  std::filesystem::remove_all(folder);
}

// The status of a call that makes a result all the same.
template <typename Call>
Result made_with(int status, const char* words, const Call& call) {
  lober_result* result = nullptr;
  EXPECT_EQ(call(&result), status) << lober_message();
  EXPECT_NE(std::string(lober_message()).find(words), std::string::npos) << lober_message();
  EXPECT_NE(result, nullptr);
  return Result(result);
}

TEST(CInterface, LimitsOfDensifyHaveAStatus) {
  const std::vector<double> coarse = circle_coordinates(0, 0, 1, 40);
  const Result full = made_with(LOBER_INCOMPLETE, "give a larger max_points", [&](lober_result** to) {
    return lober_densify(coarse.data(), 40, "max_length=0.001 max_points=100", to);
  });
  EXPECT_LE(array_of(full, "points").rows, 100U);
  EXPECT_GE(array_of(full, "diagnostics.list.segment").rows, 1U);
  EXPECT_TRUE(std::string_view(static_cast<const char*>(array_of(full, "diagnostics.list.cause").data))
                  .starts_with("max_points"));
  // A shortest length is what was asked for.
  const Result coarser =
      made([&](lober_result** to) { return lober_densify(coarse.data(), 40, "max_length=0.001 min_length=0.01", to); });
  EXPECT_GE(array_of(coarser, "diagnostics.list.count").rows, 1U);
  const Result done = made([&](lober_result** to) { return lober_densify(coarse.data(), 40, "max_length=0.05", to); });
  EXPECT_EQ(array_of(done, "diagnostics.list.segment").rows, 0U);
}

TEST(CInterface, LimitsOfManifoldsAndImagesHaveAStatus) {
  const Model standard = model("standard", "K=1.1");
  const Result grown = made_with(LOBER_INCOMPLETE, "give a larger max_points", [&](lober_result** to) {
    return lober_grow(standard.get(), "iterates=14 max_points=100", to);
  });
  EXPECT_LE(array_of(grown, "points").rows, 100U);
  EXPECT_GE(array_of(grown, "points").rows, 2U);
  const std::vector<double> box{0.1, 0.1, 3, 0.1, 3, 3, 0.1, 3};
  const Result image = made_with(LOBER_INCOMPLETE, "give a larger max_points", [&](lober_result** to) {
    return lober_image(standard.get(), box.data(), 4, "first=9 max_points=100", to);
  });
  EXPECT_LE(array_of(image, "images.0.polygon").rows, 100U);
}

TEST(CInterface, ZonesAreNamedAsInTheHeader) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "lober_c_zones.dat";
  const std::vector<Point> first{{0, 0}, {1, 0}, {0, 1}}, second{{5, 5}, {6, 5}, {5, 6}};
  write_tecplot(file, std::vector<Zone>{{"one", first, 1}, {"two", second, 1}});
  for (const char* const zone : {"#1", "#two"}) {
    const std::string spec = file.string() + zone;
    const Result read = made([&](lober_result** to) { return lober_read(spec.c_str(), nullptr, to); });
    EXPECT_EQ(doubles_of(read, "points"), (std::vector<double>{5, 5, 6, 5, 5, 6}));
  }
  std::filesystem::remove(file);
}

TEST(CInterface, IterateCanBeCancelled) {
  for (const char* const name : {"henon", "duffing"}) {
    const Model opened = model(name);
    const std::vector<double> before{0.01, 0.01, 0.02, 0.01};
    std::vector<double> points = before;
    int calls = 0;
    lober_set_progress(
        [](double fraction, void* context) {
          EXPECT_GE(fraction, 0);
          EXPECT_LE(fraction, 1);
          return ++*static_cast<int*>(context) < 3 ? 1 : 0;
        },
        &calls);
    EXPECT_EQ(lober_iterate(opened.get(), points.data(), 2, 2'000'000'000), LOBER_CANCELLED) << name;
    lober_set_progress(nullptr, nullptr);
    EXPECT_EQ(calls, 3);
    EXPECT_EQ(points, before);
  }
}

TEST(CInterface, IteratesInPiecesAreThoseOfOneCall) {
  for (const char* const name : {"henon", "standard", "duffing"}) {
    const Model opened = model(name);
    const System system = make_system(name);
    Buffer<Point> expected = spread_points(system.window, 5000);
    Buffer<Point> points = expected;
    system.map->iterate(expected, -100);
    ASSERT_EQ(lober_iterate(opened.get(), &points.data()->x, points.size(), -100), LOBER_OK) << lober_message();
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(points[k].x), std::bit_cast<std::uint64_t>(expected[k].x)) << name << k;
      EXPECT_EQ(std::bit_cast<std::uint64_t>(points[k].y), std::bit_cast<std::uint64_t>(expected[k].y)) << name << k;
    }
  }
}

// It recursed until the stack was full.
TEST(CInterface, ProgressFunctionsCannotCallLober) {
  struct Seen {
    std::vector<double> circle = circle_coordinates(0, 0, 1, 3000);
    std::vector<int> status;
    std::string message;
  } seen;
  const auto function = [](double, void* context) {
    auto& all = *static_cast<Seen*>(context);
    lober_result* result = nullptr;
    const double* const points = all.circle.data();
    all.status.push_back(lober_overlay(points, 3000, points, 3000, nullptr, &result));
    EXPECT_EQ(result, nullptr);
    all.message = lober_message();
    double area = 0;
    all.status.push_back(lober_signed_area(points, 3000, &area));
    return 1;
  };
  lober_set_progress(function, &seen);
  const std::vector<double> other = circle_coordinates(0.5, 0, 1, 3000);
  const auto overlay_of = [&](lober_result** to) {
    return lober_overlay(seen.circle.data(), 3000, other.data(), 3000, nullptr, to);
  };
  EXPECT_TRUE(made(overlay_of));
  lober_set_progress(nullptr, nullptr);
  ASSERT_FALSE(seen.status.empty());
  for (const int status : seen.status) EXPECT_EQ(status, LOBER_USAGE_ERROR);
  EXPECT_EQ(seen.message, "a progress function cannot call lober; let it return, and call lober afterwards");
  EXPECT_TRUE(made(overlay_of));
}

TEST(CInterface, SystemsGiveWhatCppGives) {
  const Model standard = model("standard", "K=1.1");
  const System system = make_system("standard", {{"K", 1.1}});
  std::vector<double> points{0.3, 0.2, 1, -1};
  std::array<Point, 2> expected{{{0.3, 0.2}, {1, -1}}};
  system.map->iterate(expected, -3);
  ASSERT_EQ(lober_iterate(standard.get(), points.data(), 2, -3), LOBER_OK);
  EXPECT_EQ(points, (std::vector<double>{expected[0].x, expected[0].y, expected[1].x, expected[1].y}));

  const Result fixed = made([&](lober_result** to) { return lober_fixed_points(standard.get(), nullptr, to); });
  EXPECT_EQ(array_of(fixed, "points.derivative").columns, 4U);
  EXPECT_NE(std::string(static_cast<const char*>(array_of(fixed, "points.type").data)).find("saddle"),
            std::string::npos);

  const Result grown = made([&](lober_result** to) { return lober_grow(standard.get(), "iterates=5", to); });
  EXPECT_EQ(array_of(grown, "points").rows, array_of(grown, "parameters").rows);
  const std::vector<double> box{0.1, 0.1, 0.2, 0.1, 0.2, 0.2, 0.1, 0.2};
  const Result image =
      made([&](lober_result** to) { return lober_image(standard.get(), box.data(), 4, "first=2", to); });
  double area = 0;
  ASSERT_EQ(
      lober_signed_area(doubles_of(image, "images.0.polygon").data(), array_of(image, "images.0.polygon").rows, &area),
      LOBER_OK);
  EXPECT_NEAR(area, 0.01, 1e-6);

  const Result tangle = made([&](lober_result** to) { return lober_model_tangle(standard.get(), "outlines=1", to); });
  const Result moved = made([&](lober_result** to) { return lober_transport(standard.get(), "iterates=2", to); });
  const auto direct = grow_tangle(*system.map, *system.connection);
  const std::vector<double> actions = doubles_of(tangle, "turnstile_by_action.lobes.action");
  ASSERT_EQ(actions.size(), 2 * direct->areas_by_action.size());
  for (std::size_t k = 0; k < direct->areas_by_action.size(); ++k) {
    EXPECT_EQ(actions[2 * k], direct->areas_by_action[k]);
    EXPECT_EQ(actions[2 * k + 1], direct->action_errors[k]);
  }
  EXPECT_EQ(array_of(tangle, "u").rows, direct->u.points.size());
  EXPECT_EQ(array_of(tangle, "lobes.area").rows, direct->tangle.lobes.size());
  EXPECT_NEAR(doubles_of(moved, "turnstile.flux12")[0], std::fabs(direct->areas_by_action[0]), 1e-7);
  const std::size_t regions = array_of(moved, "regions.area").rows;
  EXPECT_EQ(array_of(moved, "steps.a_ij").rows, 2U);
  EXPECT_EQ(array_of(moved, "steps.a_ij").columns, 2 * regions * regions);
  const Result lobe = made([&](lober_result** to) { return lober_outline(tangle.get(), "lobes", 0, to); });
  EXPECT_GT(array_of(lobe, "points").rows, 10U);

  // The same curves, as arrays.
  const lober_array u = array_of(tangle, "u"), s = array_of(tangle, "s");
  const Result again = made([&](lober_result** to) {
    return lober_tangle(static_cast<const double*>(u.data), u.rows, static_cast<const double*>(s.data), s.rows,
                        "smooth=1 period=2", to);
  });
  EXPECT_EQ(array_of(again, "pips.x").rows, array_of(tangle, "pips.x").rows);
}

// A call that fails gives no result, the status of its exception, and a message with the words.
void expect_refusal(int status, const char* words, const std::function<int(lober_result**)>& call) {
  lober_result* result = reinterpret_cast<lober_result*>(&status);  // has to be overwritten
  EXPECT_EQ(call(&result), status) << words;
  EXPECT_EQ(result, nullptr) << words;
  EXPECT_NE(std::string(lober_message()).find(words), std::string::npos) << lober_message();
}

TEST(CInterface, RefusesWhatMakesNoSense) {
  const std::vector<double> good = circle_coordinates(0, 0, 1, 30);
  std::vector<double> bad = good;
  bad[7] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> eight{0, 0, 2, 2, 2, 0, 0, 2};
  const auto with = [&](const double* points, std::size_t n, const char* options) {
    return [=, &good](lober_result** to) { return lober_overlay(points, n, good.data(), 30, options, to); };
  };
  expect_refusal(LOBER_DATA_ERROR, "not finite", with(bad.data(), 30, nullptr));
  expect_refusal(LOBER_DATA_ERROR, "", with(good.data(), 2, nullptr));
  expect_refusal(LOBER_DATA_ERROR, "", with(eight.data(), 4, nullptr));
  expect_refusal(LOBER_USAGE_ERROR, "no points are given", with(nullptr, 30, nullptr));
  expect_refusal(LOBER_USAGE_ERROR,
                 "speed: there is no such option; there are areas_only, discretisation, index, check_simple",
                 with(good.data(), 30, "speed=1"));
  expect_refusal(LOBER_USAGE_ERROR, "NAME=VALUE", with(good.data(), 30, "areas_only"));
  expect_refusal(LOBER_USAGE_ERROR, "true or false, 1 or 0", with(good.data(), 30, "areas_only=yes"));
  expect_refusal(LOBER_USAGE_ERROR, "twice", with(good.data(), 30, "areas_only=1 areas_only=0"));
  expect_refusal(LOBER_USAGE_ERROR, "whole number", with(good.data(), 30, "threads=-1"));
  for (const char* const many : {"threads=4097", "threads=100000", "threads=1000000000"}) {
    expect_refusal(LOBER_USAGE_ERROR, "threads has to be a whole number from 0 to 4096", with(good.data(), 30, many));
  }
  expect_refusal(LOBER_USAGE_ERROR, "one of split, ends", [&](lober_result** to) {
    return lober_interior(good.data(), 30, good.data(), 30, "method=best", to);
  });
  expect_refusal(LOBER_DATA_ERROR, "nowhere.npy",
                 [&](lober_result** to) { return lober_read("nowhere.npy", nullptr, to); });
  expect_refusal(LOBER_USAGE_ERROR, "no model",
                 [&](lober_result** to) { return lober_grow(nullptr, "iterates=2", to); });
  const Model standard = model("standard");
  expect_refusal(LOBER_USAGE_ERROR, "iterates or length",
                 [&](lober_result** to) { return lober_grow(standard.get(), nullptr, to); });
  EXPECT_EQ(lober_overlay(good.data(), 30, good.data(), 30, nullptr, nullptr), LOBER_USAGE_ERROR);
  lober_model* none = nullptr;
  EXPECT_EQ(lober_model_open("nothing", nullptr, nullptr, &none), LOBER_USAGE_ERROR) << lober_message();
  EXPECT_EQ(lober_model_open("standard", "K=two", nullptr, &none), LOBER_USAGE_ERROR);
  EXPECT_EQ(none, nullptr);

  const Result result = made(with(good.data(), 30, nullptr));
  lober_array array{};
  EXPECT_EQ(lober_array_named(result.get(), "area", &array), LOBER_USAGE_ERROR);
  EXPECT_NE(std::string(lober_message()).find("areas.union"), std::string::npos);
  EXPECT_EQ(lober_array_at(result.get(), 1000, &array), LOBER_USAGE_ERROR);
  EXPECT_EQ(lober_array_at(nullptr, 0, &array), LOBER_USAGE_ERROR);
  EXPECT_TRUE(std::isnan(lober_number(result.get(), "crossings")));
  expect_refusal(LOBER_USAGE_ERROR, "outlines=1",
                 [&](lober_result** to) { return lober_outline(result.get(), "union", 0, to); });
  const Result kept = made(with(good.data(), 30, "outlines=1"));
  expect_refusal(LOBER_USAGE_ERROR, "there are 1, from 0",
                 [&](lober_result** to) { return lober_outline(kept.get(), "union", 7, to); });
  lober_result_free(nullptr);
  lober_model_free(nullptr);
}

TEST(CInterface, ProgressCancelsAndIsOfOneThread) {
  const std::vector<double> one = circle_coordinates(0, 0, 1, 3000), two = circle_coordinates(0.5, 0, 1, 3000);
  struct Count {
    int calls = 0, until = 1;
  } count;
  const auto function = [](double fraction, void* context) {
    auto* const seen = static_cast<Count*>(context);
    EXPECT_LE(fraction, 1);
    return ++seen->calls < seen->until ? 1 : 0;
  };
  const auto overlay_of = [&](lober_result** to) {
    return lober_overlay(one.data(), 3000, two.data(), 3000, nullptr, to);
  };
  lober_set_progress(function, &count);
  expect_refusal(LOBER_CANCELLED, "cancelled", overlay_of);
  EXPECT_EQ(count.calls, 1);
  std::thread([&] { EXPECT_TRUE(made(overlay_of)); }).join();
  EXPECT_EQ(count.calls, 1);
  count = {0, 1000};
  EXPECT_TRUE(made(overlay_of));
  EXPECT_GT(count.calls, 1);
  lober_set_progress(nullptr, nullptr);
  count = {0, 1};
  EXPECT_TRUE(made(overlay_of));
  EXPECT_EQ(count.calls, 0);
}

}  // namespace
}  // namespace lober
