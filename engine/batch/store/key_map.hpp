// A map from keys of jobs (private to the store).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "engine/batch/operations/result.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Entries stay in the order in which they came; a slot has the index of one and as much of its key as makes looking at
/// the entry itself needless nearly always: with millions of keys, each look is a miss of the cache. Keys are digests,
/// so that any part of one is a hash.
template <typename Value>
class KeyMap {
 public:
  using Entry = std::pair<JobKey, Value>;

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] auto begin() const { return entries_.begin(); }
  [[nodiscard]] auto end() const { return entries_.end(); }
  [[nodiscard]] auto begin() { return entries_.begin(); }
  [[nodiscard]] auto end() { return entries_.end(); }

  /// Null if there is none. Valid until the next `try_emplace`.
  [[nodiscard]] const Value* find(const JobKey& key) const {
    if (slots_.empty()) return nullptr;
    const Slot& slot = slots_[slot_of(key)];
    return slot.index == none ? nullptr : &entries_[slot.index].second;
  }
  [[nodiscard]] Value* find(const JobKey& key) { return const_cast<Value*>(std::as_const(*this).find(key)); }

  /// Asks for the memory where the key is looked for: between this and that, other work hides the time it takes.
  void prefetch(const JobKey& key) const {
    if (!slots_.empty()) __builtin_prefetch(&slots_[hash_of(key) & (slots_.size() - 1)]);
  }

  /// Makes room for that number of entries beside those that it has.
  void reserve(std::size_t more) {
    entries_.reserve(entries_.size() + more);
    std::size_t slots = std::max(slots_.size(), smallest);
    while (slots < 2 * (entries_.size() + more + 1)) slots *= 2;
    if (slots != slots_.size()) resize_slots(slots);
  }

  /// The value of the key, and whether it is new.
  std::pair<Value&, bool> try_emplace(const JobKey& key, const Value& value) {
    if (2 * (entries_.size() + 1) > slots_.size()) resize_slots(std::max(2 * slots_.size(), smallest));
    Slot& slot = slots_[slot_of(key)];
    const bool is_new = slot.index == none;
    if (is_new) {
      slot = {tag_of(key), static_cast<std::uint32_t>(entries_.size())};
      entries_.emplace_back(key, value);
    }
    return {entries_[slot.index].second, is_new};
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::size_t smallest = 64;
  struct Slot {
    std::uint32_t tag = 0, index = none;
  };
  static std::uint32_t tag_of(const JobKey& key) {
    std::uint32_t tag = 0;
    std::memcpy(&tag, key.data(), sizeof(tag));
    return tag;
  }
  static std::uint64_t hash_of(const JobKey& key) {
    std::uint64_t hash = 0;
    std::memcpy(&hash, key.data() + sizeof(std::uint32_t), sizeof(hash));
    return hash;
  }
  // The slot of the key, or the free one where it would be.
  [[nodiscard]] std::size_t slot_of(const JobKey& key) const {
    const std::uint32_t tag = tag_of(key);
    std::size_t at = hash_of(key) & (slots_.size() - 1);
    while (slots_[at].index != none && (slots_[at].tag != tag || entries_[slots_[at].index].first != key)) {
      at = (at + 1) & (slots_.size() - 1);
    }
    return at;
  }
  void resize_slots(std::size_t size) {
    slots_.assign(size, {});
    for (std::size_t index = 0; index < entries_.size(); ++index) {
      const JobKey& key = entries_[index].first;
      slots_[slot_of(key)] = {tag_of(key), static_cast<std::uint32_t>(index)};
    }
  }

  Buffer<Entry> entries_;
  Buffer<Slot> slots_;  ///< a power of two
};

}  // namespace lober::detail
