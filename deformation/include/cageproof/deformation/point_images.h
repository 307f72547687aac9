// SPDX-License-Identifier: MIT
// Many points under maps that are made from the same coordinates: their images, and which of them have none.
#pragma once

#include "cageproof/deformation/deformer.h"
#include "cageproof/deformation/inside.h"

#include <optional>
#include <span>
#include <vector>

namespace cageproof::deformation {

/// Points under maps.
struct PointImages {
  std::vector<Images<double>> maps;  ///< of all points, a map each
  /// A point each: whether it lies where coordinates mean nothing, or has NaN among its coordinates. Its images are
  /// what the maps make of these all the same, until fill_missing.
  std::vector<char> missing;
  /// A point each: how far outside it is where its image is continued, else 0; empty where none is asked to be.
  std::vector<double> beyond = {};
};

/// Where coordinates mean something; nothing for normalised ones, which sum to one everywhere.
std::optional<Inside> region_of(const CageCoordinates& coordinates);

/// How images are computed.
struct ImageRun {
  int order = 0;  ///< highest derivative
  int jobs = 0;   ///< threads; 0: all cores
  /// Points whose coordinates are computed together, at most: fewer where a cage has many.
  std::size_t block = 128;
  /// Points outside the region get images by coordinates that are continued through the nearest element.
  /// \pre the coordinates' kind extends
  bool extend = false;
};

/// Coordinates are computed once per point, whatever the number of maps.
/// \param region outside which points are missing, unless they are extended to; nothing: none is for its place
/// \pre the maps are made from the coordinates, which have derivatives of that order
PointImages images_of(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                      std::span<const Posed<double>* const> maps, const ImageRun& run,
                      const std::optional<Inside>& region);

/// The transposed derivative times weights of images: what a function of the images changes by with each vertex of the
/// pose, if `weights` are its derivatives by the images. The sum is the same to the bit with any number of threads.
/// \param weights [point][component] \return one row per vertex
/// \pre as images_of(), of values \throws InputError for weights other than zero of a point that has no image, naming
/// it
std::vector<Vec3<double>> pulled_back(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                                      const PoseDerivative<double>& derivative, std::span<const double> weights,
                                      const ImageRun& run, const std::optional<Inside>& region);

/// How images to a number of digits were computed.
struct DigitsReport {
  int degree = 0;            ///< of the expansions, the highest; 0 where all is summed face by face
  std::size_t by_faces = 0;  ///< points that are summed face by face
  double error = 0;          ///< what images are off at most, over the size of the posed cage; roundings come on top
};

/// Images, no derivatives, to so many digits of the posed cage's size (the diagonal of its box), which are quicker than
/// all digits where elements and points are many: far elements are summed together, and what that costs is bounded.
/// \param reports one per map
/// \pre as images_of()
/// \throws InputError where there are no such sums: there are for `green` by the evaluation `batched`
PointImages images_to_digits(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                             std::span<const Posed<double>* const> maps, int digits, int jobs,
                             const std::optional<Inside>& region, std::vector<DigitsReport>& reports);

/// Points whose coordinates are kept, so that maps of them, poses say, cost a product each. Safe from any thread.
class BoundPoints {
 public:
  /// \param region as of images_of() \pre as images_of()
  /// \throws InputError where the coordinates take more than half of the memory there is, with their size
  BoundPoints(const CageCoordinates& coordinates, std::span<const Vec3<double>> points, const ImageRun& run,
              const std::optional<Inside>& region);

  std::size_t size() const { return missing_.size(); }
  /// The highest derivative that images have.
  int order() const { return order_; }
  /// The images that images_of() gives: to the bit at the same order, and to rounding at a lower one, whose coordinates
  /// an evaluation may round otherwise. \pre the maps are made from the coordinates, and order <= order()
  PointImages images(std::span<const Posed<double>* const> maps, int order, int jobs) const;
  /// The result of pulled_back(). \throws InputError as that
  std::vector<Vec3<double>> pulled_back(const PoseDerivative<double>& derivative, std::span<const double> weights,
                                        int jobs) const;

 private:
  int dimension_, order_;
  std::size_t block_;  // points in each
  std::vector<std::vector<CoordinateTable<double>>> blocks_;
  std::vector<char> missing_;
  std::vector<double> beyond_;
};

/// An image of a point, both counted from 0.
struct ImagePlace {
  std::size_t map, point;
};

/// The first point, of those that are not missing, with an image that is not finite, and the last map that makes such
/// a one. On the cage derivatives may be NaN; only values are looked at.
std::optional<ImagePlace> first_not_finite(const PointImages& images);

/// Missing points get themselves as images, with the derivatives of the identity, or NaN.
enum class Missing { Rest, Nan };
void fill_missing(PointImages& images, std::span<const Vec3<double>> points, int dimension, Missing as);

/// Images as points; in the plane with a third number of zero.
std::vector<Vec3<double>> vertices_of(const Images<double>& images, int dimension);

}  // namespace cageproof::deformation
