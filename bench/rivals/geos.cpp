// GEOS through its C interface, which since 3.9 runs the OverlayNG code.
#include <geos_c.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "bench/rivals/rival.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) { GEOSContext_setErrorMessageHandler_r(handle_, &keep_message, &message_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(handle_); }

  struct Destroy {
    GEOSContextHandle_t handle;
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle, geometry); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

  [[nodiscard]] Geometry owned(GEOSGeometry* geometry) const { return {geometry, Destroy{handle_}}; }

  [[nodiscard]] Geometry polygon(std::span<const Point> points) const {
    std::vector<Point> ring(points.begin(), points.end());
    ring.push_back(points.front());
    GEOSCoordSequence* sequence =
        GEOSCoordSeq_copyFromBuffer_r(handle_, &ring.front().x, static_cast<unsigned>(ring.size()), 0, 0);
    return owned(GEOSGeom_createPolygon_r(handle_, GEOSGeom_createLinearRing_r(handle_, sequence), nullptr, 0));
  }

  // Pieces of no area, points and lines, are what overlays of touching curves also return; they are not
  // counted.
  void measure(const GEOSGeometry* geometry, double& area, std::size_t& pieces) const {
    const int count = GEOSGetNumGeometries_r(handle_, geometry);
    for (int k = 0; k < count; ++k) {
      double piece = 0;
      GEOSArea_r(handle_, GEOSGetGeometryN_r(handle_, geometry, k), &piece);
      area += piece;
      pieces += piece > 0;
    }
  }

  [[nodiscard]] GEOSContextHandle_t handle() const { return handle_; }
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  static void keep_message(const char* text, void* message) { *static_cast<std::string*>(message) = text; }

  GEOSContextHandle_t handle_;
  std::string message_;
};

}  // namespace

RivalResult run_geos(std::span<const Point> first, std::span<const Point> second) {
  const Geos geos;
  const Geos::Geometry a = geos.polygon(first);
  const Geos::Geometry b = geos.polygon(second);
  RivalResult result;
  const Stopwatch all;
  Geos::Geometry overlays[4] = {geos.owned(GEOSDifference_r(geos.handle(), a.get(), b.get())),
                                geos.owned(GEOSDifference_r(geos.handle(), b.get(), a.get())), geos.owned(nullptr),
                                geos.owned(nullptr)};
  const Stopwatch intersection;
  overlays[2] = geos.owned(GEOSIntersection_r(geos.handle(), a.get(), b.get()));
  result.intersection_seconds = intersection.seconds();
  overlays[3] = geos.owned(GEOSUnion_r(geos.handle(), a.get(), b.get()));
  result.seconds = all.seconds();
  for (std::size_t k = 0; k < 4; ++k) {
    if (!overlays[k]) {
      result.note = geos.message();
      return result;
    }
    geos.measure(overlays[k].get(), result.areas[k], result.pieces[k]);
  }
  result.ran = true;
  return result;
}

}  // namespace lober::bench
