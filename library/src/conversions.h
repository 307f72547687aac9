// SPDX-License-Identifier: MIT
// Between the library's plain arrays and the rooms' types.
#pragma once

#include "cageproof/cageproof.h"
#include "cageproof/core/coordinates/coordinates.h"

#include <functional>

namespace cageproof::library {

/// \throws InputError as Cage::make and Cage::make_polygon, and for arrays that are no cage
cageproof::Cage checked_cage(const Cage& cage, const Options& options);

/// \throws InputError for any but "shortest" and "fan"
Triangulation triangulation_of(const Options& options);

/// In the order of `known`, defaults filled in. \throws InputError naming the parameter
std::vector<double> parameters_of(const Options& options, const std::vector<KindParameter>& known,
                                  std::string_view owner);

/// Points as vectors; in the plane with a third number of zero. \throws InputError for a broken number of numbers
std::vector<Vec3<double>> vectors_of(std::span<const double> numbers, int dimension, std::string_view what);

/// \throws InputError unless the numbers make up groups of that size
void check_multiple(std::size_t numbers, std::size_t of, std::string_view what);

/// \throws InputError unless there are so many
void check_size(std::size_t given, std::size_t wanted, std::string_view what);

/// How many points share what evaluations prepare for an element.
constexpr std::size_t kBlock = 64;

/// Calls task(first, count) for blocks of kBlock points of [0, points) on so many threads, 0 for all cores.
void for_blocks(std::size_t points, int threads, const std::function<void(std::size_t, std::size_t)>& task);

}  // namespace cageproof::library
