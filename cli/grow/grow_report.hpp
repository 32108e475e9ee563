// The work of `lober grow` in words.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "cli/picture/picture_options.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

/// Whether growing went as far as the options ask, and how it ended.
[[nodiscard]] bool ends_as_asked(const GrownManifold& manifold);
[[nodiscard]] std::string end_of_growth(const GrownManifold& manifold);

/// A few lines for people.
[[nodiscard]] std::string grow_summary(const System& system, const operations::SystemManifold& manifold);
/// The picture of the manifold, which has to outlive it. `box`: where the tolerance holds; empty: everywhere.
[[nodiscard]] Figure grow_figure(const System& system, const operations::SystemManifold& manifold, const Rectangle& box,
                                 const PictureRequest& how);

}  // namespace lober::cli
