// The interface of generated CUDA code for a host: plain data and launchers, which name no shape.
//
// Every launcher enqueues its work on the stream; it allocates nothing, waits for nothing and throws nothing. All
// pointers are device memory unless said otherwise. An element's index in its array is its slot.
#ifndef MEETC_CUDA_TABLE_HPP
#define MEETC_CUDA_TABLE_HPP

#include <meetc/table/table.hpp>
#include <meetc/volume/fours.hpp>

#include <cuda_runtime_api.h>

namespace meetc::cuda {

// A list that kernels append to, in any order. *count is the true number even where it exceeds the capacity. Only some of
// the pairs are then written, and the caller repeats the call with more room.
struct pair_list {
  index_pair *pairs;
  unsigned long long *count;
  unsigned long long capacity;
  bool both_ways = false; // of hits: {a, b} is appended as {b, a} as well, unless a is b
};

// Elements in the caller's device memory. With `index`, each element is a fixed number of indices into `vertices`
// points x, y, z. Without, it is a row of the kind's floats, and `vertices` is not read.
struct view {
  const float *data;
  std::size_t stride_bytes; // of a point or row; a multiple of 4 is not needed
  const std::uint32_t *index;
  std::uint32_t vertices, elements;
  const std::uint32_t *only = nullptr; // element i is element only[i] of all; null: i
};

// Row-major 3x4: a point becomes ((m0*x + m1*y) + m2*z) + m3 in fp64, in this order, without fma, rounded once to
// float32; lengths are multiplied by length_scale. The identity passes every bit through. Then each number is rounded to
// the nearest multiple of 2^grid_low, if on_grid.
struct pose_matrix {
  double m[12];
  double length_scale;
  bool identity;
  bool on_grid = false;
  int grid_low = 0;
};

// The findings on elements that were put into order.
struct order_findings {
  // The first element with a bad index, a number that is not finite, or a broken rule of its kind, times 2^32, plus its slot;
  // ~0 where all elements are good. If one is not, the rest means nothing.
  unsigned long long bad;
  unsigned long long crowded;   // elements before which at least tree_width others have the same place
  unsigned long long unordered; // above 0: too many lie too close to each other, and have no places
};
// Whether n elements are in an order, so that neighbours along it are near each other: an eighth of them may be crowded.
MEETC_HD constexpr bool is_order(const order_findings &found, std::uint32_t n) {
  return found.bad == ~0ULL && found.crowded <= n / 8 && found.unordered == 0;
}
// Threads of a block of arrange(), which keeps a row of each in shared memory.
MEETC_HD constexpr unsigned threads_to_arrange(int fields) {
  unsigned n = 1024;
  while (n > 32 && sizeof(float) * n * static_cast<unsigned>(fields) > 40000)
    n /= 2;
  return n;
}
// Whether arrange() makes the tree too, whose nodes a block of so many threads makes.
MEETC_HD constexpr bool can_arrange_tree(int fields) {
  return threads_to_arrange(fields) == tree_width * tree_width;
}
inline constexpr std::uint32_t most_to_arrange = 1U << 20;
inline constexpr int bits_to_arrange = 10; // of a cell along an axis, as places() has them
inline constexpr std::size_t counted_to_distribute = 2048;
// The device memory that blocks share while they put keys into order (distribute.hpp).
struct distribution {
  std::uint64_t *keys, *by_cell; // n each; keys are written by count(), and read by distribute() for the last time
  std::uint32_t n;               // above 0, below 2^31
  std::uint32_t *counted;        // counted_to_distribute, all 0 before and, after clear(), again
};
// The box around some boxes, in numbers that are 0 where there are none and that maxima join.
struct joined_box {
  std::uint32_t below[3], above[3];
};
// Elements that are moved and put into the order of their places, those with one place in that of their numbers.
struct arrange_job {
  view from;
  pose_matrix at;
  float share;       // it takes this part of the device, so that others run beside it; above 0, at most 1
  float *posed;      // room for the rows in the caller's order; null: they stand so in `from`, packed and in this pose
  distribution keys; // of as many as there are elements
  const joined_box *common; // places are by the box that these two have in common; null: by one around the elements
  tree_box *boxes;          // room for most_blocks_to_arrange; null: that takes none
  float *rows;              // the rows become these,
  std::uint32_t *order;     // of these elements
  order_findings *found;
  tree_node *nodes; // as by boxes(); null: no tree is made
  unsigned *arrived;
  unsigned long long *cleared = nullptr; // so many numbers become 0, which saves a step of its own
  std::size_t clears = 0;
};
inline constexpr unsigned most_blocks_to_arrange = 1024;

// Rows that are put into an order that is known, with the two lowest levels of their tree.
struct gather_job {
  const float *from; // packed rows
  std::uint32_t elements;
  const std::uint32_t *sorted; // their places, in order
  std::uint32_t *slots; // row i becomes row slots[i] of `from`. Then that becomes names[slots[i]], if there are names
  const std::uint32_t *names;
  float *rows;
  tree_node *nodes;            // null: no tree is made
  unsigned long long *crowded; // 0 at first; of order_findings
};

// One pass over the elements of one of two sets that are culled: those that the other's box and its marks do not rule out are
// kept, and mark their own cells. Such passes follow one another, each with the marks of the one before.
inline constexpr int least_cull_bits = 3, most_cull_bits = 9;
struct sift_job {
  view from;
  pose_matrix at;
  const joined_box *around;      // of both sets
  int bits;                      // of a cell along an axis, from least_cull_bits to most_cull_bits
  bool by_lines;                 // long elements with two points are kept, and mark the cells along their line
  const std::uint32_t *vertices; // cull_grid::cells_of() each vertex, where there is an index
  const std::uint32_t *among;    // the elements that are looked at; null: all
  const unsigned *among_count;
  std::uint32_t *marked, *marks; // cull_marks::words_for(bits), all 0 at first; null: all is marked, nothing is to be
  std::uint32_t *kept;           // room for all that are looked at; in any order
  unsigned *count;               // 0 at first
  unsigned long long *bad;       // 0 at first; the greatest of what is ~ of order_findings::bad
  // Where all passes have ended with this one: so many words that they have counted go to host memory, and then `there` becomes
  // 1, which the host sees sooner than the end of a copy. Null: not here.
  struct report {
    const std::uint32_t *from;
    std::uint32_t *to, words, *there;
    unsigned *arrived; // 0 before and after
  } at_end;
};

// A member of a table that its initialiser must state: without it the table does not compile.
template <class T> class stated {
public:
  constexpr stated(T value) : value_(value) {}
  constexpr operator T() const { return value_; }

private:
  T value_;
};

// The launchers for sets of one kind of element.
struct set_launchers {
  stated<const char *> name;
  stated<int> fields;
  // Writes packed rows in the pose `at`, in the order of the view; none where `rows` is null. *bad is as in order_findings;
  // there element i counts as element order[i] where order is not null. Where `bad` is null, nothing is checked. Widens
  // *around, unless it is null, by the boxes of the rows.
  stated<cudaError_t (*)(const view &v, const pose_matrix &at, const std::uint32_t *order, float *rows,
                         unsigned long long *bad, joined_box *around, cudaStream_t stream)>
      pose;
  // Writes n rows in each of `poses` poses, which lie in device memory, one pose after another: n * poses rows. *bad becomes
  // the first of these that is no row of its kind, or ~0.
  stated<cudaError_t (*)(const float *rows, std::uint32_t n, const pose_matrix *at, std::uint32_t poses, float *to,
                         unsigned long long *bad, cudaStream_t stream)>
      instances;
  // Keeps the elements that a pass over one of two sets does not rule out.
  stated<cudaError_t (*)(const sift_job &job, cudaStream_t stream)> sift;
  // pose() and places() at once, the order, and where can_arrange_tree() the tree as well, of 1 to most_to_arrange elements;
  // of one set, or of two beside each other. `jobs` is host memory.
  stated<cudaError_t (*)(const arrange_job *jobs, int count, cudaStream_t stream)> arrange;
  // For each row its place along Hilbert's curve through the cube around *around, below 2^(3 bits), and its number. *bad,
  // unless it is null, becomes less where a row is not good, as in order_findings.
  stated<cudaError_t (*)(const float *rows, std::uint32_t elements, const joined_box *around, int bits,
                         std::uint32_t *places, std::uint32_t *numbers, unsigned long long *bad, cudaStream_t stream)>
      places;
  // Brings rows into an order, and makes the two lowest levels of their tree.
  stated<cudaError_t (*)(const gather_job &job, cudaStream_t stream)> gather;
  // Fills the first levels_with_boxes() levels of the tree over the rows, as far as there are such. *arrived is 0 before and
  // after.
  stated<cudaError_t (*)(const float *rows, std::uint32_t elements, tree_node *nodes, unsigned *arrived,
                         cudaStream_t stream)>
      boxes;
};

// A part of the pairs of two sets: the pairs of their nodes, or of their elements, in two ranges.
struct part {
  std::uint32_t first_a, end_a, first_b, end_b;
};

// The steps that run on a list of candidates.
enum class step : std::uint8_t {
  reject, // keeps the pairs that the reject stage, certified in fp32, does not rule out, and that equal points do not settle
  plain_fp32,
  plain_fp64,
  plain_fp64x2,
  exact,
  certify_fp32,
  certify_rest, // fp64, double-double and the integers, for what certify_fp32 leaves
  tolerant,
};

// The steps that decide: each takes the pairs that the one before left unsure. count 0: there is no such rung.
struct cascade_steps {
  step of[2];
  int count;
};
constexpr cascade_steps steps_of(rung precision) {
  switch (precision) {
  case rung::fp32:
    return {{step::plain_fp32}, 1};
  case rung::fp64:
    return {{step::plain_fp64}, 1};
  case rung::fp64x2:
    return {{step::plain_fp64x2}, 1};
  case rung::exact:
    return {{step::exact}, 1};
  case rung::tolerant:
    return {{step::tolerant}, 1};
  case rung::certified:
    return {{step::certify_fp32, step::certify_rest}, 2};
  }
  return {{}, 0};
}

// For each element of a set, the slot of the element of another set that it meets first.
inline constexpr std::uint32_t no_slot = ~std::uint32_t{0};
struct first_met_job {
  const float *a, *b;           // the rows of both sets
  const std::uint32_t *order_b; // the elements of the slots of b
  const std::uint32_t
      *owner_b;           // their items; null: each is its own. The least counts where several are met at one point
  const index_pair *hits; // of slots
  std::size_t count;
  std::uint32_t *first; // by slots of a; no_slot at first, and where nothing is met
};
MEETC_HD inline std::uint32_t number_of_b(const first_met_job &job, std::uint32_t slot) {
  return job.owner_b ? job.owner_b[job.order_b[slot]] : job.order_b[slot];
}

// A walk of segments down the hierarchy of another set, each on its own. Rows of `a` are two points.
struct first_walk_job {
  const float *a, *b; // the rows of both sets
  fours_view tree;    // over b
  part of;            // slots
  // Pairs that are proved to touch, and pairs that may; of each segment at least all that are not proved to come later than one
  // that touches. Once one is full the walk stops early, and the counts may leave pairs out.
  pair_list hits, unsure;
  unsigned long long *taken;   // 0 at first
  unsigned long long *decided; // grows by the number of pairs that were looked at
  // Where one of these, of a and of b, says that a set is not in order, nothing is done. Null: it is.
  const order_findings *found_a, *found_b;
  std::uint32_t elements_a;

