// NPZ: a zip archive of NPY files, as numpy.savez writes it. libzip reads and writes the archive.
#include <algorithm>
#include <array>
#include <cstdint>
#include <list>
#include <memory>

#include "engine/base/utf8.hpp"
#include "engine/files/formats/arrays.hpp"
#include "engine/files/formats/libraries.hpp"
#include "engine/files/formats/npy_numbers.hpp"
#include "engine/files/formats/provenance.hpp"
#include "engine/files/formats/readers.hpp"
#if LOBER_HAS_ZIP
#include <zip.h>
#endif

namespace lober::detail {

#if LOBER_HAS_ZIP
namespace {

struct Zip {
  LOBER_LOADED(zip_library, zip_source_buffer_create);
  LOBER_LOADED(zip_library, zip_source_free);
  LOBER_LOADED(zip_library, zip_source_keep);
  LOBER_LOADED(zip_library, zip_source_open);
  LOBER_LOADED(zip_library, zip_source_read);
  LOBER_LOADED(zip_library, zip_source_close);
  LOBER_LOADED(zip_library, zip_source_stat);
  LOBER_LOADED(zip_library, zip_open_from_source);
  LOBER_LOADED(zip_library, zip_get_num_entries);
  LOBER_LOADED(zip_library, zip_stat_index);
  LOBER_LOADED(zip_library, zip_fopen_index);
  LOBER_LOADED(zip_library, zip_fread);
  LOBER_LOADED(zip_library, zip_fclose);
  LOBER_LOADED(zip_library, zip_file_add);
  LOBER_LOADED(zip_library, zip_file_set_dostime);
  LOBER_LOADED(zip_library, zip_set_file_compression);
  LOBER_LOADED(zip_library, zip_close);
  LOBER_LOADED(zip_library, zip_discard);
  LOBER_LOADED(zip_library, zip_strerror);
  LOBER_LOADED(zip_library, zip_error_strerror);
};

const Zip& zip() {
  static const Zip loaded;
  return loaded;
}

// An archive in memory that is closed without being written.
using Archive = std::unique_ptr<zip_t, void (*)(zip_t*)>;

class NpzFile final : public ArrayFile {
 public:
  NpzFile(std::span<const std::byte> bytes, const std::string& path)
      : path_(path), archive_size_(bytes.size()), archive_(opened(bytes, path)) {
    constexpr std::string_view ending = ".npy";
    const zip_int64_t count = zip().zip_get_num_entries(archive_.get(), 0);
    for (zip_uint64_t k = 0; k < static_cast<zip_uint64_t>(std::max<zip_int64_t>(count, 0)); ++k) {
      zip_stat_t status{};
      if (zip().zip_stat_index(archive_.get(), k, 0, &status) != 0 || (status.valid & ZIP_STAT_NAME) == 0) continue;
      std::string name = status.name;
      if (!name.ends_with(ending)) continue;
      name.resize(name.size() - ending.size());
      const std::vector<std::byte> head = content(k, name, max_header);
      if (!std::string_view(reinterpret_cast<const char*>(head.data()), head.size()).starts_with(npy_magic)) {
        fail(name, "is not an NPY file");
      }
      Member member{k, name, {}};
      try {
        member.header = read_npy_header(head, path);
      } catch (const DataError&) {  // structured arrays, objects
        continue;
      }
      if (holds_numbers(member.header)) {
        arrays_.push_back({name, member.header.shape});
        arrays_.back().is_complex = holds_complex_numbers(member.header);
        members_.push_back(std::move(member));
      } else {
        others_.push_back(std::move(member));
      }
    }
  }

  [[nodiscard]] const std::vector<ArrayInfo>& arrays() const override { return arrays_; }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) override {
    const Member& member = members_[index];
    const std::vector<std::byte> all = content(member.at, member.name, size_of(member));
    return npy_numbers(member.header, std::span(all).subspan(std::min(member.header.size, all.size())),
                       path_ + ": " + member.name + ".npy");
  }

  [[nodiscard]] std::vector<std::string> texts(std::string_view name) override {
    const auto found =
        std::find_if(others_.begin(), others_.end(), [&](const Member& one) { return one.name == name; });
    if (found == others_.end()) return {};
    const std::vector<std::byte> all = content(found->at, found->name, size_of(*found));
    return npy_texts(found->header, std::span(all).subspan(std::min(found->header.size, all.size())));
  }

