// core/contacts/contacts.hpp: where the pairs that collide() finds meet: a point, a segment or a polygon of each pair, and the
// polylines and flat patches that these make together; of pairs that share what has no such corners, one point, a witness.
//
// A pair's corners are named by the parts of both elements on which they lie (a vertex, an edge, a face), and corners of one
// name are one node: names are compared, not coordinates. Vertices of equal coordinates are one vertex (+0 and -0 are equal),
// whatever their indices. If both meshes are embedded (no two faces meet but in common vertices and edges, and all have area),
// nodes and points are one to one; elsewhere several nodes may be one point. Names and their order are exact. Each
// coordinate is the exact one, rounded once, to the nearest number and of two to the even one; so rounded points need not
// lie on the elements. The answer is the same, bit for bit, for any number of threads.
//
// A segment meets a solid ball in a segment or a point, and a ball's surface in up to two points. Their coordinates are
// (P + Q sqrt D) / S in integers; they are rounded once like the others. A ball with another ball, or with a triangle, has a
// witness (meetc/contact/witness.hpp), which lies on both up to a stated error, is no node and is joined with nothing.
#ifndef MEETC_CORE_CONTACTS_CONTACTS_HPP
#define MEETC_CORE_CONTACTS_CONTACTS_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/query/self_pairs.hpp"
#include "meet/core/threads/cancelled.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/core/views/view.hpp"
#include "meetc/contact/code.hpp"
#include "meetc/table/table.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace meetc {

// A part of an element; meetc/contact/code.hpp numbers carriers.
struct element_part {
  std::uint32_t element;  // that of the first pair with this node
  std::uint8_t dimension; // 0 a vertex, 1 an edge, 2 a face or a ball's surface, 3 a ball's inside
  std::uint8_t carrier;
};

// Lists of nodes, one after another: list i is nodes[offsets[i]] to nodes[offsets[i + 1] - 1].
struct node_lists {
  std::vector<std::size_t> offsets = {0};
  std::vector<std::uint32_t> nodes;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {nodes.data() + offsets[i], offsets[i + 1] - offsets[i]};
  }
  void end_list() { offsets.push_back(nodes.size()); }
};

// (numerator + root sqrt(radicand)) / denominator: whole numbers in decimal. The denominator is positive, and no number divides
// it, the numerator and the root. A rational coordinate has root and radicand 0.
struct decimal_fraction {
  std::string numerator, denominator, root = "0", radicand = "0";
};

// A node's first corner: the pair of rows and the label by which its coordinates are computed.
struct node_source {
  std::uint32_t a, b; // rows
  unsigned label;
};

// The rows of the elements that are in some pair.
struct touched_rows {
  int corners = 0; // of an element; 0: the rows are balls
  int fields = 0;  // of a row
  std::vector<std::uint32_t> elements;
  std::vector<float> rows;
};

// Whether both meshes are embedded, so that nodes and points are one to one.
enum class embedding : std::uint8_t { unchecked, embedded, not_embedded };

template <class Real> struct contact_set {
  embedding embedded = embedding::unchecked;
  std::vector<index_pair> pairs;        // as they were given
  std::vector<std::uint64_t> codes;     // of each pair: its contact_code
  node_lists corners;                   // of each pair, in the order of its code; none where the elements are apart
  std::vector<Real> points;             // x, y, z of each node, in the units of the posed elements
  std::vector<element_part> on_a, on_b; // of each node
  // Segments of two nodes in which some pair meets, none twice, along N_A x N_B of the first such pair, or along its segment. A
  // segment along a side
  // of a patch is one only if a pair in two planes meets in it: the others are edges of the triangulation inside a flat
  // contact.
  std::vector<std::array<std::uint32_t, 2>> pieces;
  // Chains of pieces between ends and branch points, and loops. A closed one does not repeat its first node. Each runs as most
  // of its pieces do.
  node_lists polylines;
  std::vector<std::uint8_t> closed;        // of each polyline
  node_lists patches;                      // polygons in which coplanar pairs overlap, counter-clockwise from N_A's tip
  std::vector<std::uint32_t> patch_pairs;  // of each patch, the index of its pair
  std::vector<std::uint32_t> single_nodes; // on no piece and no patch, ascending
  // The index of each pair with a witness, and its x, y, z. Before it is rounded to Real a witness lies within 2^-46 m of
  // both elements, with m the sum of the radii and, for each axis, of the greatest difference of coordinates. A coordinate
  // beyond the range of Real is infinite.
  std::vector<std::uint32_t> witness_pairs;
  std::vector<Real> witnesses;
  double seconds = 0; // wall-clock time of the call

  std::size_t nodes() const { return points.size() / 3; }
  // The exact coordinates of a node. Throws std::out_of_range.
  std::array<decimal_fraction, 3> exact(std::size_t node) const;

  touched_rows rows_a, rows_b;
  std::vector<node_source> sources; // of each node
};

struct contact_options {
  pose at_a = {}, at_b = {}; // those with which the sets were prepared
  int threads = 0;           // 0: all cores
  std::stop_token stop = {}; // as in collide_options
  // The predicates that tell, at the cost of self_pairs() for each mesh, whether both are embedded. Null: it stays unchecked.
  const self_predicates *embedded_by = nullptr;
};

// The contacts of pairs of elements of two views, for Real float or double. `predicate` decided the pairs: its kinds are those
// of the views, and its scene asks for the sign that tells contacts (predicate_info::contacts is not null). Elements that are
// apart have no contact. Memory grows with the pairs, and by four bytes for each element of the views. Throws
// usage_error (a predicate without contacts, a bad view or pose, embedded_by for sets that are no triangles),
// std::out_of_range (a pair of elements that are not there), input_error (a bad element of a pair, or with embedded_by of a
// view), std::length_error, std::bad_alloc or `cancelled`.
template <class Real = float>
contact_set<Real> contacts(const view &a, const view &b, const predicate_info &predicate,
                           std::span<const index_pair> pairs, const contact_options &options = {});

} // namespace meetc

#endif