  MEETC_HD bool is_to_be_done() const {
    return (!found_a || is_order(*found_a, elements_a)) && (!found_b || is_order(*found_b, tree.shape.elements));
  }
};

// Where pairs of rows meet: their contact codes (meetc/contact/code.hpp).
struct contact_job {
  const float *a, *b;      // the rows of both sets
  const index_pair *pairs; // of rows
  std::size_t count;
  std::uint64_t *codes; // of each pair; undecided_code where double-double does not tell all of its signs
};
inline constexpr std::uint64_t undecided_code = ~std::uint64_t{0}; // which is no contact code

// The launchers of one predicate for lists of pairs.
struct pair_launchers {
  // Reads min(*in.count, in.capacity) pairs of slots of packed rows; hits go to `yes`, and pairs that reject keeps, or that
  // certify_fp32 cannot decide, to `left`. certify_rest decides all, writes no such list, and adds to left.count[0] how many
  // fp64 left to double-double, and to left.count[1] how many that left to the integers. Returns cudaErrorInvalidValue if the
  // scene does not ask for the rung, and for reject also unless the predicate `rejects`.
  stated<cudaError_t (*)(step which, const float *a, const float *b, pair_list in, pair_list yes, pair_list left,
                         cudaStream_t stream)>
      run;
  // Looks at further hits. Null: the predicate knows no order.
  stated<cudaError_t (*)(const first_met_job &job, cudaStream_t stream)> first_met;
  // Looks for them: each segment goes down alone, and certify_fp32 decides on the way. Null: the predicate knows no order, or
  // the scene does not ask for `certified`.
  stated<cudaError_t (*)(const first_walk_job &job, cudaStream_t stream)> walk_first;
  // Null: the scene asks for no sign that tells contacts.
  stated<cudaError_t (*)(const contact_job &job, cudaStream_t stream)> contacts;
};

struct predicate_launchers {
  stated<const char *> name;
  stated<int> kind_a, kind_b; // indices of the catalogue's kinds
  pair_launchers pairs;
  stated<bool> rejects;  // it has a reject stage
  stated<bool> by_boxes; // proved: it holds where the finite boxes of valid rows touch, and nowhere else
  stated<bool> by_balls; // proved: both operands are balls, or points, and it holds where these touch, and nowhere else
};

// The launchers of one formula, as formula_info describes it: `rows`, the columns' numbers and the values are device memory;
// `in` and `out`, which name the columns, are host memory.
struct formula_launchers {
  stated<const char *> name;
  stated<int> number_count, result_count;
  stated<cudaError_t (*)(const column *in, const std::uint32_t *rows, std::size_t n, float *const *out,
                         cudaStream_t stream)>
      float32;
  stated<cudaError_t (*)(const column *in, const std::uint32_t *rows, std::size_t n, double *const *out,
                         cudaStream_t stream)>
      float64;
};

struct catalogue {
  stated<const set_launchers *> kinds;
  stated<int> kind_count;
  stated<const predicate_launchers *> predicates;
  stated<int> predicate_count;
  stated<const formula_launchers *> formulas; // in the order of the host's catalogue
  stated<int> formula_count;
  // *faults becomes the bits of arithmetic_fault: what the device does not compute as the bounds assume.
  stated<cudaError_t (*)(unsigned *faults, cudaStream_t stream)> self_test;
};

} // namespace meetc::cuda

#endif
