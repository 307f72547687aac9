// SPDX-License-Identifier: MIT
#include "svg_text.h"

#include "svg_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace cageproof::svg {
namespace {

// The commands that are no straight edges.
std::string_view curve_of(char command) {
  switch (std::toupper(static_cast<unsigned char>(command))) {
    case 'C': return "a cubic Bezier curve";
    case 'S': return "a smooth cubic Bezier curve";
    case 'Q': return "a quadratic Bezier curve";
    case 'T': return "a smooth quadratic Bezier curve";
    case 'A': return "an elliptical arc";
    default: return "";
  }
}

class PathParser {
 public:
  explicit PathParser(std::string_view data) : scanner_(data) {}

  std::vector<Subpath> parse() {
    while (!scanner_.at_end()) {
      const char command = scanner_.peek();
      if (const std::string_view curve = curve_of(command); !curve.empty())
        throw Fault{fmt::format("{} (command {}): a polygon's edges are straight", curve, command)};
      if (std::string_view("MmLlHhVvZz").find(command) == std::string_view::npos)
        throw Fault{scanner_.shown() + " is not a path command"};
      if (!begun_ && command != 'M' && command != 'm')
        throw Fault{fmt::format("path data begins with {}, not with a moveto", command)};
      scanner_.skip();
      run(command);
    }
    finish();
    return std::move(subpaths_);
  }

 private:
  void run(char command) {
    const bool relative = command >= 'a';
    switch (std::toupper(static_cast<unsigned char>(command))) {
      case 'Z': return close();
      case 'M': return move(relative);
      case 'L': return repeat([&] { line_to(point(relative)); });
      case 'H': return repeat([&] { line_to({horizontal(relative), current_.y}); });
      default: return repeat([&] { line_to({current_.x, vertical(relative)}); });
    }
  }

  // Arguments may follow each other without their command.
  template <class F>
  void repeat(F&& once) {
    once();
    for (;;) {
      scanner_.at_end();
      const bool comma = scanner_.take(',');
      if (!comma && !scanner_.has_number()) return;
      once();
    }
  }
  Rational horizontal(bool relative) {
    const Rational x = scanner_.number();
    return relative ? Rational(current_.x + x) : x;
  }
  Rational vertical(bool relative) {
    const Rational y = scanner_.number();
    return relative ? Rational(current_.y + y) : y;
  }
  Point point(bool relative) {
    Rational x = horizontal(relative);
    scanner_.separate();
    return {std::move(x), vertical(relative)};
  }

  void move(bool relative) {
    bool first = true;
    repeat([&] {
      const Point to = point(relative);
      if (first) {
        finish();
        start_ = current_ = to;
        begun_ = true;
      } else {
        line_to(to);
      }
      first = false;
    });
  }
  void line_to(Point to) {
    if (open_.points.empty()) open_.points.push_back(start_);
    open_.points.push_back(to);
    current_ = std::move(to);
  }
  void close() {
    open_.closed = true;
    finish();
    // A command that follows without a moveto begins where this subpath began.
    current_ = start_;
  }
  void finish() {
    if (!open_.points.empty()) subpaths_.push_back(std::move(open_));
    open_ = {};
  }

