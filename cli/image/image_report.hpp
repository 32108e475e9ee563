// Everything that `lober image` found, for the table, the JSON, the files and the picture to show.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lober/agreement.hpp"
#include "lober/files.hpp"
#include "lober/manifolds.hpp"
#include "lober/systems.hpp"

namespace lober::cli {

struct ImageReport {
  System system;
  IntegrationOptions integration;
  std::string curve;                ///< what it is, in words: "circle of radius 0.1 about (1, 0)"
  std::optional<NamedCurve> input;  ///< when it comes from a file
  bool closed = true;
  int first = 0, last = 0;  ///< as asked for
  ImageOptions options;
  /// In the order of iterates; of a cylinder's boundaries, which are two, first those of the one and then of the other.
  std::vector<CurveImage> images;
  std::vector<std::vector<ImagePart>> parts;  ///< of each
  std::vector<double> lengths;                ///< of each, all parts together
  /// Of each image of a closed curve that is whole and meets the tolerance everywhere: its signed area.
  std::vector<std::optional<double>> areas;
  bool preserves_area = false;  ///< the map has an action
  Agreement agreement;          ///< areas of the images with that of the curve
  double curve_seconds = 0, image_seconds = 0, write_seconds = 0;

  /// What a polygon may leave out of it: the tolerance times its length.
  [[nodiscard]] double area_error(std::size_t image) const { return options.tolerance * lengths[image]; }
  /// Of which curve an image is: 0, or 1 of the second boundary.
  [[nodiscard]] std::size_t curve_of(std::size_t image) const {
    return image / static_cast<std::size_t>(last - first + 1);
  }
};

/// "f^-2", of the second curve "f^-2 boundary 2".
[[nodiscard]] std::string image_name(int iterate, std::size_t curve = 0);
/// The short table for people.
[[nodiscard]] std::string image_table(const ImageReport& report);
/// Curves in one colour for pre-images, one for images.
/// `window`: the part of the plane that is drawn; without one all.
void write_image_picture(const std::string& path, const ImageReport& report, const std::optional<Rectangle>& window);
/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began.
void write_image_json(const std::string& path, const ImageReport& report,
                      const std::function<double()>& seconds_so_far);

/// Whether a name takes all images: Tecplot, a zone for each, or {n} in it, which becomes the iterate.
[[nodiscard]] bool takes_images(const std::string& path);
/// The name for an iterate of a curve, and a part of it from 1 on; part 0: whole.
[[nodiscard]] std::string image_path(const std::string& path, int iterate, std::size_t curve = 0, std::size_t part = 0);
/// Writes all images; the format is by the ending (output_names.hpp).
void write_images(const std::string& path, const ImageReport& report);

}  // namespace lober::cli
