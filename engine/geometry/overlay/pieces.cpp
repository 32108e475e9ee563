#include <algorithm>

#include "engine/geometry/overlay/pieces_data.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober {
using namespace detail;

std::string_view name(Pairing pairing) {
  switch (pairing) {
    case Pairing::c1_minus_c2:
      return "c1_minus_c2";
    case Pairing::c2_minus_c1:
      return "c2_minus_c1";
    case Pairing::intersection:
      return "intersection";
    case Pairing::union_:
      return "union";
  }
  return "";
}

Pieces::Pieces() {
  static const auto none = std::make_shared<const PiecesData>();
  data_ = none;
}

std::span<const double> Pieces::areas() const& {
  return data_->areas;
}

Piece Pieces::operator[](std::size_t piece) const& {
  const std::span<const PieceHole> holes = data_->holes_of(piece);
  return {data_->areas[piece], static_cast<std::uint32_t>(holes.size()), {data_->outer(piece), holes}};
}

std::span<const PieceHole> PiecesData::holes_of(std::size_t piece) const {
  const auto first = std::lower_bound(holes.begin(), holes.end(), piece,
                                      [](const PieceHole& hole, std::size_t number) { return hole.piece < number; });
  auto last = first;
  while (last != holes.end() && last->piece == piece) ++last;
  return {first, last};
}

}  // namespace lober
