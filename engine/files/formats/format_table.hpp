// All formats of curve files, in one table. A new one is a file beside this and a row in format_table.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/output_file.hpp"
#include "engine/files/formats/optional_library.hpp"
#include "engine/files/formats/readers.hpp"

namespace lober::detail {

struct FormatEntry {
  Format format;
  std::string_view name, meaning;
  std::string_view suffixes;                    ///< separated by blanks; the first is the usual one
  bool (*begins)(std::span<const std::byte>);   ///< whether a file is of this format; null: the rest
  void (*read)(const FileSource&, CurveFile&);  ///< null: not read
  void (*write)(OutputFile&, std::span<const Zone>, const WriteOptions&);  ///< null: not written
  bool holds_several;                                                      ///< curves
  bool has_columns;                                                        ///< or arrays, which can be chosen
  const OptionalLibrary* library;                                          ///< null: none is needed
};

[[nodiscard]] std::span<const FormatEntry> format_table();
[[nodiscard]] const FormatEntry& entry_of(Format format);
/// The usual endings of formats in which curves are written, perhaps those alone that hold several: ".npy, .csv, .txt,
/// .dat (tecplot), ...".
[[nodiscard]] std::string written_endings(bool of_several = false);

/// The format of a file, by its content: by its first bytes, for some by more.
[[nodiscard]] const FormatEntry& recognised(std::span<const std::byte> bytes);

}  // namespace lober::detail
