// Curves of files, for C.
#include "lober/curve/files.hpp"

#include "engine/c/call.hpp"
#include "lober/base/error.hpp"
#include "lober/base/version.hpp"
#include "lober/curve/formats.hpp"

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
    const std::span<const lober::Point> given = points_of(points, n, "curve");
    const lober::Zone zone{{}, {given.begin(), given.end()}, 1};
    const bool has_format = lober::format_of_name(path).has_value();
    lober::WriteOptions options{.provenance = {{"lober", std::string(lober::version())}}};
    if (!has_format) options.format = lober::Format::text;
    lober::write_curves(path, {&zone, 1}, options);
  });
}
