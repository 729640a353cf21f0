#include "meet/core/device/collide.hpp"
#include "meet/core/device/set/narrow.hpp"
#include "meet/core/device/world.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/device/dlpack.hpp"
#include "meet/python/device/the_device.hpp"
#include "meet/python/poses.hpp"
#include "meet/python/questions.hpp"
#include "meet/python/signals.hpp"
#include "meet/python/worlds.hpp"

#include <cga/cga_cuda.hpp>
#include <cuda_runtime_api.h>
#include <unistd.h>

namespace meetc::python {

// It is never given back, since CUDA may end before this module.
const device &the_device() {
  static const device &on = *new device(cga::cuda::catalogue());
  static const pid_t begun = getpid();
  if (getpid() != begun)
    throw device_error("CUDA does not survive a fork: start the process anew, as multiprocessing's \"spawn\" does");
  return on;
}

namespace {

// Numbers in device memory: the address of the first, the number of rows, and the bytes from row to row.
using rows_there = std::tuple<std::uintptr_t, std::uint32_t, std::size_t>;

// A set whose indices were 64 bits wide, and the memory in which they are 32 bits wide.
struct narrowed_set {
  device_memory<std::uint32_t> index;
  device_set set;
};

void require_there(std::uintptr_t address, const char *name) {
  cudaPointerAttributes found{};
  check(cudaPointerGetAttributes(&found, reinterpret_cast<const void *>(address)), name);
  int current = 0;
  check(cudaGetDevice(&current), name);
  const bool managed = found.type == cudaMemoryTypeManaged;
  if (!managed && (found.type != cudaMemoryTypeDevice || found.device != current))
    throw device_error(std::string(name) + ": it does not lie on CUDA device " + std::to_string(current));
}

std::shared_ptr<device_set> given(const std::string &kind, const rows_there &numbers,
                                  const std::optional<rows_there> &index, const std::optional<py::array> &at) {
  const kind_info &of = kind_named(kind);
  const device &on = the_device();
  const auto [data, rows, stride] = numbers;
  require_there(data, "vertices");
  cuda::view there{reinterpret_cast<const float *>(data), stride, nullptr, rows, rows};
  device_memory<std::uint32_t> narrow;
  if (index) {
    const auto [first, elements, packed] = *index;
    require_there(first, "faces");
    const std::size_t corners = static_cast<std::size_t>(of.points) * elements;
    if (packed == sizeof(std::int64_t) * static_cast<std::size_t>(of.points)) {
      const py::gil_scoped_release others_run;
      const auto lock = on.use();
      there.index = narrow.reserve(corners, "faces");
      check(
          on_device::narrow_indices(reinterpret_cast<const std::int64_t *>(first), corners, narrow.data(), on.stream()),
          "faces");
      check(cudaStreamSynchronize(on.stream()), "faces");
    } else if (packed == sizeof(std::uint32_t) * static_cast<std::size_t>(of.points)) {
      there.index = reinterpret_cast<const std::uint32_t *>(first);
    } else {
      throw py::type_error("faces: rows are not packed");
    }
    there.elements = elements;
  }
  const std::optional<pose> place = at ? std::optional(place_of(*at, of)) : std::nullopt;
  const py::gil_scoped_release others_run; // one of them may have the device, and need the interpreter to end its query
  const auto set = std::make_shared<narrowed_set>(narrowed_set{std::move(narrow), device_set::given(on, there, of)});
  if (place)
    set->set.move(*place);
  return {set, &set->set};
}

std::shared_ptr<device_set> upload(const std::shared_ptr<prepared> &set) {
  const device &on = the_device();
  const py::gil_scoped_release others_run;
  return std::make_shared<device_set>(on, *set);
}

void wait_for(std::uintptr_t stream) {
  the_device();
  const py::gil_scoped_release others_run;
  check(cudaStreamSynchronize(reinterpret_cast<cudaStream_t>(stream)), "the stream of an array");
}

// Two sets there, in the order of the predicate's kinds.
struct question_there {
  std::shared_ptr<device_set> a, b;
  std::string predicate, precision;
  std::optional<py::array> owner_a, owner_b;

