// SPDX-License-Identifier: MIT
// A library in a process, asked through memory that both share.
#include "reach/kept_process.h"
#include "reach/shared_block.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>

namespace cageproof::judge {
namespace {

// Its size is sealed: who shares it could cut it off below this process.
Descriptor sealed_memory() {
  Descriptor made(memfd_create("block", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (made.get() < 0 || ftruncate(made.get(), 8 * static_cast<off_t>(shared_words)) != 0 ||
      fcntl(made.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
    throw InputError(fmt::format("no memory to share with foreign code: {}", std::strerror(errno)));
  Descriptor high(fcntl(made.get(), F_DUPFD_CLOEXEC, 20));
  return high;
}

class LibraryWorker final : public Worker {
 public:
  LibraryWorker(const std::string& path, const Limits& limits)
      : limits_(limits), memory_(sealed_memory()), process_("library", path, limits, memory_.get()) {
    void* const mapped = mmap(nullptr, 8 * shared_words, PROT_READ | PROT_WRITE, MAP_SHARED, memory_.get(), 0);
    if (mapped == MAP_FAILED)
      throw InputError(fmt::format("no memory to share with foreign code: {}", std::strerror(errno)));
    words_ = static_cast<double*>(mapped);
  }
  ~LibraryWorker() override { munmap(words_, 8 * shared_words); }

  Description describe() override {
    SharedHeader header{};
    header.op = SharedHeader::About;
    call(header, limits_.start_seconds);
    const char* const text = shared()->text;
    Description description;
    description.about = std::string(text, strnlen(text, sizeof header.text - 1));
    std::map<std::string, int> orders;
    for (const Formula& formula : catalogue()) {
      for (const bool single : {false, true}) {
        header = SharedHeader{};
        header.op = SharedHeader::Order;
        header.single = single ? 1 : 0;
        name(header, formula.name);
        call(header, limits_.seconds);
        orders[std::string(formula.name) + (single ? " float" : "")] =
            std::clamp(static_cast<int>(shared()->result), -1, 2);
      }
    }
    description.orders = std::move(orders);
    return description;
  }

  void ask(const Request& request, std::span<const Asked> asked, std::span<Answer> answers, double* nanoseconds,
           const Note& note) override {
    if (nanoseconds != nullptr) *nanoseconds = 0;
    for (std::size_t first = 0; first < asked.size();) {
      first = ask_some(request, asked, first, answers, nanoseconds, note);
      if (!told_of_output_ && process_.written_out() > 0) {
        told_of_output_ = true;
        note("standard output", fmt::format("it wrote to standard output ({} bytes)", process_.written_out()),
             first - 1);
      }
    }
  }

  std::vector<std::pair<std::string, std::string>> finish() override { return process_.finish(); }

 private:
  SharedHeader* shared() { return reinterpret_cast<SharedHeader*>(words_); }

  static void name(SharedHeader& header, std::string_view subject) {
    std::copy_n(subject.data(), std::min(subject.size(), sizeof header.formula - 1), header.formula);
  }

  static SharedHeader header_of(const Request& request, const Asked& asked) {
    SharedHeader header{};
    name(header, request.subject());
    if (request.formula == nullptr) {
      header.op = SharedHeader::Coordinates;
      header.dimension = asked.dimension;
      header.corner_count = static_cast<std::int32_t>(asked.corners.size()) / asked.dimension;
      header.parameter_count = static_cast<std::int32_t>(asked.faces.size());
      header.components = static_cast<std::int32_t>(asked.coordinates);
      return header;
    }
    const Formula& formula = *request.formula;
    header.op = SharedHeader::Evaluate;
    header.order = request.order;
    header.single = request.single ? 1 : 0;
    header.dimension = formula.dim();
    header.corner_count = formula.corners();
    header.parameter_count = static_cast<std::int32_t>(formula.parameters.size());
    header.components = formula.components();
    return header;
  }

  // Puts as many elements as there is room for, from one on; returns where the next begins.
  std::size_t ask_some(const Request& request, std::span<const Asked> asked, std::size_t first,
                       std::span<Answer> answers, double* nanoseconds, const Note& note) {
    SharedHeader header = header_of(request, asked[first]);
    // Elements have one layout; each cage has its own.
    const std::size_t most = request.formula != nullptr ? asked.size() - first : 1;
    std::vector<GroupLayout> places;
    for (std::size_t begin = header_words; places.size() < most; begin = places.back().end) {
      const Asked& one = asked[first + places.size()];
      const GroupLayout at(begin, header, one.count);
      if (at.end > shared_words) break;
      const std::uint64_t count = one.count;
      std::memcpy(words_ + at.count, &count, sizeof count);
      std::ranges::copy(one.corners, words_ + at.corners);
      if (request.formula == nullptr) std::ranges::copy(one.faces, words_ + at.parameters);
      else std::ranges::copy(one.parameters, words_ + at.parameters);
      std::ranges::copy(one.points, words_ + at.points);
      places.push_back(at);
    }
    if (places.empty()) throw Fault("too large", "a block of so many points does not fit into shared memory", first);
    header.groups = places.size();
    try {
      call(header, limits_.seconds);
    } catch (Fault& fault) {
      // Inputs before the one that it died at are done.
      const std::size_t at = std::min<std::size_t>(shared()->current, places.size() - 1);
      for (std::size_t g = 0; g < at; ++g) take(request, places[g], answers[first + g], first + g, note);
      fault.index = first + at;
      throw;
    }
    for (std::size_t g = 0; g < places.size(); ++g) take(request, places[g], answers[first + g], first + g, note);
    if (nanoseconds != nullptr) *nanoseconds += shared()->nanoseconds;
    return first + places.size();
  }

  void take(const Request& request, const GroupLayout& at, Answer& answer, std::size_t index, const Note& note) {
    std::int64_t code = 0;
    std::uint64_t flags = 0;
    std::memcpy(&code, words_ + at.code, sizeof code);
    std::memcpy(&flags, words_ + at.flags, sizeof flags);
    if (code == 1) {
      answer.status = Answer::Status::Declined;
      return;
    }
    if (code != 0) {
      note("error code", fmt::format("it returned {}, which is neither done nor declined", code), index);
      return;
    }
    if ((flags & changed_input) != 0)
      note("changed input",
           fmt::format("it changed the {} or points it was given", request.formula != nullptr ? "corners" : "cage"),
           index);
    bool is_whole = true;
    for (int o = 0; o <= request.order; ++o) {
      const double* const from = words_ + at.tensors[o];
      answer.tensors[o].assign(from, from + at.sizes[o]);
      for (const double x : answer.tensors[o]) is_whole = is_whole && std::bit_cast<std::uint64_t>(x) != unset_double;
    }
    if (!is_whole) note("short answer", "it left numbers of its output unset", index);
    answer.status = Answer::Status::Given;
  }

  void call(const SharedHeader& header, double seconds) {
    SharedHeader sent = header;
    sent.sequence = ++sequence_;
    std::memcpy(words_, &sent, sizeof sent);
    // A pipe takes eight bytes at once or not at all.
    if (process_.send(&sequence_, sizeof sequence_) != sizeof sequence_) throw died();
    const Clock::time_point until = in_seconds(seconds);
    switch (process_.wait(until, false)) {
      case KeptProcess::Event::Late: throw process_.fault("hang", fmt::format("no answer within {:g} s", seconds));
      case KeptProcess::Event::Readable: break;
      default: throw died();
    }
    std::uint64_t answer = 0;
    const ssize_t count = read(process_.answers(), &answer, sizeof answer);
    if (count == 0) throw died();
    if (count != sizeof answer || answer != sequence_)
      throw process_.fault("garbage", "it wrote to a descriptor that is none of its own");
  }

  Fault died() {
    Fault fault = process_.fault("crash", "its process ended");
    const std::string where(shared()->text, strnlen(shared()->text, sizeof shared()->text - 1));
    return where.empty() ? fault : Fault(fault.kind, fmt::format("{}: {}", fault.what(), where), fault.index);
  }

  Limits limits_;
  Descriptor memory_;
  double* words_ = nullptr;
  std::uint64_t sequence_ = 0;
  bool told_of_output_ = false;
  KeptProcess process_;
};

}  // namespace

std::unique_ptr<Worker> library_worker(const std::string& path, const Limits& limits) {
  return std::make_unique<LibraryWorker>(path, limits);
}

}  // namespace cageproof::judge
