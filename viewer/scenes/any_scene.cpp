#include "viewer/scenes/scenes.hpp"

namespace lober::viewer {

std::optional<Scene> scene_of(const operations::Operation& operation, const operations::Outcome& outcome) {
  const std::string& name = operation.name;
  if (name == "overlay") return overlay_scene(outcome.as<operations::CurveOverlay>());
  if (name == "regions") return regions_scene(outcome.as<operations::CurveRegions>(), {}, {});
  if (name == "tangle") return tangle_scene(outcome.as<operations::CurveTangle>());
  if (name == "manifold_tangle") return tangle_scene(outcome.as<operations::SystemTangle>());
  if (name == "transport") return transport_scene(outcome.as<operations::SystemTransport>());
  if (name == "escape") return escape_scene(outcome.as<operations::SystemEscape>());
  return std::nullopt;
}

}  // namespace lober::viewer
