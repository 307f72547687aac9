// SPDX-License-Identifier: MIT
#include "cages/cage_questions.h"

#include "cageproof/validation/cage_errors.h"
#include "cages/inside_limit.h"
#include "cages/point_inside.h"
#include "cages/rest_products.h"
#include "cages/second_route_error.h"
#include "cageproof/validation/scheme_errors.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using Found = std::array<Finding, 3>;
using Ask = std::function<Found(const CageAt&)>;

// Of questions that ask for no derivative.
constexpr Orders values_alone{0, 0};

bool is_off_cage(std::string_view place) { return place == name_of(Place::Inside) || place == name_of(Place::Outside); }

// A NaN is a sample without truth where that is excused, and else one whose figure was lost.
Finding finding_of(const CageError& error, const CageAt& at) {
  if (!std::isnan(error.roundings)) return {Finding::Status::Measured, error.roundings, error.relative};
  return {at.is_excused() ? Finding::Status::NoTruth : Finding::Status::Unreached};
}

Finding finding_of(double error, const CageAt& at) { return finding_of(CageError{error, error}, at); }

// Whether the trace of any block's Hessian is known.
bool has_laplacian(const CageCoordinates& coordinates) {
  return std::ranges::any_of(coordinates.blocks(), [](const CoordinateBlock& block) {
    return block.trace.kind != CoordinateBlock::Trace::Kind::Unknown;
  });
}

// The questions of one place.
class Factory {
 public:
  Factory(const CageSubject& subject, std::string_view place, int order)
      : subject_(subject), kind_(subject.kind()), place_(place), order_(order) {}

  std::vector<CageQuestion> questions() && {
    if (is_off_cage(place_)) add_off_cage();
    else if (place_ == mesh_place) add_relations(true), add_sign();
    else add_on_cage();
    return std::move(questions_);
  }

 private:
  CageQuestion& add(std::string check, const char* unit, Orders orders, Ask ask) {
    CageQuestion& question = questions_.emplace_back();
    question.key = {RowKey::Section::Cage,
                    std::string(kind_.name),
                    subject_.coordinates().evaluation(),
                    "double",
                    subject_.cage().name(),
                    std::move(check),
                    std::string(place_),
                    0};
    question.unit = unit;
    question.orders = orders;
    question.ask = std::move(ask);
    return question;
  }
  CageQuestion& add_roundings(std::string check, Orders orders, Ask ask) {
    return add(std::move(check), "roundings", orders, std::move(ask));
  }
  CageQuestion& add_relative(std::string check, Orders orders, Ask ask) {
    return add(std::move(check), "relative", orders, std::move(ask));
  }

  // \param of_ones whether the sum of all coordinates is asked for, too
  void add_relations(bool of_ones) {
    const auto relation = [](std::array<CageError, 3> CageErrors::*errors) {
      return [errors](const CageAt& at) {
        Found found;
        for (int o = 0; o <= at.order(); ++o)
          found[o] = finding_of(at.is_judged() ? (at.errors().*errors)[o] : CageError(), at);
        return found;
      };
    };
    const int asked = is_off_cage(place_) ? order_ : 2;
    const bool outside = place_ == name_of(Place::Outside) && !kind_.normalised;
    const auto add_relation = [&](const char* check, std::array<CageError, 3> CageErrors::*errors) {
      CageQuestion& question = add_roundings(check, {0, order_}, relation(errors));
      question.asked = asked;
      question.cost = CageQuestion::Cost::Relation;
    };
    if (of_ones) add_relation(outside ? "zero_outside" : "partition_of_unity", &CageErrors::partition);
    add_relation("linear_reproduction", &CageErrors::reproduction);
  }

  // Outside, coordinates of one sign could sum to nothing else.
  void add_sign() {
    const auto& blocks = subject_.coordinates().blocks();
    if (std::ranges::none_of(blocks, [](const CoordinateBlock& block) {
          return block.reproduces == Reproduces::Vertices && block.entries() == 1;
        }))
      return;
    const bool of_mesh = place_ == mesh_place;
    add_roundings("non_negativity", values_alone, [of_mesh](const CageAt& at) {
      if (of_mesh && (!at.is_judged() || at.is_outside())) return Found{};
      return Found{finding_of(at.errors().negative, at)};
    }).cost = CageQuestion::Cost::Sign;
  }

