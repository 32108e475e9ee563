#include <mutex>

#include "engine/files/formats/hdf5_library.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/table_file.hpp"

namespace lober {
using namespace detail;

#if LOBER_HAS_HDF5
namespace {

struct Hdf5Writing {
  LOBER_LOADED(hdf5_library, H5Fcreate);
  LOBER_LOADED(hdf5_library, H5Fflush);
  LOBER_LOADED(hdf5_library, H5Fget_file_image);
  LOBER_LOADED(hdf5_library, H5Screate);
  LOBER_LOADED(hdf5_library, H5Screate_simple);
  LOBER_LOADED(hdf5_library, H5Tcopy);
  LOBER_LOADED(hdf5_library, H5Tset_size);
  LOBER_LOADED(hdf5_library, H5Tset_cset);
  LOBER_LOADED(hdf5_library, H5Tset_strpad);
  LOBER_LOADED(hdf5_library, H5Pset_obj_track_times);
  LOBER_LOADED(hdf5_library, H5Dcreate2);
  LOBER_LOADED(hdf5_library, H5Dwrite);
  LOBER_LOADED(hdf5_library, H5Acreate2);
  LOBER_LOADED(hdf5_library, H5Awrite);
  hid_t dataset_creation, characters;

  Hdf5Writing() {
    (void)hdf5();  // whose identifiers have their values behind H5open
    dataset_creation = *static_cast<const hid_t*>(hdf5_library.symbol("H5P_CLS_DATASET_CREATE_ID_g"));
    characters = *static_cast<const hid_t*>(hdf5_library.symbol("H5T_C_S1_g"));
  }
};

const Hdf5Writing& writing() {
  static const Hdf5Writing loaded;
  return loaded;
}

void require(bool done) {
  if (!done) throw DataError("the HDF5 library cannot write the table");
}

Handle checked(hid_t id, herr_t (*close)(hid_t)) {
  require(id >= 0);
  return {id, close};
}

hid_t text_type_id(std::size_t width) {
  const hid_t type = writing().H5Tcopy(writing().characters);
  require(type >= 0 && writing().H5Tset_size(type, width) >= 0 && writing().H5Tset_cset(type, H5T_CSET_UTF8) >= 0 &&
          writing().H5Tset_strpad(type, H5T_STR_NULLPAD) >= 0);
  return type;
}

void write_attribute(hid_t file, const std::string& name, const std::string& text) {
  if (text.empty()) return;
  const Handle type(text_type_id(text.size()), hdf5().H5Tclose);
  const Handle space = checked(writing().H5Screate(H5S_SCALAR), hdf5().H5Sclose);
  const Handle attribute = checked(
      writing().H5Acreate2(file, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), hdf5().H5Aclose);
  require(writing().H5Awrite(attribute.id(), type.id(), text.data()) >= 0);
}

void write_column(hid_t file, const TableColumn& column) {
  const std::size_t width = column.width == 0 ? sizeof(double) : column.width;
  const hsize_t rows = column.bytes.size() / width;
  std::optional<Handle> texts;
  if (column.width > 0) texts.emplace(text_type_id(column.width), hdf5().H5Tclose);
  const hid_t type = texts ? texts->id() : hdf5().native_double;
  const Handle space = checked(writing().H5Screate_simple(1, &rows, nullptr), hdf5().H5Sclose);
  const Handle creation = checked(hdf5().H5Pcreate(writing().dataset_creation), hdf5().H5Pclose);
  require(writing().H5Pset_obj_track_times(creation.id(), false) >= 0);
  const Handle set = checked(
      writing().H5Dcreate2(file, column.name.c_str(), type, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      hdf5().H5Dclose);
  if (rows > 0) require(writing().H5Dwrite(set.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, column.bytes.data()) >= 0);
}

}  // namespace

std::string hdf5_table(std::span<const TableColumn> columns,
                       std::span<const std::pair<std::string, std::string>> attributes) {
  if (!hdf5_library.is_present()) throw DataError("HDF5: " + hdf5_library.reason_it_is_missing());
  const std::lock_guard lock(one_thread_at_a_time());
  constexpr std::size_t increment = std::size_t{1} << 20;
  constexpr unsigned truncating = 2;  // H5F_ACC_TRUNC, which calls functions of the library
  const Handle access = checked(hdf5().H5Pcreate(hdf5().file_access), hdf5().H5Pclose);
  require(hdf5().H5Pset_fapl_core(access.id(), increment, 0) >= 0);
  const Handle file =
      checked(writing().H5Fcreate("lober-table", truncating, H5P_DEFAULT, access.id()), hdf5().H5Fclose);
  for (const auto& [name, text] : attributes) write_attribute(file.id(), name, text);
  for (const TableColumn& column : columns) write_column(file.id(), column);
  require(writing().H5Fflush(file.id(), H5F_SCOPE_GLOBAL) >= 0);
  const ssize_t size = writing().H5Fget_file_image(file.id(), nullptr, 0);
  require(size > 0);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  require(writing().H5Fget_file_image(file.id(), bytes.data(), bytes.size()) == size);
  return bytes;
}
#else
std::string hdf5_table(std::span<const TableColumn>, std::span<const std::pair<std::string, std::string>>) {
  throw DataError("HDF5: " + hdf5_library.reason_it_is_missing());
}
#endif

}  // namespace lober
