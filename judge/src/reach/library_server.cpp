// SPDX-License-Identifier: MIT
#include "reach/library_server.h"

#include "reach/guarded.h"
#include "reach/shared_block.h"

#include "cageproof_judge.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>

namespace cageproof::judge {
namespace {

struct Library {
  decltype(&cageproof_judge_version) version;
  decltype(&cageproof_judge_about) about;
  decltype(&cageproof_judge_order) order;
  decltype(&cageproof_judge_double) in_double;
  decltype(&cageproof_judge_float) in_float;
  decltype(&cageproof_judge_coordinates) coordinates;
  decltype(&cageproof_judge_plane_coordinates) plane_coordinates;
};

template <class F>
void find(void* handle, const char* name, F& function) {
  void* const found = dlsym(handle, name);
  std::memcpy(&function, &found, sizeof found);
}

bool load(const char* path, Library& library) {
  void* const handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return false;
  }
  find(handle, "cageproof_judge_version", library.version);
  find(handle, "cageproof_judge_about", library.about);
  find(handle, "cageproof_judge_order", library.order);
  find(handle, "cageproof_judge_double", library.in_double);
  find(handle, "cageproof_judge_float", library.in_float);
  find(handle, "cageproof_judge_coordinates", library.coordinates);
  find(handle, "cageproof_judge_plane_coordinates", library.plane_coordinates);
  const bool has_elements = library.order != nullptr && library.in_double != nullptr;
  const bool has_cages = library.coordinates != nullptr || library.plane_coordinates != nullptr;
  if (library.version == nullptr || (!has_cages && !has_elements)) {
    std::fprintf(stderr, "%s exports no %s: include cageproof_judge.h and define it (in C++ as extern \"C\")\n", path,
                 library.version == nullptr ? "cageproof_judge_version"
                 : library.order == nullptr ? "cageproof_judge_order"
                                            : "cageproof_judge_double");
    return false;
  }
  if (!has_elements) library.order = nullptr;
  const int version = library.version();
  if (version == CAGEPROOF_JUDGE_VERSION) return true;
  std::fprintf(stderr, "%s was built with version %d of cageproof_judge.h; this program has version %d\n", path,
               version, CAGEPROOF_JUDGE_VERSION);
  return false;
}

// The arrays that a library is given, each right before a page that nobody may touch.
struct Arrays {
  Guarded corners{"corners"}, parameters{"parameters"}, points{"points"};
  std::array<Guarded, 3> tensors{Guarded{"values"}, Guarded{"gradients"}, Guarded{"hessians"}};
  Guarded vertices{"vertices"}, faces{"faces"}, coordinates{"coordinates"};
};

SharedHeader* shared = nullptr;
Arrays* arrays = nullptr;

// Says which array was left, if one was; the process then dies as it would have.
void on_fault(int signal, siginfo_t* info, void*) {
  const auto tell = [&](const Guarded& array) {
    if (array.is_guard(info->si_addr))
      std::snprintf(shared->text, sizeof shared->text, "it touched memory beyond the end of `%s`", array.name());
  };
  tell(arrays->corners);
  tell(arrays->parameters);
  tell(arrays->points);
  for (const Guarded& tensor : arrays->tensors) tell(tensor);
  tell(arrays->vertices);
  tell(arrays->faces);
  tell(arrays->coordinates);
  std::signal(signal, SIG_DFL);
  raise(signal);
}

void watch_faults() {
  static std::array<char, 65536> stack;
  const stack_t alternative{stack.data(), 0, stack.size()};
  sigaltstack(&alternative, nullptr);
  struct sigaction action {};
  action.sa_sigaction = on_fault;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
  for (const int signal : {SIGSEGV, SIGBUS}) sigaction(signal, &action, nullptr);
}

template <class R>
R* copied(Guarded& array, const double* from, std::size_t count) {
  R* const to = array.take<R>(count);
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<R>(from[i]);
  return to;
}

template <class R>
bool is_changed(const R* array, const double* from, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    // NaN and the sign of zero count, too.
    using Bits = std::conditional_t<sizeof(R) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
    if (std::bit_cast<Bits>(static_cast<R>(from[i])) != std::bit_cast<Bits>(array[i])) return true;
  }
  return false;
}

template <class R, class Function>
void evaluate_one(Function function, const GroupLayout& at, double* words) {
  using Bits = std::conditional_t<sizeof(R) == 8, std::uint64_t, std::uint32_t>;
  constexpr Bits unset = sizeof(R) == 8 ? static_cast<Bits>(unset_double) : unset_float;
  const SharedHeader& h = *shared;
  std::uint64_t count = 0;
  std::memcpy(&count, words + at.count, sizeof count);
  const std::size_t corner_numbers = at.parameters - at.corners, point_numbers = at.tensors[0] - at.points;
  const cageproof_judge_block block{h.formula,
                                    h.order,
                                    h.dimension,
                                    h.corner_count,
                                    h.parameter_count,
                                    h.components,
                                    static_cast<std::size_t>(count)};
  R* const corners = copied<R>(arrays->corners, words + at.corners, corner_numbers);
  R* const points = copied<R>(arrays->points, words + at.points, point_numbers);
  R* const parameters = copied<R>(arrays->parameters, words + at.parameters, at.points - at.parameters);
  std::array<R*, 3> tensors{};
  for (std::size_t o = 0; o < 3; ++o) {
    if (at.sizes[o] == 0) continue;
    tensors[o] = arrays->tensors[o].template take<R>(at.sizes[o]);
    for (std::size_t i = 0; i < at.sizes[o]; ++i) tensors[o][i] = std::bit_cast<R>(unset);
  }
  const auto start = std::chrono::steady_clock::now();
  const int code = function(&block, corners, h.parameter_count > 0 ? parameters : nullptr, points, tensors[0],
                            tensors[1], tensors[2]);
  shared->nanoseconds += std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  const std::int64_t stored = code;
  std::memcpy(words + at.code, &stored, sizeof stored);
  const std::uint64_t flags =
      is_changed(corners, words + at.corners, corner_numbers) || is_changed(points, words + at.points, point_numbers)
          ? changed_input
          : 0;
  std::memcpy(words + at.flags, &flags, sizeof flags);
  for (std::size_t o = 0; o < 3; ++o)
    for (std::size_t i = 0; i < at.sizes[o]; ++i) {
      const bool is_unset = std::bit_cast<Bits>(tensors[o][i]) == unset;
      words[at.tensors[o] + i] = is_unset ? std::bit_cast<double>(unset_double) : static_cast<double>(tensors[o][i]);
    }
}

