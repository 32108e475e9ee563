#include "engine/files/formats/hdf5_library.hpp"

#if LOBER_HAS_HDF5
#include <algorithm>
#include <array>
#include <string_view>

namespace lober::detail {
namespace {

// Texts of one length, each of which ends at its first zero.
std::vector<std::string> split_texts(std::string_view all, std::size_t width) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at + width <= all.size(); at += width) {
    std::string_view one = all.substr(at, width);
    one = one.substr(0, one.find('\0'));
    while (!one.empty() && one.back() == ' ') one.remove_suffix(1);
    texts.emplace_back(one);
  }
  return texts;
}

}  // namespace

std::vector<double> numbers_of_attribute(hid_t object, const char* name) {
  constexpr hssize_t max_heeded = 64;
  if (hdf5().H5Aexists(object, name) <= 0) return {};
  const Handle found(hdf5().H5Aopen(object, name, H5P_DEFAULT), hdf5().H5Aclose);
  if (!found.is_open()) return {};
  const Handle type(hdf5().H5Aget_type(found.id()), hdf5().H5Tclose);
  const Handle space(hdf5().H5Aget_space(found.id()), hdf5().H5Sclose);
  const H5T_class_t kind = hdf5().H5Tget_class(type.id());
  const hssize_t count = hdf5().H5Sget_simple_extent_npoints(space.id());
  if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || count < 1 || count > max_heeded) return {};
  std::vector<double> values(static_cast<std::size_t>(count));
  if (hdf5().H5Aread(found.id(), hdf5().native_double, values.data()) < 0) return {};
  return values;
}

std::string text_of_attribute(hid_t object, const char* name) {
  constexpr std::size_t max_length = 4096;
  if (hdf5().H5Aexists(object, name) <= 0) return {};
  const Handle found(hdf5().H5Aopen(object, name, H5P_DEFAULT), hdf5().H5Aclose);
  if (!found.is_open()) return {};
  const Handle type(hdf5().H5Aget_type(found.id()), hdf5().H5Tclose);
  const Handle space(hdf5().H5Aget_space(found.id()), hdf5().H5Sclose);
  if (hdf5().H5Tget_class(type.id()) != H5T_STRING || hdf5().H5Sget_simple_extent_npoints(space.id()) != 1) return {};
  if (hdf5().H5Tis_variable_str(type.id()) > 0) {
    char* text = nullptr;
    if (hdf5().H5Aread(found.id(), type.id(), static_cast<void*>(&text)) < 0 || text == nullptr) return {};
    std::string copy = text;
    hdf5().H5free_memory(text);
    return copy;
  }
  std::string text(hdf5().H5Tget_size(type.id()), '\0');
  if (text.empty() || text.size() > max_length || hdf5().H5Aread(found.id(), type.id(), text.data()) < 0) return {};
  return split_texts(text, text.size())[0];
}

std::vector<std::string> texts_of_dataset(hid_t set) {
  constexpr std::size_t max_texts = std::size_t{1} << 22, max_bytes = std::size_t{1} << 28;
  const Handle type(hdf5().H5Dget_type(set), hdf5().H5Tclose);
  const Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
  const std::optional<std::vector<std::size_t>> shape = shape_of_dataset(set);
  if (!shape || hdf5().H5Tget_class(type.id()) != H5T_STRING) return {};
  const hssize_t points = hdf5().H5Sget_simple_extent_npoints(space.id());
  if (points < 1 || static_cast<std::size_t>(points) > max_bytes) return {};
  const auto count = static_cast<std::size_t>(points);
  if (hdf5().H5Tis_variable_str(type.id()) > 0) {
    if (count > max_texts) return {};
    std::vector<char*> all(count, nullptr);
    std::vector<std::string> texts;
    if (hdf5().H5Dread(set, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<void*>(all.data())) < 0) return {};
    for (const char* one : all) texts.emplace_back(one == nullptr ? "" : one);
    hdf5().H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, static_cast<void*>(all.data()));
    return texts;
  }
  const std::size_t size = hdf5().H5Tget_size(type.id());
  if (size == 0 || size > max_bytes / count) return {};
  std::string all(size * count, '\0');
  if (hdf5().H5Dread(set, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0) return {};
  const bool are_characters = size == 1 && shape->size() == 2 && (*shape)[1] > 0;
  return split_texts(all, are_characters ? (*shape)[1] : size);
}

std::optional<std::vector<std::size_t>> shape_of_dataset(hid_t set) {
  const Handle space(hdf5().H5Dget_space(set), hdf5().H5Sclose);
  if (!space.is_open() || hdf5().H5Sget_simple_extent_type(space.id()) == H5S_NULL) return std::nullopt;
  const int axes = hdf5().H5Sget_simple_extent_ndims(space.id());
  if (axes < 0) return std::nullopt;
  std::array<hsize_t, H5S_MAX_RANK> sizes{};
  hdf5().H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr);
  return std::vector<std::size_t>(sizes.begin(), sizes.begin() + axes);
}

}  // namespace lober::detail
#endif
