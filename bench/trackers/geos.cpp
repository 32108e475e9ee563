// GEOS through its C interface, which since 3.9 runs the OverlayNG code.
#include <geos_c.h>

#include <memory>
#include <stdexcept>

#include "bench/trackers/rival_program.hpp"

namespace lober::bench {
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

  [[nodiscard]] Geometry geometry(const trust::Shape& shape) const {
    std::vector<GEOSGeometry*> polygons;
    for (const trust::PolygonRings& rings : shape) polygons.push_back(polygon(rings));
    if (polygons.size() == 1) return owned(polygons.front());
    return owned(GEOSGeom_createCollection_r(handle_, GEOS_MULTIPOLYGON, polygons.data(),
                                             static_cast<unsigned>(polygons.size())));
  }

  [[nodiscard]] std::string why_invalid(const Geometry& geometry) const {
    if (GEOSisValid_r(handle_, geometry.get()) == 1) return {};
    char* reason = GEOSisValidReason_r(handle_, geometry.get());
    std::string text = reason != nullptr ? reason : message_;
    GEOSFree_r(handle_, reason);
    return text;
  }

  // Lines and points, which overlays of touching polygons also return, have no area.
  [[nodiscard]] RivalOverlay measured(const Geometry& geometry) const {
    if (!geometry) return {0, false, message_};
    RivalOverlay result;
    GEOSArea_r(handle_, geometry.get(), &result.area);
    result.valid = GEOSisValid_r(handle_, geometry.get()) == 1;
    return result;
  }

  [[nodiscard]] GEOSContextHandle_t handle() const { return handle_; }

 private:
  [[nodiscard]] GEOSGeometry* ring(trust::Ring points) const {
    points.push_back(points.front());
    GEOSCoordSequence* sequence =
        GEOSCoordSeq_copyFromBuffer_r(handle_, &points.front().x, static_cast<unsigned>(points.size()), 0, 0);
    return GEOSGeom_createLinearRing_r(handle_, sequence);
  }

  [[nodiscard]] GEOSGeometry* polygon(const trust::PolygonRings& rings) const {
    std::vector<GEOSGeometry*> holes;
    for (std::size_t k = 1; k < rings.size(); ++k) holes.push_back(ring(rings[k]));
    return GEOSGeom_createPolygon_r(handle_, ring(rings.front()), holes.data(), static_cast<unsigned>(holes.size()));
  }

  static void keep_message(const char* text, void* message) { *static_cast<std::string*>(message) = text; }

  GEOSContextHandle_t handle_;
  std::string message_;
};

RivalAnswer geos_overlays(const trust::Shape& a, const trust::Shape& b) {
  const Geos geos;
  const Geos::Geometry first = geos.geometry(a), second = geos.geometry(b);
  RivalAnswer answer;
  answer.invalid_input = geos.why_invalid(first);
  if (answer.invalid_input.empty()) answer.invalid_input = geos.why_invalid(second);
  const auto overlay = [&](auto function, const Geos::Geometry& p, const Geos::Geometry& q) {
    return geos.measured(geos.owned(function(geos.handle(), p.get(), q.get())));
  };
  answer.overlays = {overlay(GEOSDifference_r, first, second), overlay(GEOSDifference_r, second, first),
                     overlay(GEOSIntersection_r, first, second), overlay(GEOSUnion_r, first, second)};
  return answer;
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  const std::string version = GEOSversion();
  return lober::bench::run_rival_program({arguments, static_cast<std::size_t>(count)},
                                         "GEOS " + version.substr(0, version.find('-')), lober::bench::geos_overlays,
                                         nullptr);
}