  Scanner scanner_;
  std::vector<Subpath> subpaths_;
  Subpath open_;
  Point start_, current_;
  bool begun_ = false;
};

// Sine or cosine of an angle in degrees, to 200 digits; of multiples of 30 as they are.
template <class Function>
Rational of_angle(const Rational& degrees, Function function) {
  constexpr unsigned long full_turn = 360;
  const Mp200 angle = exact::to_mp(degrees);
  Mp200 value;
  function(value.data(), angle.data(), full_turn, MPFR_RNDN);
  Rational result;
  mpfr_get_q(result.backend().data(), value.data());
  return result;
}
Rational cosine(const Rational& degrees) { return of_angle(degrees, mpfr_cosu); }
Rational sine(const Rational& degrees) { return of_angle(degrees, mpfr_sinu); }
Rational tangent(const Rational& degrees) {
  const Rational cos = cosine(degrees);
  if (cos == 0) throw Fault{"a skew by a right angle"};
  return sine(degrees) / cos;
}

Transform rotation(const std::vector<Rational>& n) {
  const Rational c = cosine(n[0]), s = sine(n[0]);
  Transform turn{c, s, Rational(-s), c, 0, 0};
  if (n.size() == 1) return turn;
  const Transform there{1, 0, 0, 1, n[1], n[2]}, back{1, 0, 0, 1, Rational(-n[1]), Rational(-n[2])};
  return there.after(turn.after(back));
}

struct Kind {
  std::string_view name;
  std::vector<std::size_t> counts;  // of numbers that it takes
  Transform (*make)(const std::vector<Rational>& numbers);
};

const std::vector<Kind>& kinds() {
  using Numbers = std::vector<Rational>;
  static const std::vector<Kind> all{
      {"matrix", {6}, [](const Numbers& n) { return Transform{n[0], n[1], n[2], n[3], n[4], n[5]}; }},
      {"translate", {1, 2}, [](const Numbers& n) { return Transform{1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0}; }},
      {"scale", {1, 2}, [](const Numbers& n) { return Transform{n[0], 0, 0, n.back(), 0, 0}; }},
      {"rotate", {1, 3}, rotation},
      {"skewX", {1}, [](const Numbers& n) { return Transform{1, 0, tangent(n[0]), 1, 0, 0}; }},
      {"skewY", {1}, [](const Numbers& n) { return Transform{1, tangent(n[0]), 0, 1, 0, 0}; }}};
  return all;
}

Transform take_transform(Scanner& scanner) {
  const std::string at = scanner.shown();
  const std::string_view name = scanner.take_word();
  const auto kind = std::ranges::find(kinds(), name, &Kind::name);
  if (kind == kinds().end() || !scanner.take('(')) throw Fault{at + " is not a transform that is read"};
  std::vector<Rational> numbers;
  while (!scanner.take(')')) {
    numbers.push_back(scanner.number());
    scanner.separate();
  }
  if (std::ranges::find(kind->counts, numbers.size()) == kind->counts.end())
    throw Fault{fmt::format("{} with {} numbers", name, numbers.size())};
  return kind->make(numbers);
}

}  // namespace

std::vector<Subpath> parse_path(std::string_view data) {
  Scanner scanner(data);
  if (scanner.take_word() == "none" && scanner.at_end()) return {};
  return PathParser(data).parse();
}

std::vector<Point> parse_points(std::string_view text) {
  std::vector<Point> points;
  Scanner scanner(text);
  while (!scanner.at_end()) {
    Rational x = scanner.number();
    scanner.separate();
    Rational y = scanner.number();
    scanner.separate();
    points.push_back({std::move(x), std::move(y)});
  }
  return points;
}

Rational parse_length(std::string_view text, const std::optional<Rational>& whole) {
  static const std::array<std::pair<std::string_view, Rational>, 8> units{{{"", 1},
                                                                           {"px", 1},
                                                                           {"in", 96},
                                                                           {"cm", {4800, 127}},
                                                                           {"mm", {480, 127}},
                                                                           {"q", {120, 127}},
                                                                           {"pt", {4, 3}},
                                                                           {"pc", 16}}};
  Scanner scanner(text);
  const Rational number = scanner.number();
  const std::string rest = scanner.shown();
  if (scanner.take('%')) {
    if (!scanner.at_end()) throw Fault{rest + " after a number"};
    if (!whole) throw Fault{"a percentage of a drawing without viewBox; write it in user units"};
    return number * *whole / 100;
  }
  std::string unit(scanner.take_word());
  std::ranges::transform(unit, unit.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* const found = std::ranges::find(units, unit, [](const auto& u) { return u.first; });
  if (!scanner.at_end() || found == units.end())
    throw Fault{rest + " after a number; lengths are in user units, px, in, cm, mm, Q, pt, pc or %"};
  return number * found->second;
}

Transform Transform::after(const Transform& inner) const {
  const Point x{inner.a, inner.b}, y{inner.c, inner.d}, at = (*this)({inner.e, inner.f});
  return {a * x.x + c * x.y, b * x.x + d * x.y, a * y.x + c * y.y, b * y.x + d * y.y, at.x, at.y};
}

std::size_t Transform::bits() const {
  std::size_t most = 0;
  for (const Rational* x : {&a, &b, &c, &d, &e, &f}) {
    const mpq_srcptr q = x->backend().data();
    most = std::max(most, mpz_sizeinbase(mpq_numref(q), 2) + mpz_sizeinbase(mpq_denref(q), 2));
  }
  return most;
}

Transform parse_transform(std::string_view text) {
  Transform all;
  Scanner scanner(text);
  while (!scanner.at_end()) {
    all = all.after(take_transform(scanner));
    if (all.bits() > Transform::kMostBits) throw Fault{Transform::kTooMany};
    scanner.separate();
  }
  return all;
}

}  // namespace cageproof::svg