void evaluate_cage(const Library& library, double* words) {
  const SharedHeader& h = *shared;
  shared->current = 0;
  std::uint64_t count = 0;
  std::memcpy(&count, words + header_words, sizeof count);
  const GroupLayout at(header_words, h, count);
  const std::size_t vertex_numbers = at.parameters - at.corners, face_numbers = at.points - at.parameters;
  const std::size_t point_numbers = at.tensors[0] - at.points;
  const auto dimension = static_cast<std::size_t>(h.dimension);
  const auto function = h.dimension == 2 ? library.plane_coordinates : library.coordinates;
  const cageproof_judge_cage cage{h.formula, vertex_numbers / dimension, face_numbers / dimension,
                                  static_cast<std::size_t>(h.components), static_cast<std::size_t>(count)};
  double* const vertices = copied<double>(arrays->vertices, words + at.corners, vertex_numbers);
  int* const faces = copied<int>(arrays->faces, words + at.parameters, face_numbers);
  double* const points = copied<double>(arrays->points, words + at.points, point_numbers);
  double* const coordinates = arrays->coordinates.take<double>(at.sizes[0]);
  std::fill_n(coordinates, at.sizes[0], std::bit_cast<double>(unset_double));
  const auto start = std::chrono::steady_clock::now();
  const std::int64_t code =
      function == nullptr ? CAGEPROOF_JUDGE_DECLINED : function(&cage, vertices, faces, points, coordinates);
  shared->nanoseconds = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  std::memcpy(words + at.code, &code, sizeof code);
  bool changed =
      is_changed(vertices, words + at.corners, vertex_numbers) || is_changed(points, words + at.points, point_numbers);
  for (std::size_t i = 0; i < face_numbers; ++i) changed = changed || faces[i] != words[at.parameters + i];
  const std::uint64_t flags = changed ? changed_input : 0;
  std::memcpy(words + at.flags, &flags, sizeof flags);
  std::copy_n(coordinates, at.sizes[0], words + at.tensors[0]);
}

// A library that closes descriptors is noticed here, because at the end only the answer of the whole block would be
// missed.
void require_descriptors() {
  if (fcntl(descriptor::answers, F_GETFD) >= 0) return;
  std::snprintf(shared->text, sizeof shared->text, "it closed a file that it did not open");
  std::abort();
}

void evaluate(const Library& library, double* words) {
  shared->nanoseconds = 0;
  std::size_t begin = header_words;
  const std::uint64_t groups = shared->groups;
  for (std::uint64_t g = 0; g < groups; ++g) {
    shared->current = g;
    std::uint64_t count = 0;
    std::memcpy(&count, words + begin, sizeof count);
    const GroupLayout at(begin, *shared, count);
    if (shared->single != 0) evaluate_one<float>(library.in_float, at, words);
    else evaluate_one<double>(library.in_double, at, words);
    require_descriptors();
    begin = at.end;
  }
}

int order_of(const Library& library) {
  if (library.order == nullptr || (shared->single != 0 && library.in_float == nullptr)) return -1;
  return library.order(shared->formula);
}

}  // namespace

int serve_library(const char* path) {
  void* const memory = mmap(nullptr, 8 * shared_words, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor::memory, 0);
  if (memory == MAP_FAILED) {
    std::perror("memory shared with a library");
    return 1;
  }
  shared = static_cast<SharedHeader*>(memory);
  Arrays own;
  arrays = &own;
  watch_faults();
  Library library{};
  if (!load(path, library)) return cannot_load;
  std::uint64_t sequence = 0;
  while (read(descriptor::requests, &sequence, sizeof sequence) == sizeof sequence) {
    switch (shared->op) {
      case SharedHeader::About:
        std::snprintf(shared->text, sizeof shared->text, "%s", library.about != nullptr ? library.about() : "");
        break;
      case SharedHeader::Order: shared->result = order_of(library); break;
      case SharedHeader::Coordinates:
        evaluate_cage(library, static_cast<double*>(memory));
        require_descriptors();
        break;
      default: evaluate(library, static_cast<double*>(memory));
    }
    std::fflush(stdout);
    if (write(descriptor::answers, &sequence, sizeof sequence) != sizeof sequence) return 1;
  }
  return 0;
}

}  // namespace cageproof::judge