 private:
  static constexpr std::size_t max_header = std::size_t{1} << 16;

  struct Member {
    zip_uint64_t at;
    std::string name;
    NpyHeader header;
  };

  static Archive opened(std::span<const std::byte> bytes, const std::string& path) {
    zip_error_t error{};
    const auto fail = [&] {
      throw DataError(path + ": is a zip archive that cannot be read: " + zip().zip_error_strerror(&error));
    };
    zip_source_t* const source = zip().zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source == nullptr) fail();
    zip_t* const archive = zip().zip_open_from_source(source, ZIP_RDONLY, &error);
    if (archive == nullptr) {
      zip().zip_source_free(source);
      fail();
    }
    return {archive, zip().zip_discard};
  }

  [[noreturn]] void fail(const std::string& name, const std::string& what) const {
    throw DataError(path_ + ": " + name + ".npy: " + what);
  }

  [[nodiscard]] std::size_t size_of(const Member& member) const {
    zip_stat_t status{};
    if (zip().zip_stat_index(archive_.get(), member.at, 0, &status) != 0 || (status.valid & ZIP_STAT_SIZE) == 0) {
      fail(member.name, zip().zip_strerror(archive_.get()));
    }
    require_fitting_memory(path_, {member.name, {status.size / sizeof(double)}});
    if (!can_hold(archive_size_, status.size)) fail(member.name, "promises more than the archive can hold");
    return status.size;
  }

  // The first bytes of a member, or all of them; the archive's check sum is compared behind the last one.
  [[nodiscard]] std::vector<std::byte> content(zip_uint64_t at, const std::string& name, std::size_t most) const {
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip().zip_fopen_index(archive_.get(), at, 0),
                                                                 zip().zip_fclose);
    if (file == nullptr) fail(name, zip().zip_strerror(archive_.get()));
    std::vector<std::byte> bytes(most);
    std::size_t used = 0;
    while (used < most) {
      const zip_int64_t got = zip().zip_fread(file.get(), bytes.data() + used, most - used);
      if (got < 0) fail(name, "is damaged");
      if (got == 0) break;
      used += static_cast<std::size_t>(got);
    }
    bytes.resize(used);
    return bytes;
  }

  const std::string& path_;
  std::size_t archive_size_;
  Archive archive_;
  std::vector<ArrayInfo> arrays_;
  std::vector<Member> members_, others_;  // those of numbers, in the order of arrays_; all others
};

std::string_view bytes_of(const auto& elements) {
  return {reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(elements[0])};
}

// UTF-8 as the UTF-32 that NumPy's type U has.
std::u32string utf32(std::string_view text) {
  std::u32string codes;
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t size = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    char32_t code = size == 1 ? lead : lead & (0xFFU >> (size + 1));
    for (std::size_t k = 1; k < size && at + k < text.size(); ++k) {
      code = code << 6 | (static_cast<unsigned char>(text[at + k]) & 0x3F);
    }
    codes += code;
    at += size;
  }
  return codes;
}

// An NPY file of texts; `shape` is that of their number, or empty for a single one.
std::string npy_of_texts(std::span<const std::string> texts, std::span<const std::size_t> shape) {
  std::vector<std::u32string> all;
  std::size_t width = 1;
  for (const std::string& text : texts) {
    all.push_back(utf32(text));
    width = std::max(width, all.back().size());
  }
  std::string bytes = npy_head(shape, "U" + std::to_string(width));
  for (std::u32string& text : all) {
    text.resize(width, U'\0');
    bytes += bytes_of(text);
  }
  return bytes;
}

// An archive that is written into memory. The same members give the same bytes.
class NpzWriter {
 public:
  NpzWriter() {
    zip_error_t error{};
    source_ = zip().zip_source_buffer_create(nullptr, 0, 0, &error);
    if (source_ == nullptr) throw std::bad_alloc();
    archive_ = zip().zip_open_from_source(source_, ZIP_CREATE | ZIP_TRUNCATE, &error);
    if (archive_ == nullptr) throw std::bad_alloc();
    zip().zip_source_keep(source_);
  }
  ~NpzWriter() {
    if (archive_ != nullptr) zip().zip_discard(archive_);
    zip().zip_source_free(source_);
  }
  NpzWriter(const NpzWriter&) = delete;
  NpzWriter& operator=(const NpzWriter&) = delete;

