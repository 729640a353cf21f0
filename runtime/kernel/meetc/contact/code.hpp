// The contact code of a pair: where two elements of points meet, as 64 bits without a coordinate.
//
// Carriers of a triangle: 0, 1, 2 are its corners, 3, 4, 5 its open edges (corner i to i + 1 mod 3), 6 is its open face.
// Carriers of a segment: 0, 1 are its ends, 3 is the open segment. A label (s, t) of a pair is a carrier of each element
// whose interiors share a point, and whose lines or planes share that point alone. The labels of a pair are one to one with the
// extreme points of what the elements have in common, so that this is a point, a segment or a convex polygon.
//
// Carriers of a ball, in a pair with a segment: 0 its inside, 1 its surface where a segment ends on it, 2 and 3 its surface
// where the open segment, from its first end to its second, comes in and goes out, 4 where it touches the surface and turns
// back. A solid ball and a segment share a segment or a point; a surface and a segment share up to two points. Other pairs of
// round elements share what labels do not tell; their code says that one point of it, a witness, will be placed.
#ifndef MEETC_CONTACT_CODE_HPP
#define MEETC_CONTACT_CODE_HPP

#include <meetc/environment/environment.hpp>

#include <cstdint>

MEETC_NAMESPACE(meetc) {

inline constexpr int open_face = 6, first_edge = 3, most_labels = 6;
inline constexpr int in_ball = 0, on_ball = 1, first_root = 2, second_root = 3, double_root = 4;

// The number of a label: the carrier of a in bits 0 to 2, that of b in bits 3 to 5.
MEETC_HD constexpr unsigned label_of(int carrier_a, int carrier_b) {
  return static_cast<unsigned>(carrier_a) | static_cast<unsigned>(carrier_b) << 3;
}
MEETC_HD constexpr int label_a(unsigned label) {
  return static_cast<int>(label & 7);
}
MEETC_HD constexpr int label_b(unsigned label) {
  return static_cast<int>(label >> 3);
}

// Bits 0 to 2: the number of labels; 3, 4: the dimension; 5: in one plane; 6: there, both normals point to one side;
// from bit 7 on the labels, six bits each. 0: the elements are apart. A segment begins where it enters the pair along
// N_A x N_B (with a segment, along the segment); where that is no direction, with the least label. A polygon is
// counter-clockwise, seen from the tip of N_A, and begins with the least label. Two labels of dimension 0 are two points, in
// the order of the segment. Bit 43: there is a witness and no label; bit 44: it is one of surfaces.
class contact_code {
public:
  MEETC_HD constexpr explicit contact_code(std::uint64_t bits = 0) : bits_(bits) {}
  MEETC_HD constexpr contact_code(const unsigned *labels, int n, bool in_one_plane = false, bool normals_agree = false)
      : bits_(static_cast<std::uint64_t>(n) | static_cast<std::uint64_t>(n == 0  ? 0
                                                                         : n < 3 ? n - 1
                                                                                 : 2)
                                                  << 3) {
    if (n == 0)
      return;
    bits_ |= std::uint64_t{in_one_plane} << 5 | std::uint64_t{normals_agree} << 6;
    for (int i = 0; i < n; ++i)
      bits_ |= std::uint64_t{labels[i]} << (7 + 6 * i);
  }
  // Up to two points, which no segment joins.
  MEETC_HD static constexpr contact_code of_points(const unsigned *labels, int n) {
    return contact_code(contact_code(labels, n).bits_ & ~(std::uint64_t{3} << 3));
  }
  MEETC_HD static constexpr contact_code of_witness(bool of_surfaces) {
    return contact_code(std::uint64_t{1} << 43 | std::uint64_t{of_surfaces} << 44);
  }
  MEETC_HD constexpr std::uint64_t bits() const { return bits_; }
  MEETC_HD constexpr int labels() const { return static_cast<int>(bits_ & 7); }
  MEETC_HD constexpr int dimension() const { return static_cast<int>(bits_ >> 3 & 3); }
  MEETC_HD constexpr bool in_one_plane() const { return (bits_ >> 5 & 1) != 0; }
  MEETC_HD constexpr bool normals_agree() const { return (bits_ >> 6 & 1) != 0; }
  MEETC_HD constexpr bool has_witness() const { return (bits_ >> 43 & 1) != 0; }
  MEETC_HD constexpr bool of_surfaces() const { return (bits_ >> 44 & 1) != 0; }
  MEETC_HD constexpr unsigned label(int i) const { return static_cast<unsigned>(bits_ >> (7 + 6 * i) & 63); }

private:
  std::uint64_t bits_;
};

// The dimension of a carrier of an element with this many corners: 0, 1 or 2. A ball has no corners; its inside has 3.
MEETC_HD constexpr int carrier_dimension(int carrier, int corners) {
  if (corners == 0)
    return carrier == in_ball ? 3 : 2;
  return carrier < corners ? 0 : carrier < open_face ? 1 : 2;
}

// Labels as they are found: sorted, none twice. By right signs there are at most six; others are not taken.
class label_list {
public:
  MEETC_HD void add(int carrier_a, int carrier_b) {
    const unsigned label = label_of(carrier_a, carrier_b);
    if (count_ == most_labels)
      return;
    int i = count_;
    for (; i > 0 && labels_[i - 1] >= label; --i)
      if (labels_[i - 1] == label)
        return;
    for (int j = count_++; j > i; --j)
      labels_[j] = labels_[j - 1];
    labels_[i] = label;
  }
  MEETC_HD int count() const { return count_; }
  MEETC_HD unsigned operator[](int i) const { return labels_[i]; }
  MEETC_HD const unsigned *data() const { return labels_; }
  MEETC_HD void exchange() {
    const unsigned first = labels_[0];
    labels_[0] = labels_[1], labels_[1] = first;
  }

private:
  unsigned labels_[most_labels];
  int count_ = 0;
};

} // MEETC_NAMESPACE(meetc)

#endif
