// Pages that show results: one file each, which opens from disk without a network.
#pragma once

#include <string>

#include "viewer/scene.hpp"

namespace lober::viewer {

/// Bytes that exact points may take in a page, so that it can be sent by mail, and opens within two seconds. Where they
/// would take more, points away from crossings are rounded to 2^-50 of the size of their curve, which spares the bytes
/// of digits that no picture of the whole curve can show.
inline constexpr std::size_t max_exact_size = 12'000'000;

/// The page of a scene, as HTML. Texts of the scene stay texts, whatever is in them. Throws DataError for coordinates
/// that are not finite. O(N), parallel; about 5 bytes a point, as written, of curves that were grown.
[[nodiscard]] std::string page_of(const Scene& scene);

/// Writes the page to a file, which appears when it is complete.
void write_page(const std::string& path, const Scene& scene);

/// The page of a batch: `json` is the object that viewer/page/batch.js reads.
[[nodiscard]] std::string batch_page_of(const std::string& title, std::string_view json);

}  // namespace lober::viewer
