// Files compressed by gzip.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lober/base/buffer.hpp"

namespace lober::detail {

[[nodiscard]] bool is_gzip(std::span<const std::byte> bytes);

/// The content of `bytes`, one or more members of gzip (RFC 1952). At most a quarter of the machine's memory: a file of
/// a few bytes can promise any size. Throws DataError "name: ..." for a file that is damaged or cut off, and where zlib
/// is not there.
[[nodiscard]] Buffer<std::byte> unzipped(const std::string& name, std::span<const std::byte> bytes);

/// The first `max_size` bytes of what is compressed in the form of zlib (RFC 1950), fewer where it ends before; nothing
/// where zlib is not there. Throws DataError with a reason for bytes that are damaged or cut off.
[[nodiscard]] std::optional<Buffer<std::byte>> inflated(std::span<const std::byte> bytes, std::size_t max_size);

/// The bytes compressed, in the form of zlib (RFC 1950); nothing where zlib is not there.
[[nodiscard]] std::optional<std::string> deflated(std::string_view bytes);

}  // namespace lober::detail
