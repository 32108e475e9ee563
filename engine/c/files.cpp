// Curves of files, for C.
#include "lober/curve/files.hpp"

#include "engine/c/call.hpp"
#include "lober/base/error.hpp"

int lober_read(const char* spec, const char* options, lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) -> std::function<void(lober_result&)> {
    if (!spec) throw lober::UsageError("no file is given");
    const bool closed = given.flag("closed", true);
    return [=](lober_result& made) {
      made.add_points("points", lober::read_curve(spec, closed, {.hash = false}).curve.points);
    };
  });
}

int lober_write(const char* path, const double* points, size_t n) {
  using namespace lober::detail::c;
  return guarded([&] {
    if (!path) throw lober::UsageError("no file is given");
    const std::string_view name(path);
    const std::span<const lober::Point> given = points_of(points, n, "curve");
    if (name.ends_with(".npy")) return lober::write_npy(path, given);
    if (name.ends_with(".raw") || name.ends_with(".f64")) return lober::write_raw(path, given);
    lober::write_text(path, given, name.ends_with(".csv") ? ',' : ' ');
  });
}
