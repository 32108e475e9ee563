#include "engine/geometry/densify/meetings.hpp"

#include <algorithm>

#include "engine/base/parallel/running_sums.hpp"
#include "engine/geometry/crossings/contacts.hpp"

namespace lober::detail {
namespace {

bool before(const Meeting& x, const Meeting& y) {
  return x.at.segment != y.at.segment ? x.at.segment < y.at.segment : x.at.t < y.at.t;
}

void insert(Buffer<Meeting>& meetings, const Meeting& meeting) {
  meetings.insert(std::upper_bound(meetings.begin(), meetings.end(), meeting, before), meeting);
}

// Segments are searched without their last point, so the end of an open curve is looked for apart: as the first point
// of its last segment run backwards.
void add_end(const IndexedCurve& own, const IndexedCurve& other, Buffer<Meeting>& on_own, Buffer<Meeting>& on_other) {
  const std::span<const Point> points = own.view().points;
  if (own.view().closed) return;
  const std::array<Point, 2> last{points.back(), points[points.size() - 2]};
  const Contacts contacts = find_contacts(IndexedCurve({last, false}), other, IndexKind::tree);
  bool found = false;
  for (std::size_t k = 0; k < contacts.list.size(); ++k) {
    const Contact contact = contacts.list[k];
    if (!contact.vertex1) continue;
    found = true;
    if (!contact.vertex2) insert(on_other, {{contact.segment2, contact.t2.hi}, last[0], false});
  }
  const auto segment = static_cast<std::uint32_t>(own.segments() - 1);
  if (found) on_own.push_back({{segment, 1}, last[0], true});
}

}  // namespace

std::array<Buffer<Meeting>, 2> find_meetings(CurveView first, CurveView second) {
  const IndexedCurve c1(first), c2(second);
  const Contacts contacts = find_contacts(c1, c2, choose_index(c1, c2));
  const std::size_t size = contacts.list.size();
  std::array<Buffer<Meeting>, 2> meetings{Buffer<Meeting>(size), Buffer<Meeting>(size)};
  for_each_block(size, pass_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Contact along1 = contacts.list[k];
      meetings[0][k] = {{along1.segment1, along1.t1.hi}, contact_point(along1, first, second), along1.vertex1};
      const Contact along2 = contacts.list[contacts.order2[k]];
      meetings[1][k] = {{along2.segment2, along2.t2.hi}, contact_point(along2, first, second), along2.vertex2};
    }
  });
  add_end(c1, c2, meetings[0], meetings[1]);
  add_end(c2, c1, meetings[1], meetings[0]);
  return meetings;
}

}  // namespace lober::detail
