// The version of lober.
//
// The headers in this folder are the interface; parts that they call private, and the layout of classes, may change
// with any version. Until 1.0 a new minor version may change the interface, and says so in CHANGELOG.md; shared
// libraries of different minor versions have different names.
#pragma once

#include "lober/base/export.hpp"

/// Major version of the headers.
#define LOBER_VERSION_MAJOR 0
/// Minor version of the headers.
#define LOBER_VERSION_MINOR 2
/// Patch version of the headers.
#define LOBER_VERSION_PATCH 0

namespace lober {

/// The version of the linked library: "0.2.0". The macros are those of the headers.
[[nodiscard]] LOBER_API const char* version() noexcept;

}  // namespace lober
