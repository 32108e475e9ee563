// The legend of a picture: samples with texts, in as many columns as there is room for.
#pragma once

#include <string>
#include <vector>

#include "cli/picture/figure.hpp"

namespace lober::cli {

class Legend {
 public:
  /// The texts of the layers and notes of a figure, each once, for this width in points of print; of layers that have
  /// something in `window`, or all. Borrows the figure.
  Legend(const Figure& figure, double width, const Rectangle* window);

  [[nodiscard]] double height() const;  ///< 0 where there is nothing to say
  /// Appends it with its upper left corner at (x, y).
  void draw(std::string& svg, double x, double y) const;

 private:
  struct Entry {
    const Layer* layer = nullptr;  // null: a note
    std::vector<std::string> lines{};
    std::string whole{};  // the text, where the lines leave a part of it out
  };
  struct Position {
    std::size_t row;
    double x;
  };
  std::vector<Entry> entries_;
  std::vector<Position> positions_;  // where each entry is
  std::vector<double> row_tops_;     // and one past the last
};

/// A dot of a layer about (x, y), all lengths times `scale`.
void add_dot(std::string& svg, const Layer& layer, double x, double y, double scale);

}  // namespace lober::cli
