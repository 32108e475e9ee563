// How the formats with a signature are known by their first bytes.
#pragma once

#include <cstddef>
#include <span>

namespace lober::detail {

[[nodiscard]] bool begins_npy(std::span<const std::byte> bytes);
/// A zip archive whose first member is an NPY file; others are no curves.
[[nodiscard]] bool begins_npz(std::span<const std::byte> bytes);
[[nodiscard]] bool begins_mat(std::span<const std::byte> bytes);
/// At the beginning, or behind a block of the user's.
[[nodiscard]] bool begins_hdf5(std::span<const std::byte> bytes);
[[nodiscard]] bool begins_netcdf(std::span<const std::byte> bytes);
[[nodiscard]] bool begins_shapefile(std::span<const std::byte> bytes);
/// Text that is JSON or, perhaps behind comments, begins with a geometry in WKT.
[[nodiscard]] bool begins_json(std::span<const std::byte> bytes);
[[nodiscard]] bool begins_wkt(std::span<const std::byte> bytes);

}  // namespace lober::detail
