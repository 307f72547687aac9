// SPDX-License-Identifier: MIT
// A program that answers lines, many of them in flight.
#include "reach/json_answer.h"
#include "reach/kept_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace cageproof::judge {
namespace {

class CommandWorker final : public Worker {
 public:
  CommandWorker(const std::string& command, const Limits& limits)
      : limits_(limits), process_("command", command, limits, -1) {}

  Description describe() override {
    std::string line;
    const std::string asked = describe_line;
    exchange(asked, 1, limits_.start_seconds, [&](std::string_view answer) { line = answer; });
    return parse_description(line);
  }

  void ask(const Request& request, std::span<const Asked> asked, std::span<Answer> answers, double* nanoseconds,
           const Note& note) override {
    struct Place {
      std::size_t element, point;
    };
    std::vector<Place> places;
    std::string text;
    for (std::size_t i = 0; i < asked.size(); ++i)
      // A cage's points stand in one line.
      for (std::size_t p = 0; p < (request.formula != nullptr ? asked[i].count : 1); ++p) {
        add_line(text, request, asked[i], p);
        places.push_back({i, p});
      }
    const Clock::time_point start = Clock::now();
    std::size_t next = 0;
    const auto take = [&](std::string_view line) {
      const auto [element, point] = places[next];
      Answer& answer = answers[element];
      if (point == 0) answer.status = Answer::Status::Given;
      LineAnswer found = parse_answer(line, request, asked[element]);
      switch (found.kind) {
        case LineAnswer::Kind::Given:
          put(request, request.formula != nullptr ? asked[element].count : 1, point, found, answer);
          break;
        case LineAnswer::Kind::Error: answer.status = Answer::Status::Declined; break;
        case LineAnswer::Kind::Short:
          answer.status = Answer::Status::Failed;
          note("short answer", found.text, element);
          break;
        case LineAnswer::Kind::Garbage:
          answer.status = Answer::Status::Failed;
          throw process_.fault("garbage", found.text);
      }
      ++next;
    };
    try {
      exchange(text, places.size(), limits_.seconds, take);
    } catch (Fault& fault) {
      fault.index = places[std::min(next, places.size() - 1)].element;
      answers[fault.index].status = Answer::Status::Failed;
      throw;
    }
    if (nanoseconds != nullptr) *nanoseconds = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  }

  std::vector<std::pair<std::string, std::string>> finish() override {
    auto found = process_.finish();
    // Answers that nobody asked for may come after the last one that was.
    std::array<char, 4096> bytes{};
    const ssize_t count = read(process_.answers(), bytes.data(), bytes.size());
    if (count > 0) unread_.append(bytes.data(), static_cast<std::size_t>(count));
    if (unread_.find_first_not_of(" \t\r\n") != std::string::npos) found.emplace_back("garbage", too_many);
    return found;
  }

 private:
  static void put(const Request& request, std::size_t count, std::size_t point, const LineAnswer& found,
                  Answer& answer) {
    // One point that failed or was declined is the whole answer's.
    if (answer.status != Answer::Status::Given) return;
    for (int o = 0; o <= request.order; ++o) {
      const std::vector<double>& numbers = found.tensors[o];
      answer.tensors[o].resize(count * numbers.size());
      std::ranges::copy(numbers, answer.tensors[o].begin() + static_cast<std::ptrdiff_t>(point * numbers.size()));
    }
  }

  // Sends lines and takes as many, while it does both as it can.
  void exchange(std::string_view text, std::size_t lines, double seconds,
                const std::function<void(std::string_view)>& take) {
    if (!unread_.empty() || process_.wait(Clock::now(), false) == KeptProcess::Event::Readable)
      throw process_.fault("garbage", too_many);
    Clock::time_point until = in_seconds(seconds);
    while (lines > 0) {
      // Bytes that make up no line are no answer, however many there are.
      if (Clock::now() > until) throw late(seconds);
      switch (process_.wait(until, !text.empty())) {
        case KeptProcess::Event::Late: throw late(seconds);
        case KeptProcess::Event::Ended: throw process_.fault("crash", "its process closed its output");
        case KeptProcess::Event::Writable:
          if (const ssize_t sent = process_.send(text.data(), text.size()); sent > 0)
            text.remove_prefix(static_cast<std::size_t>(sent));
          else if (errno != EAGAIN) throw process_.fault("crash", "it closed its standard input");
          break;
        case KeptProcess::Event::Readable:
          if (const std::size_t taken = read_lines(lines, take); taken > 0) {
            lines -= taken;
            until = in_seconds(seconds);
          }
      }
    }
  }

  Fault late(double seconds) {
    return process_.fault("hang", fmt::format("no answer within {:g} s: it hangs, does not flush its output after each "
                                              "line, or needs more time (--seconds)",
                                              seconds));
  }

  std::size_t read_lines(std::size_t most, const std::function<void(std::string_view)>& take) {
    std::array<char, 65536> bytes{};
    const ssize_t count = read(process_.answers(), bytes.data(), bytes.size());
    if (count == 0) throw process_.fault("crash", "its process closed its output");
    if (count < 0) return 0;
    unread_.append(bytes.data(), static_cast<std::size_t>(count));
    std::size_t taken = 0, begin = 0;
    for (std::size_t end = 0; taken < most && (end = unread_.find('\n', begin)) != std::string::npos; begin = end + 1) {
      const std::string_view line = std::string_view(unread_).substr(begin, end - begin);
      if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
      take(line);
      ++taken;
    }
    unread_.erase(0, begin);
    // The longest answer is some thousand numbers.
    constexpr std::size_t longest = 1U << 20U;
    if (unread_.size() > longest)
      throw process_.fault("garbage", fmt::format("it wrote a line of more than {} bytes", longest));
    return taken;
  }

  static constexpr const char* too_many = "it wrote more lines to standard output than it was asked for";

  Limits limits_;
  std::string unread_;
  KeptProcess process_;
};

}  // namespace

std::unique_ptr<Worker> command_worker(const std::string& command, const Limits& limits) {
  return std::make_unique<CommandWorker>(command, limits);
}

}  // namespace cageproof::judge
