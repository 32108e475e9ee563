#include <array>

#include "viewer/palette.hpp"
#include "viewer/scenes/scenes.hpp"

namespace lober::viewer {

Scene curves_scene(std::span<const Line> curves) {
  constexpr std::array colours{palette::unstable, palette::stable, palette::entering,        palette::leaving,
                               palette::flux,     palette::common, palette::left_of_unstable};
  Scene scene;
  scene.title = curves.size() == 1 ? curves.front().name : std::to_string(curves.size()) + " curves";
  // Each curve can be switched off by itself, unless the list would be too long to be of use.
  constexpr std::size_t max_layers = 24;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (k < max_layers) {
      Layer layer;
      layer.colour = colours[k % colours.size()];
      layer.name = curves[k].name;
      scene.layers.push_back(layer);
    } else if (k == max_layers) {
      scene.layers.back().name = std::to_string(curves.size() - max_layers + 1) + " other curves";
    }
    scene.layers.back().lines.push_back(curves[k]);
  }
  return scene;
}

}  // namespace lober::viewer
