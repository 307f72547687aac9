// SPDX-License-Identifier: MIT
// Questions to a kind of coordinates in a cage, by one evaluation.
#pragma once

#include "cageproof/validation/cage_campaign.h"
#include "cage_symmetries.h"
#include "cageproof/core/lazy.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/question.h"
#include "second_routes/cage_routes.h"

#include <map>
#include <memory>
#include <optional>

namespace cageproof::validation {

/// The place in row keys of a mesh's points.
inline constexpr std::string_view mesh_place = "mesh";

/// A kind's coordinates in a cage, and what questions to them need, each made when first asked for: some kinds solve
/// large systems. Safe from any thread.
class CageSubject {
 public:
  /// \param evaluation empty for each formula's recommended one \throws InputError as CageCoordinates
  CageSubject(std::shared_ptr<const Cage> cage, const CoordinateKind& kind, const std::string& evaluation,
              Triangulation rule);

  const Cage& cage() const { return *cage_; }
  const CoordinateKind& kind() const { return kind_; }
  const CageCoordinates& coordinates() const { return coordinates_; }
  const CageLocator& locator() const { return locator_.get(); }
  /// By recommended evaluations.
  const CageCoordinates& recommended() const { return recommended_.get(); }
  /// Terms in which roundings at a place are counted. At a mesh's points, where people take the quickest evaluation for
  /// the recommended one, its terms are the recommended ones.
  const CageTerms& terms(std::string_view place) const { return (place == mesh_place ? plain_ : terms_).get(); }
  /// Whether a point may have no coordinates; see may_be_missing().
  bool may_lack(const Vec3<double>& point) const { return may_be_missing(prior_.get(), point); }
  /// Whether a point on the cage lies within it where it overlaps itself: what is not normalised sums to another number
  /// than one just inside, and differs from there to the other side of each face.
  bool is_buried(const Vec3<double>& point) const;
  const CageSymmetries& symmetries() const { return symmetries_.get(); }
  /// Coordinates that the kind's scheme approximates; see approximated_by().
  const std::optional<CageCoordinates>& approximated() const { return approximated_.get(); }
  /// From the kind's definition; null where it has no such route, the cage has too many faces for it, or the
  /// coordinates are by another evaluation than the recommended one.
  const second_routes::CageRoute* second_route() const { return second_route_.get().get(); }

 private:
  std::shared_ptr<const Cage> cage_;
  const CoordinateKind& kind_;
  Lazy<CageCoordinates> recommended_;
  CageCoordinates coordinates_;
  Lazy<CageLocator> locator_;
  Lazy<CageTerms> terms_, plain_;
  Lazy<std::optional<CageCoordinates>> prior_;
  Lazy<CageSymmetries> symmetries_;
  Lazy<bool> crosses_;  // faces each other
  Lazy<std::optional<CageCoordinates>> approximated_;
  Lazy<std::shared_ptr<const second_routes::CageRoute>> second_route_;
};

/// A point of a cage, and what several questions share there, found when first asked for.
class CageAt : public PointAt {
 public:
  /// \param place as in row keys \param order the highest derivative that relations are asked of
  /// \param exact of points on the cage: whether they must lie on it
  CageAt(const CageSubject& subject, const Vec3<double>& where, std::uint64_t sample, std::string_view place, int order,
         bool exact = false);

  int order() const { return order_; }
  /// Whether a figure that is missing there says nothing of the coordinates.
  bool is_excused() const;
  /// Points of a mesh nearer than the promise reaches are shown and counted, not judged; buried ones of the cage
  /// neither.
  bool is_judged() const;
  /// Whether a mesh's point lies outside the cage. \pre it is a mesh's
  bool is_outside() const { return in_mesh_.get() == Place::Outside; }
  /// Partition of unity, linear reproduction, Laplacians: NaN where a point on the cage missed it.
  const CageErrors& errors() const { return errors_.get(); }
  const std::map<std::string, CageError>& symmetries() const { return symmetries_.get(); }

 private:
  CageErrors errors_there() const;
  bool is_too_close() const;

  const CageSubject& subject_;
  std::string_view place_;
  int order_;
  bool exact_;
  Lazy<Place> in_mesh_;  // of a mesh's points
  Lazy<CageErrors> errors_;
  Lazy<std::map<std::string, CageError>> symmetries_;
};

struct CageQuestion : Question<CageAt> {
  /// Cost of an answer, which decides how many points a campaign takes.
  enum class Cost { Relation, Sign, Point, Truth, Differences, SecondRoute } cost = Cost::Point;
};

/// The highest derivative that relations are asked of at a place.
/// \param most that they may be, at points off the cage
int order_at(std::string_view place, const CageCoordinates& coordinates, int most);

/// All questions at a place. \param order order_at() it \param subject outlives the questions
std::vector<CageQuestion> cage_questions(const CageSubject& subject, std::string_view place, int order);

}  // namespace cageproof::validation
