#include "cli/doctor/optional_parts.hpp"

#include <filesystem>

#include "cli/picture/conversion.hpp"
#include "lober/curve/formats.hpp"

namespace lober::cli {
std::vector<OptionalPart> optional_parts() {
  std::vector<OptionalPart> parts;
  for (const FormatInfo& format : formats()) {
    if (!format.library.empty())
      parts.push_back({std::string(format.name), format.missing.empty(), std::string(format.library)});
  }
  parts.push_back({"PDF and PNG pictures", reason_no_conversion().empty(), "librsvg2-2"});
  return parts;
}

}  // namespace lober::cli
