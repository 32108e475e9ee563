// The libraries of others that read and write formats of files, by the names that CMake found (libraries.cmake).
#pragma once

#include "engine/files/formats/optional_library.hpp"

namespace lober::detail {

inline constexpr OptionalLibrary zlib_library(LOBER_ZLIB_FILE, "zlib1g", "zlib1g-dev");
inline constexpr OptionalLibrary zip_library(LOBER_ZIP_FILE, "libzip4", "libzip-dev");
inline constexpr OptionalLibrary hdf5_library(LOBER_HDF5_FILE, "libhdf5-103-1", "libhdf5-dev");
inline constexpr OptionalLibrary matio_library(LOBER_MATIO_FILE, "libmatio11", "libmatio-dev");
inline constexpr OptionalLibrary shapelib_library(LOBER_SHAPELIB_FILE, "libshp2", "libshp-dev");

}  // namespace lober::detail