  void add(const std::string& name, std::string content) {
    constexpr zip_uint16_t first_day = 1 << 5 | 1;  // that of 1980, with which zip archives begin
    contents_.push_back(std::move(content));
    const std::string& bytes = contents_.back();
    zip_source_t* const source = zip().zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
    const zip_int64_t index =
        source == nullptr ? -1 : zip().zip_file_add(archive_, (name + ".npy").c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) throw DataError(std::string("the NumPy archive: ") + zip().zip_strerror(archive_));
    const auto entry = static_cast<zip_uint64_t>(index);
    zip().zip_set_file_compression(archive_, entry, ZIP_CM_STORE, 0);
    zip().zip_file_set_dostime(archive_, entry, 0, first_day, 0);
  }

  [[nodiscard]] std::string bytes() {
    if (zip().zip_close(archive_) != 0) {
      throw DataError(std::string("the NumPy archive: ") + zip().zip_strerror(archive_));
    }
    archive_ = nullptr;
    zip_stat_t status{};
    std::string all;
    if (zip().zip_source_stat(source_, &status) != 0 || zip().zip_source_open(source_) != 0) throw std::bad_alloc();
    all.resize(status.size);
    const zip_int64_t got = zip().zip_source_read(source_, all.data(), all.size());
    zip().zip_source_close(source_);
    if (got != static_cast<zip_int64_t>(all.size())) throw DataError("the NumPy archive was cut off in memory");
    return all;
  }

 private:
  zip_source_t* source_ = nullptr;
  zip_t* archive_ = nullptr;
  std::list<std::string> contents_;  // which the archive reads when it is closed
};

}  // namespace

void read_npz(const FileSource& source, CurveFile& file) {
  if (!zip_library.is_present()) {
    throw DataError(file.path + ": this is a NumPy archive (NPZ), " + zip_library.reason_it_is_missing());
  }
  NpzFile arrays(source.bytes, file.path);
  read_arrays(arrays, source.columns, file);
}

std::string npz_bytes(std::span<const Zone> zones, const WriteOptions& options) {
  if (!zip_library.is_present()) throw DataError("NPZ: " + zip_library.reason_it_is_missing());
  std::vector<std::int64_t> offsets{0};
  std::vector<std::string> titles;
  for (const Zone& zone : zones) {
    offsets.push_back(offsets.back() + static_cast<std::int64_t>(zone.points.size()));
    titles.push_back(as_utf8(zone.title));
  }
  const std::array<std::size_t, 1> of_zones{zones.size()}, of_offsets{offsets.size()};
  NpzWriter archive;
  std::string points = npy_head(std::array{static_cast<std::size_t>(offsets.back()), std::size_t{2}});
  for (const Zone& zone : zones) points += bytes_of(zone.points);
  archive.add("points", std::move(points));
  archive.add("offsets", npy_head(of_offsets, "i8").append(bytes_of(offsets)));
  archive.add("titles", npy_of_texts(titles, of_zones));
  for (const std::string& name : names_of_numbers(zones)) {
    archive.add(name, npy_head(of_zones).append(bytes_of(numbers_called(name, zones))));
  }
  if (std::any_of(zones.begin(), zones.end(), [](const Zone& zone) { return zone.hole; })) {
    std::vector<std::int64_t> holes;
    for (const Zone& zone : zones) holes.push_back(zone.hole ? 1 : 0);
    archive.add("hole", npy_head(of_zones, "i8").append(bytes_of(holes)));
  }
  if (!options.provenance.empty()) {
    const std::string text = provenance_text(options);
    archive.add("provenance", npy_of_texts({&text, 1}, {}));
  }
  return archive.bytes();
}
#else
std::string npz_bytes(std::span<const Zone>, const WriteOptions&) {
  throw DataError("NPZ: " + zip_library.reason_it_is_missing());
}
void read_npz(const FileSource&, CurveFile& file) {
  throw DataError(file.path + ": this is a NumPy archive (NPZ), " + zip_library.reason_it_is_missing());
}
#endif

}  // namespace lober::detail
