// Something of each library, and what crosses the border of a shared one: exceptions both ways, a class derived from
// one of the library's, a callback.
#include <cstdio>
#include <cstdlib>
#include <lober/batch.hpp>
#include <lober/curve.hpp>
#include <lober/dynamics.hpp>
#include <lober/lober.hpp>
#include <lober/overlay.hpp>
#include <stdexcept>

namespace {

// (x, y) -> (2 x, y / 2), with a saddle at the origin.
class Stretching : public lober::PlanarMap {
 public:
  void iterate(std::span<lober::Point> points, int iterates) const override {
    for (lober::Point& point : points) {
      for (int step = 0; step < std::abs(iterates); ++step) {
        point = iterates > 0 ? lober::Point{2 * point.x, point.y / 2} : lober::Point{point.x / 2, 2 * point.y};
      }
    }
  }
  lober::Point iterate_with_derivative(lober::Point point, int iterates, lober::Matrix2& derivative) const override {
    lober::Point unit{1, 1};
    iterate({&unit, 1}, iterates);
    derivative = {unit.x, 0, 0, unit.y};
    iterate({&point, 1}, iterates);
    return point;
  }
};

int failures = 0;

void expect(bool right, const char* what) {
  if (right) return;
  std::printf("wrong: %s\n", what);
  ++failures;
}

template <typename Exception, typename Function>
void expect_throw(const Function& function, const char* what) {
  try {
    function();
  } catch (const Exception&) {
    return;
  } catch (const std::exception& other) {
    std::printf("%s: another exception, %s\n", what, other.what());
  }
  expect(false, what);
}

}  // namespace

int main() {
  const lober::ClosedCurve square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, bow_tie{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  expect_throw<lober::NotSimpleError>([&] { (void)lober::overlay(square, bow_tie); }, "geometry throws NotSimpleError");
  expect_throw<lober::Cancelled>(
      [&] {
        lober::OverlayOptions options;
        options.progress = [](double) { return false; };
        (void)lober::overlay(square, square, options);
      },
      "a callback cancels");
  expect_throw<std::domain_error>([] { lober::run_with_threads(2, [] { throw std::domain_error("of the caller"); }); },
                                  "base passes an exception on");
  expect_throw<lober::DataError>([] { (void)lober::read_curve("no such file", true); }, "files throws DataError");
  expect_throw<lober::UsageError>([] { (void)lober::make_system("no such system"); }, "dynamics throws UsageError");
  expect_throw<lober::UsageError>([] { (void)lober::export_format("results.pdf"); }, "batch throws UsageError");

  const lober::FixedPoint saddle = lober::find_fixed_point(Stretching(), {0.1, 0.1});
  expect(saddle.kind == lober::FixedPointKind::saddle && saddle.at == lober::Point{0, 0}, "the fixed point of our map");
  const lober::System henon = lober::make_system("henon");
  expect(henon.map && !henon.flow, "the Henon map");
  expect(lober::export_format("results.csv") == lober::ExportFormat::csv, "the format of an export");
  std::printf("lober %s, %d failures\n", lober::version(), failures);
  return failures;
}
