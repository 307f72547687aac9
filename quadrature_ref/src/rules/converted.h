// SPDX-License-Identifier: MIT
// Inputs in another scalar, with their own storage.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::quadrature_ref {

/// The corners and parameters that all points of a block share.
template <Scalar To>
struct ConvertedBatch {
  template <Scalar From>
  explicit ConvertedBatch(const Batch<From>& from) {
    for (const Vec3<From>& corner : from.corners) corners.push_back(cageproof::convert<To>(corner));
    for (const From& parameter : from.parameters) parameters.push_back(static_cast<To>(parameter));
  }

  std::vector<Vec3<To>> corners;
  std::vector<To> parameters;
};

template <Scalar To>
struct ConvertedQuery {
  template <Scalar From>
  explicit ConvertedQuery(const Query<From>& from)
      : storage(Batch<From>{from.corners, {}, from.order, from.parameters}),
        query{storage.corners, cageproof::convert<To>(from.point), from.order, storage.parameters} {}
  ConvertedQuery(const ConvertedQuery&) = delete;
  ConvertedQuery& operator=(const ConvertedQuery&) = delete;

  ConvertedBatch<To> storage;
  Query<To> query;
};

}  // namespace cageproof::quadrature_ref
