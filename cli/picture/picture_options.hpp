// The options of pictures, the same for all commands that draw, and the files that they ask for.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/picture/figure.hpp"
#include "cli/picture/figure_svg.hpp"
#include "cli/program/command_line.hpp"

namespace lober::cli {

struct PictureRequest {
  std::string file, data;
  std::optional<std::string> title{};
  std::vector<double> window, inset, size;
  bool no_legend = false, no_title = false, labels = false, no_labels = false;

  [[nodiscard]] bool asked() const { return !file.empty() || !data.empty(); }
  /// The files, for check_outputs; throws UsageError for options that contradict themselves.
  [[nodiscard]] std::vector<Output> outputs() const;
  [[nodiscard]] FigureStyle style() const;
  /// Throws UsageError for an inset that is not a part of --window or, without one, of what the picture will show: for
  /// commands that know that before they compute.
  void require_inset_in(const Rectangle& shown) const;
  /// Whether to name this number of lobes: up to 30 of them, unless --labels or --no-labels says otherwise.
  [[nodiscard]] bool labels_for(std::size_t count) const;
};

/// Adds --picture FILE (or --svg, its old name), --data, --window, --size, --inset, --title, --no-title and
/// --no-legend; with `named_things`
/// ("fixed points, pips and lobes") --labels and --no-labels too. `what` completes "Draw ... in FILE". Returns the
/// option of the picture. `names`: those of --picture.
Option add_picture_options(OptionParser& parser, PictureRequest& request, const std::string& what,
                           const std::string& named_things = {}, const char* names = "--picture,--svg");

/// A second picture of a command, in the same style: another name for --picture. `names`: "--tubes".
Option add_further_picture(OptionParser& parser, const char* names, std::string& file, const std::string& what);

/// Writes a picture in the format of its ending, .svg, .pdf or .png (400 pixels an inch); SVG without one. Throws
/// DataError where the file cannot be written, or a library that converts it is missing.
void write_figure(const std::string& path, const Figure& figure, const FigureStyle& style);
/// Writes the files of the request. An inset that is not a part of the window leaves the picture out, and is the error
/// (keep_error) with which the run ends after everything else is written.
void write_figure(const PictureRequest& request, const Figure& figure);

}  // namespace lober::cli
