// Pages that show results: one file each, which opens from disk without a network.
#pragma once

#include <string>

#include "viewer/scene.hpp"

namespace lober::viewer {

/// Scenes of at most this number of points keep each of them exactly. In larger ones points away from crossings are
/// rounded to 2^-50 of the size of their curve.
inline constexpr std::size_t max_exact_points = 500'000;

/// The page of a scene, as HTML. Texts of the scene stay texts, whatever is in them. Throws DataError for coordinates
/// that are not finite. O(N), parallel; about 6 bytes a point of curves that were grown.
[[nodiscard]] std::string page_of(const Scene& scene);

/// Writes the page to a file, which appears when it is complete.
void write_page(const std::string& path, const Scene& scene);

/// The page of a batch: `json` is the object that viewer/page/batch.js reads.
[[nodiscard]] std::string batch_page_of(const std::string& title, std::string_view json);

}  // namespace lober::viewer