  void add_off_cage() {
    const CageSubject& subject = subject_;
    add_relations(true);
    if (place_ == name_of(Place::Inside)) add_sign();
    if (order_ == 2 && has_laplacian(subject.coordinates()))
      add_roundings("cage_laplacian", {2, 2}, [](const CageAt& at) {
        return Found{{{}, {}, finding_of(at.errors().laplacian, at)}};
      });
    // Coordinates that exist only in double would be compared with themselves.
    const CageCoordinates& reference = subject.recommended();
    if (reference.is_exact_in(ScalarKind::Digits50) && reference.is_prompt_in(ScalarKind::Digits50))
      add_roundings("cage_truth", {0, order_}, [&subject, place = place_](const CageAt& at) {
        Found found;
        const auto errors =
            truth_errors_at(subject.coordinates(), subject.recommended(), at.point, at.order(), &subject.terms(place));
        for (int o = 0; o <= at.order(); ++o) found[o] = finding_of(errors[o], at);
        return found;
      }).cost = CageQuestion::Cost::Truth;
    // Outside, where some kinds have no coordinates, such a point would say nothing.
    if (subject.second_route() && (kind_.missing_because.empty() || place_ == name_of(Place::Inside))) {
      CageQuestion& question = add_relative("second_route", values_alone, [&subject](const CageAt& at) {
        return Found{finding_of(second_route_error_at(subject.coordinates(), *subject.second_route(), at.point), at)};
      });
      question.key.scalar = name_of(subject.second_route()->compared_in());
      question.cost = CageQuestion::Cost::SecondRoute;
    }
    add_rest_derivative();
    for (const std::string& check : CageSymmetries::checks_of(subject.coordinates()))
      add_roundings(check, values_alone, [check](const CageAt& at) {
        return Found{finding_of(at.symmetries().at(check), at)};
      }).cost = CageQuestion::Cost::Truth;
    if (order_ == 2 && subject.coordinates().is_prompt_in(ScalarKind::Digits100)) {
      CageQuestion& question = add_relative("cage_differences", {1, 2}, [&subject](const CageAt& at) {
        const std::array<double, 3> errors = subject.symmetries().differences_at(at.point);
        return Found{{{}, finding_of(errors[1], at), finding_of(errors[2], at)}};
      });
      question.key.scalar = name_of(ScalarKind::Digits100);
      question.cost = CageQuestion::Cost::Differences;
    }
    if (!kind_.approximates.empty() && place_ == name_of(Place::Inside))
      add_relative("scheme_error", {0, order_}, [&subject](const CageAt& at) {
        Found found;
        if (!subject.approximated()) return found;
        const auto errors =
            scheme_errors_at(subject.coordinates(), *subject.approximated(), subject.cage(), at.point, at.order());
        for (int o = 0; o <= at.order(); ++o) found[o] = finding_of(errors[o], at);
        return found;
      });
  }

  // One derivative serves all evaluations, and is asked of the first.
  void add_rest_derivative() {
    const CageCoordinates& coordinates = subject_.coordinates();
    if (!RestProducts::exist(coordinates) || coordinates.evaluation() != subject_.recommended().evaluation()) return;
    const auto products = std::make_shared<const RestProducts>(coordinates, subject_.cage(), rest_derivative_of(kind_));
    const auto add = [&](const char* check, CageError (RestProducts::*error)(const Vec3<double>&) const) {
      add_roundings(check, values_alone, [products, error](const CageAt& at) {
        return Found{finding_of(((*products).*error)(at.point), at)};
      }).cost = CageQuestion::Cost::SecondRoute;
    };
    add("rest_derivative", &RestProducts::error_of_jvp);
    add("rest_derivative_transposed", &RestProducts::error_of_transposed);
  }

  void add_on_cage() {
    const CageSubject& subject = subject_;
    if (!kind_.normalised) add_relations(false);
    // A point without such data has no error.
    const auto known = [](const std::optional<double>& error, const CageAt& at) {
      return error ? finding_of(*error, at) : Finding{};
    };
    if (kind_.meets_boundary_data)
      add_relative("boundary_data", {0, 1}, [&subject, known](const CageAt& at) {
        const auto missed = boundary_data_errors_at(subject.coordinates(), subject.cage(), at.point);
        return missed ? Found{known((*missed)[0], at), known((*missed)[1], at)} : Found{};
      });
    const bool has_derivatives = place_ == name_of(Place::OnFace) && !kind_.normalised;
    const int order = has_derivatives ? subject.coordinates().max_order() : 0;
    add_relative("limit_from_inside", {0, order}, [&subject, known, order](const CageAt& at) {
      const auto errors =
          inside_limit_errors_at(subject.coordinates(), subject.cage(), subject.locator(), at.point, order);
      Found found;
      for (int o = 0; o <= order; ++o) found[o] = known(errors[o], at);
      return found;
    });
    if (place_ != name_of(Place::OnFace) || !subject.coordinates().measures_boundary()) return;
    add_relative("boundary_residual", {0, 1}, [&subject, known](const CageAt& at) {
      const auto residuals = boundary_residuals(subject.coordinates());
      return Found{known(residuals[0], at), known(residuals[1], at)};
    }).once = true;
  }