  result ask(answer_kind want, bool first_met) const {
    device_options options;
    options.want = want;
    options.first_met = first_met;
    options.owner_a = owners_of(owner_a);
    options.owner_b = owners_of(owner_b);
    options.progress = check_signals();
    const predicate_info &by = predicate_named(predicate);
    const rung with = rung_named(precision);
    const device &on = the_device();
    const py::gil_scoped_release others_run;
    return collide(on, *a, *b, by, with, options);
  }

  // For each pose of the second set, or of the first, the number of pairs. The device takes many poses of the second at once,
  // where items are elements; otherwise it moves the set, which must be the caller's alone, and asks again.
  py::array poses(bool still_first, const py::array &at, bool any) const {
    require_packed(at, "f", 8, 2, "poses");
    if (at.shape(1) != 12)
      throw py::type_error("poses: twelve numbers are needed for each");
    device_set &moved = still_first ? *b : *a;
    std::vector<pose> places;
    const std::span<const double> numbers = span_of<double>(at);
    for (std::size_t i = 0; i < numbers.size(); i += 12)
      places.push_back(pose_of(numbers.subspan(i, 12), moved.kind()));
    device_options options;
    options.want = any ? answer_kind::any : answer_kind::count;
    options.progress = check_signals();
    const predicate_info &by = predicate_named(predicate);
    const rung with = rung_named(precision);
    const device &on = the_device();
    std::vector<std::uint64_t> found;
    {
      const py::gil_scoped_release others_run;
      if (still_first && !owner_a && !owner_b) {
        found = collide(on, *a, *b, places, by, with, options).counts;
      } else {
        options.owner_a = owners_of(owner_a), options.owner_b = owners_of(owner_b);
        for (std::size_t i = 0; i < places.size(); ++i)
          try {
            moved.move(places[i]);
            found.push_back(collide(on, *a, *b, by, with, options).count);
          } catch (const input_error &e) {
            throw input_error(e.where, moved.kind(), "pose " + std::to_string(i) + ": ");
          }
      }
    }
    return as_array<std::int64_t>(std::move(found));
  }
};

// A world, whose bodies lie on the device.
struct world_there {
  std::shared_ptr<world> of;
  device_world there;

  explicit world_there(std::shared_ptr<world> bodies) : of(std::move(bodies)), there(the_device(), *of) {}
};

world_answer ask(world_there &w, world_options &options) {
  options.progress = check_signals();
  const py::gil_scoped_release others_run;
  return w.there.touching(options);
}

} // namespace

void bind_device(py::module_ &module) {
  py::register_exception<device_error>(module, "DeviceFault", PyExc_RuntimeError);
  py::class_<device_set, std::shared_ptr<device_set>>(module, "SetThere", "Elements on the CUDA device.")
      .def_property_readonly("elements", &device_set::elements);
  module.def("given", &given, py::arg("kind"), py::arg("numbers"), py::arg("index"), py::arg("pose"));
  module.def("upload", &upload, py::arg("set"));
  module.def("wait_for", &wait_for, py::arg("stream"));
  module.def("device_name", [] { return the_device().facts().name; });
  module.def("from_dlpack", &from_dlpack, py::arg("capsule"));
  py::class_<question_there> question(module, "QuestionThere",
                                      "Two sets on the device, in the order of the predicate's kinds.");
  question.def(py::init([](std::shared_ptr<device_set> a, std::shared_ptr<device_set> b, std::string predicate,
                           std::string precision, std::optional<py::array> owner_a, std::optional<py::array> owner_b) {
                 return question_there{std::move(a),         std::move(b),       std::move(predicate),
                                       std::move(precision), std::move(owner_a), std::move(owner_b)};
               }),
               py::arg("a"), py::arg("b"), py::arg("predicate"), py::arg("precision"), py::arg("owner_a"),
               py::arg("owner_b"));
  bind_answers(question);
  question.def("poses", &question_there::poses, py::arg("still_first"), py::arg("poses"), py::arg("any"));
  py::class_<world_there> bodies(module, "WorldThere",
                                 "A World that is asked on the device. It is asked by one thread.");
  bodies.def(py::init<std::shared_ptr<world>>(), py::arg("world"));
  bind_bodies<&ask>(bodies);
  bind_evaluate_there(module);
}

} // namespace meetc::python
