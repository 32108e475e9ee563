// Order of crossings along a segment, and their exact parameters, against GMP rationals.
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "kernels/predicates.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

mpq_class exact_cross(Point a, Point b, Point c, Point d) {
  return (mpq_class(b.x) - mpq_class(a.x)) * (mpq_class(d.y) - mpq_class(c.y)) -
         (mpq_class(b.y) - mpq_class(a.y)) * (mpq_class(d.x) - mpq_class(c.x));
}

mpq_class exact_parameter_of(Point a, Point b, const ImplicitPoint& p) {
  if (!p.vertex) return exact_cross(a, p.c, p.c, p.d) / exact_cross(a, b, p.c, p.d);
  if (a.x != b.x) return (mpq_class(p.c.x) - mpq_class(a.x)) / (mpq_class(b.x) - mpq_class(a.x));
  return (mpq_class(p.c.y) - mpq_class(a.y)) / (mpq_class(b.y) - mpq_class(a.y));
}

bool cross_properly(Point a, Point b, Point c, Point d) {
  return exact_orientation(a, b, c) * exact_orientation(a, b, d) < 0 &&
         exact_orientation(c, d, a) * exact_orientation(c, d, b) < 0;
}

struct AlongScene {
  Point a, b;
  ImplicitPoint p, q;
};

// Two segments that cross a b in nearly the same place.
std::optional<AlongScene> nearly_equal(Random& random) {
  AlongScene scene;
  scene.a = {random.uniform(-1, 1), random.uniform(-1, 1)};
  scene.b = {random.uniform(-1, 1), random.uniform(-1, 1)};
  const double t = random.unit();
  const Point middle{scene.a.x + t * (scene.b.x - scene.a.x), scene.a.y + t * (scene.b.y - scene.a.y)};
  const auto through = [&] {
    const double dx = random.uniform(-1, 1), dy = random.uniform(-1, 1);
    const Point centre = neighbour(random, middle, 1);
    return ImplicitPoint{{centre.x - dx, centre.y - dy}, {centre.x + dx, centre.y + dy}};
  };
  scene.p = through();
  scene.q = random.chance(0.1) ? ImplicitPoint{scene.p.d, scene.p.c} : through();
  return scene;
}

// Small integers: equal parameters are common, and so are vertices on the segment.
std::optional<AlongScene> lattice_scene(Random& random) {
  const auto point = [&] {
    return Point{static_cast<double>(random.integer(-5, 5)), static_cast<double>(random.integer(-5, 5))};
  };
  AlongScene scene{point(), point(), {point(), point()}, {point(), point()}};
  if (scene.a == scene.b) return std::nullopt;
  for (ImplicitPoint* implicit : {&scene.p, &scene.q}) {
    PredicateCounts counts;
    implicit->vertex = on_segment(scene.a, scene.b, implicit->c, counts);
  }
  return scene;
}

// Every exponent that doubles have.
std::optional<AlongScene> any_scale(Random& random) {
  const int scale = random.integer(-1070, 1020);
  const auto value = [&] { return with_exponent(random, std::max(scale - 40, -1074), std::min(scale + 3, 1022)); };
  const auto point = [&] { return Point{value(), value()}; };
  return AlongScene{point(), point(), {point(), point()}, {point(), point()}};
}

bool valid(const AlongScene& scene) {
  const auto meets = [&](const ImplicitPoint& p) { return p.vertex || cross_properly(scene.a, scene.b, p.c, p.d); };
  return meets(scene.p) && meets(scene.q);
}

struct AlongKind {
  const char* name;
  std::optional<AlongScene> (*make)(Random&);
  int tries;
  bool ties;
};
constexpr std::array along_kinds = {AlongKind{"nearly_equal", nearly_equal, 20000, true},
                                    AlongKind{"lattice", lattice_scene, 150000, true},
                                    AlongKind{"any_scale", any_scale, 60000, false}};

class CompareAlong : public ::testing::TestWithParam<AlongKind> {};

TEST_P(CompareAlong, EqualsTheOrderOfExactParameters) {
  Random random(seed());
  int tested = 0, equal = 0;
  for (int k = 0; k < GetParam().tries; ++k) {
    const std::optional<AlongScene> made = GetParam().make(random);
    if (!made || !valid(*made)) continue;
    const auto& [a, b, p, q] = *made;
    const mpq_class t_p = exact_parameter_of(a, b, p), t_q = exact_parameter_of(a, b, q);
    const int expected = sgn(mpq_class(t_p - t_q));
    ASSERT_EQ(compare_along(a, b, p, q), expected) << "try " << k;
    ASSERT_EQ(compare_along(a, b, q, p), -expected) << "try " << k;
    ASSERT_EQ(compare_along(b, a, p, q), -expected) << "the other way along, try " << k;
    ++tested;
    equal += expected == 0 ? 1 : 0;

    const DD t = exact_parameter(a, b, p);
    if (t_p == 0) {
      ASSERT_EQ(t.hi, 0) << "try " << k;
    } else if (t.hi > 0x1p-900) {  // or its low part underflows
      ASSERT_TRUE(within(mpq_class(t.hi) + mpq_class(t.lo), t_p, -96, t_p)) << "try " << k;
    }
  }
  EXPECT_GT(tested, GetParam().tries / 100);
  if (GetParam().ties) {
    EXPECT_GT(equal, 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CompareAlong, ::testing::ValuesIn(along_kinds),
                         [](const auto& kind) { return kind.param.name; });

TEST(ExactParameter, SurvivesSegmentsOfEverySize) {
  const Point a{0, 0}, b{0x1p1000, 0};
  const ImplicitPoint far{{0x1p999, 0}, {0x1p999, 0}, true};
  EXPECT_EQ(exact_parameter(a, b, far).hi, 0.5);
  const Point small{0x1p-1070, 0};
  const ImplicitPoint middle{{0x1p-1071, 0}, {0x1p-1071, 0}, true};
  EXPECT_EQ(exact_parameter(a, small, middle).hi, 0.5);
}

}  // namespace
}  // namespace lober::test
