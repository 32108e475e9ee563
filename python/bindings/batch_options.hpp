// The options of batches, for batches of this process and for those that other processes compute.
#pragma once

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>

#include "engine/batch/batch.hpp"
#include "lober/batch.hpp"
#include "python/bindings/keywords.hpp"

namespace lober::python {

/// A text is the manifest itself; `path` then names it in messages, and names of files are relative to its folder.
[[nodiscard]] inline lober::detail::Manifest manifest_of(const std::string& path,
                                                         const std::optional<std::string>& text) {
  return text ? lober::detail::parse_manifest(*text, path) : lober::detail::read_manifest(path);
}

[[nodiscard]] inline BatchOptions batch_options(const pybind11::kwargs& given) {
  BatchOptions options;
  Keywords(given)
      .take("store", options.store)
      .take_as<std::pair<std::size_t, std::size_t>>("shard",
                                                    [&](const auto& of) {
                                                      options.shard = {of.first, of.second};
                                                    })
      .take("memory", options.queue.memory)
      .take("threads", options.queue.threads)
      .take("output_root", options.output_root)
      .end();
  return options;
}

}  // namespace lober::python