  const CageSubject& subject_;
  const CoordinateKind& kind_;
  std::string_view place_;
  int order_;
  std::vector<CageQuestion> questions_;
};

}  // namespace

CageSubject::CageSubject(std::shared_ptr<const Cage> cage, const CoordinateKind& kind, const std::string& evaluation,
                         Triangulation rule)
    : cage_(std::move(cage)),
      kind_(kind),
      recommended_([this, rule] { return CageCoordinates(*cage_, kind_, CoordinateOptions{.triangulation = rule}); }),
      coordinates_(evaluation.empty() ? recommended_.get() : CageCoordinates(*cage_, kind, evaluation, rule)),
      locator_([this, rule] { return CageLocator(*cage_, rule, kind_.keeps_quads); }),
      terms_([this, evaluation] { return CageTerms(*cage_, recommended_.get(), evaluation); }),
      plain_([this] { return CageTerms(*cage_, recommended_.get()); }),
      prior_([this, rule] { return prior_of(*cage_, kind_, rule); }),
      symmetries_([this, evaluation] { return CageSymmetries(*cage_, evaluation, coordinates_, terms_.get()); }),
      crosses_([this] { return !crossing_faces(*cage_).empty(); }),
      approximated_([this, rule] { return approximated_by(*cage_, kind_, rule); }),
      second_route_([this] {
        // Other evaluations of kinds that solve equations are other coordinates.
        const bool is_defined = coordinates_.evaluation() == recommended_.get().evaluation();
        return is_defined ? second_routes::cage_route(kind_, *cage_) : nullptr;
      }) {}

bool CageSubject::is_buried(const Vec3<double>& point) const {
  if (kind_.normalised || !crosses_.get()) return false;
  const std::vector<Touching> on = coordinates_.elements().touching(point);
  return !on.empty() && !point_inside(coordinates_, *cage_, locator(), point, on);
}

CageAt::CageAt(const CageSubject& subject, const Vec3<double>& where, std::uint64_t sample, std::string_view place,
               int order, bool exact)
    : PointAt{where, sample},
      subject_(subject),
      place_(place),
      order_(order),
      exact_(exact),
      in_mesh_([this] { return subject_.locator().place(this->point); }),
      errors_([this] { return errors_there(); }),
      symmetries_([this] { return subject_.symmetries().errors_at(this->point); }) {}

bool CageAt::is_excused() const {
  if (is_off_cage(place_)) return subject_.may_lack(point);
  if (place_ != mesh_place) return !exact_ || !is_judged();
  return !is_judged() || subject_.may_lack(point);
}

bool CageAt::is_too_close() const { return place_ == mesh_place && in_mesh_.get() == Place::TooClose; }

bool CageAt::is_judged() const {
  if (is_off_cage(place_)) return true;
  if (place_ != mesh_place) return !subject_.is_buried(point);
  return !is_too_close() && !(subject_.kind().inside_alone && in_mesh_.get() == Place::Outside);
}

CageErrors CageAt::errors_there() const {
  const CageCoordinates& coordinates = subject_.coordinates();
  const auto errors_with = [&](double expected, bool with_terms) {
    return errors_at(coordinates, subject_.cage(), point, expected, order_,
                     with_terms ? &subject_.terms(place_) : nullptr);
  };
  if (place_ != mesh_place && !is_off_cage(place_)) {
    // Midpoints that rounding moved off the cage prove nothing about it; those that are exact lie on it.
    if (coordinates.elements().touching(point).empty()) return {};
    // Sums have no terms on the cage.
    return errors_with(1, !subject_.kind().is_sum());
  }
  return errors_with(expected_sum(subject_.kind(), subject_.locator(), point), !is_too_close());
}

int order_at(std::string_view place, const CageCoordinates& coordinates, int most) {
  return is_off_cage(place) ? std::min(most, coordinates.max_order()) : 0;
}

std::vector<CageQuestion> cage_questions(const CageSubject& subject, std::string_view place, int order) {
  return Factory(subject, place, order).questions();
}

}  // namespace cageproof::validation
