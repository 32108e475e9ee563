// The raw material of crossings (private to crossings/): every point where two curves meet, found exactly, once, and
// sorted along both.
//
// A contact is either a proper crossing (inside a segment of either curve) or a vertex of one curve that lies on the
// other. Segments are taken half-open, with their first end and without their second, so that a contact belongs to
// exactly one pair of segments and nothing is found twice. Where the curves share an arc its vertices are contacts, and
// the straight pieces between neighbouring contacts are shared; long runs of common vertices are recognised and
// represented by their first contact alone.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/stopwatch.hpp"
#include "engine/geometry/index/index.hpp"
#include "kernels/crossing_parameters.hpp"
#include "kernels/predicates.hpp"
#include "lober/base/buffer.hpp"
#include "lober/overlay/counts.hpp"

namespace lober::detail {

struct ContactKind {
  std::int8_t rho;  ///< proper crossing: +1 if C2 passes from right to left of C1 as the input runs; else 0
  std::int8_t
      run;  ///< +1 / -1: from here to the next contact along C1 the curves share their vertices (C2 forward / back)
  bool vertex1;  ///< at the first end of segment1 (then t1 is zero, but t1 may also have underflowed to it)
  bool vertex2;
  [[nodiscard]] bool proper() const { return rho != 0; }
  [[nodiscard]] const ContactKind& kind() const { return *this; }
};

struct Contact : ContactKind {
  std::uint32_t segment1, segment2;
  DD t1, t2;  ///< parameters in [0, 1), rounded
};

/// Contacts, each property in an array of its own: most passes read one or two of them.
class ContactList {
 public:
  ContactList() = default;
  explicit ContactList(std::size_t size) : kind_(size), segment1_(size), segment2_(size), t1_(size), t2_(size) {}

  [[nodiscard]] std::size_t size() const { return kind_.size(); }
  [[nodiscard]] Contact operator[](std::size_t k) const {
    return {kind_[k], segment1_[k], segment2_[k], t1_[k], t2_[k]};
  }
  [[nodiscard]] ContactKind kind(std::size_t k) const { return kind_[k]; }
  [[nodiscard]] std::uint32_t segment2(std::size_t k) const { return segment2_[k]; }
  [[nodiscard]] DD t2(std::size_t k) const { return t2_[k]; }
  void set(std::size_t k, const Contact& contact) {
    kind_[k] = contact.kind();
    segment1_[k] = contact.segment1;
    segment2_[k] = contact.segment2;
    t1_[k] = contact.t1;
    t2_[k] = contact.t2;
  }

 private:
  Buffer<ContactKind> kind_;
  Buffer<std::uint32_t> segment1_, segment2_;
  Buffer<DD> t1_, t2_;
};

/// The contact rounded to double: exact at a vertex, else right to about an ulp.
[[nodiscard]] Point contact_point(const Contact& contact, const CurveView& c1, const CurveView& c2);

struct Contacts {
  ContactList list;              ///< in order along C1
  Buffer<std::uint32_t> order2;  ///< indices into `list` in order along C2
  bool all_proper = true;
  ContactCounts counts;
  double search_seconds = 0, order_seconds = 0;
};

/// O(n + m + candidates + contacts log contacts on one segment), parallel. Both curves are taken to be simple; if they
/// are not, the result is complete all the same except inside runs of common vertices.
[[nodiscard]] Contacts find_contacts(const IndexedCurve& c1, const IndexedCurve& c2, IndexKind kind);
/// The same; the watch has been started just now, and is again where it ends.
[[nodiscard]] Contacts find_contacts(const IndexedCurve& c1, const IndexedCurve& c2, IndexKind kind, Stopwatch& watch);

/// The numbers of the contacts, sorted by segment of C2 and along each segment, exactly. Adds to `counts` what that
/// took. Parallel, deterministic; one pass where curves run side by side, else about two of counting sort; n log n on a
/// segment with n contacts.
[[nodiscard]] Buffer<std::uint32_t> sort_along_second(const ContactList& contacts, const CurveView& c1,
                                                      const CurveView& c2, ContactCounts& counts);

}  // namespace lober::detail
