#include <algorithm>
#include <map>
#include <stdexcept>

#include "tests/oracle/exact_result.hpp"

namespace lober::oracle {
namespace {

// A node as a run of the vertices of C1's chain, from `first` to `last` going counter-clockwise.
struct Contact {
  std::uint32_t first = 0, last = 0;
  ExactNode node;
};

class Finder {
 public:
  Finder(const Arrangement& arrangement, ExactOverlay& overlay)
      : arrangement_(arrangement), overlay_(overlay), length_(arrangement.chain[0].size()) {
    for (const std::uint32_t point : arrangement.chain[1]) {
      const auto position = static_cast<std::uint32_t>(on_second_.size());
      on_second_.emplace(point, position);
    }
  }

  void run() {
    find_contacts();
    find_orbits();
    order_as_given();
    for (const Contact& contact : contacts_) {
      overlay_.nodes.push_back(contact.node);
      if (contact.node.rho != 0) ++overlay_.crossings;
      if (contact.node.rho == 0 && contact.node.shared == 0) ++overlay_.touches;
      if (contact.node.shared != 0) ++overlay_.shared_arcs;
    }
    number_orbits();
  }

 private:
  [[nodiscard]] const SubEdge& edge(std::size_t k) const {
    return arrangement_.edges[arrangement_.chain_edges[0][k % length_]];
  }
  [[nodiscard]] std::uint32_t point(std::size_t k) const { return arrangement_.chain[0][k % length_]; }
  [[nodiscard]] bool is_shared(std::size_t k) const { return edge(k).along[1] != 0; }

  // Whether edge k of C1, which is not shared, runs inside A2: so are then the faces on both of its sides.
  [[nodiscard]] bool within_second(std::size_t k) const {
    return arrangement_.left_face(2 * std::size_t{arrangement_.chain_edges[0][k % length_]}).inside[1];
  }

  [[nodiscard]] Point rounded(std::size_t k) const {
    const ExactPoint& exact = arrangement_.points[point(k)];
    const int exponent = arrangement_.curves[0].exponent;
    return {nearest_double(scaled(exact.x, exponent)), nearest_double(scaled(exact.y, exponent))};
  }

  void find_contacts() {
    std::size_t origin = 0;
    while (origin < length_ && is_shared(origin)) ++origin;
    if (origin == length_) {
      overlay_.same_curve = true;
      add(0, length_, 0);
      return;
    }
    // From a vertex that follows an unshared edge, every shared run is met as a whole.
    ++origin;
    for (std::size_t k = origin; k < origin + length_; ++k) {
      if (!on_second_.contains(point(k))) continue;
      std::size_t last = k;
      while (is_shared(last)) ++last;
      add(k, last, int{within_second(k + length_ - 1)} - int{within_second(last)});
      k = last;
    }
  }

  void add(std::size_t first, std::size_t last, int rho) {
    Contact contact;
    contact.first = static_cast<std::uint32_t>(first % length_);
    contact.last = static_cast<std::uint32_t>(last % length_);
    contact.node.rho = rho;
    contact.node.shared = first == last ? 0 : edge(first).along[0] * edge(first).along[1];
    contact.node.orbit = no_orbit;
    contact.node.begin = rounded(first);
    contact.node.end = rounded(last);
    if (arrangement_.curves[0].reversed) std::swap(contact.node.begin, contact.node.end);
    contacts_.push_back(contact);
  }

  // sigma: from rho = +1 forward along C1 to the next crossing, from rho = -1 backward along C2.
  void find_orbits() {
    std::vector<std::size_t> along1;  // contacts_ are in the order of C1
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      if (contacts_[k].node.rho != 0) along1.push_back(k);
    }
    std::vector<std::size_t> along2 = along1;
    const auto position = [&](std::size_t k) { return on_second_.at(point(contacts_[k].first)); };
    std::sort(along2.begin(), along2.end(), [&](std::size_t a, std::size_t b) { return position(a) < position(b); });
    std::vector<std::size_t> sigma(contacts_.size());
    const std::size_t count = along1.size();
    for (std::size_t k = 0; k < count; ++k) {
      const int follower = contacts_[along1[(k + 1) % count]].node.rho;
      if (follower == contacts_[along1[k]].node.rho) throw std::logic_error("signs do not alternate along C1");
      if (contacts_[along2[(k + 1) % count]].node.rho == contacts_[along2[k]].node.rho) {
        throw std::logic_error("signs do not alternate along C2");
      }
      if (contacts_[along1[k]].node.rho > 0) sigma[along1[k]] = along1[(k + 1) % count];
      if (contacts_[along2[k]].node.rho < 0) sigma[along2[k]] = along2[(k + count - 1) % count];
    }
    for (const std::size_t seed : along1) {
      if (contacts_[seed].node.orbit != no_orbit) continue;
      for (std::size_t k = seed; contacts_[k].node.orbit == no_orbit; k = sigma[k]) {
        contacts_[k].node.orbit = static_cast<std::uint32_t>(overlay_.orbits);
      }
      ++overlay_.orbits;
    }
  }

  // By where each contact begins in the caller's direction, counted from the caller's vertex 0.
  void order_as_given() {
    const bool reversed = arrangement_.curves[0].reversed;
    const auto begin = [&](const Contact& contact) {
      return reversed ? (length_ - contact.last) % length_ : std::size_t{contact.first};
    };
    std::sort(contacts_.begin(), contacts_.end(),
              [&](const Contact& a, const Contact& b) { return begin(a) < begin(b); });
  }

  void number_orbits() {
    std::map<std::uint32_t, std::uint32_t> number;
    for (ExactNode& node : overlay_.nodes) {
      if (node.orbit == no_orbit) continue;
      node.orbit = number.emplace(node.orbit, static_cast<std::uint32_t>(number.size())).first->second;
    }
  }

  const Arrangement& arrangement_;
  ExactOverlay& overlay_;
  std::size_t length_;
  std::map<std::uint32_t, std::uint32_t> on_second_;  // point -> index in C2's chain
  std::vector<Contact> contacts_;
};

}  // namespace

void find_nodes(const Arrangement& arrangement, ExactOverlay& overlay) {
  Finder(arrangement, overlay).run();
}

}  // namespace lober::oracle
