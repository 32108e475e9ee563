// Everything that `lober image` found, for the table, the JSON, the files and the picture to show.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/picture/figure.hpp"
#include "cli/report/report.hpp"
#include "lober/curve/files.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct ImageReport {
  operations::SystemInput system;
  std::optional<NamedCurve> input;  ///< when it comes from a file
  operations::Outcome outcome;
  double write_seconds = 0;

  [[nodiscard]] const operations::CurveImages& found() const { return outcome.as<operations::CurveImages>(); }
  /// The curve in words.
  [[nodiscard]] std::string curve() const { return input ? spec_of(*input) : found().what; }
};

/// The short table for people.
[[nodiscard]] std::string image_table(const ImageReport& report);
/// Curves in one colour for pre-images, one for images.
/// Borrows them.
[[nodiscard]] Figure image_figure(const ImageReport& report);
/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began.
void write_image_json(const std::string& path, ImageReport& report, const std::function<double()>& seconds_so_far);

/// Whether a name takes all images: its format holds several curves, or {n} is in it, which becomes the iterate.
[[nodiscard]] bool takes_images(const std::string& path, const std::string& format);
/// The name for an iterate of a curve, and a part of it from 1 on; part 0: whole.
[[nodiscard]] std::string image_path(const std::string& path, int iterate, std::size_t curve = 0, std::size_t part = 0);
/// Writes all images; the format is by the ending (output_names.hpp).
void write_images(const std::string& path, const std::string& format, const ImageReport& report);

}  // namespace lober::cli
