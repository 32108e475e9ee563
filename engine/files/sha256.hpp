// For the tests: the portable code, which the tests would not reach on a machine with SHA instructions.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lober {

[[nodiscard]] std::string sha256_portable(std::span<const std::byte> bytes);

}  // namespace lober
