// Whether MAT files are whole: matio believes any length, and reads behind the end what memory holds.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lober::detail {

/// Throw DataError "path: ..." where a variable of a file of version 4, or of versions 5 to 7, ends behind the file.
void require_sound_version4(std::span<const std::byte> bytes, const std::string& path);
void require_sound_version5(std::span<const std::byte> bytes, const std::string& path);

}  // namespace lober::detail
