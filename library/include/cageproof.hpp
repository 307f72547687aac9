// SPDX-License-Identifier: MIT
// The C interface (cageproof.h) for C++20: handles that free themselves, spans, exceptions; only the standard library.
// cageproof.h says what arrays hold.
#pragma once

#include "cageproof.h"

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::shared {

/// An error of the C interface: its text and its code.
class Error : public std::runtime_error {
 public:
  Error(int code, const char* text) : std::runtime_error(text), code_(code) {}
  /// CAGEPROOF_BAD_INPUT ...
  int code() const { return code_; }

 private:
  int code_;
};

/// \throws Error unless the code is CAGEPROOF_OK
inline void check(int code) {
  if (code != CAGEPROOF_OK) throw Error(code, cageproof_error());
}

/// Names and values: {{"nu", "0.3"}, {"threads", "1"}}.
using Options = std::vector<std::pair<std::string, std::string>>;

/// Returns options for the C interface, which refer to the given strings.
inline std::vector<cageproof_option> as_c(const Options& options) {
  std::vector<cageproof_option> found;
  for (const auto& [name, value] : options) found.push_back({name.c_str(), value.c_str()});
  return found;
}

/// Returns the names of "kinds", "methods", "formulas", "cages", or a formula's evaluations, one per line.
/// \throws Error
inline std::string list(const std::string& of) {
  std::size_t needed = 0;
  check(cageproof_list(of.c_str(), nullptr, 0, &needed));
  std::string text(needed, '\0');
  check(cageproof_list(of.c_str(), text.data(), text.size(), nullptr));
  text.pop_back();
  return text;
}

/// A mesh. Coordinates and Deformer check it. All functions \throw Error
class Cage {
 public:
  Cage(std::span<const double> vertices, const std::vector<std::vector<int>>& faces, int dimension = 3) {
    std::vector<std::int32_t> corners, sizes;
    for (const auto& face : faces) {
      corners.insert(corners.end(), face.begin(), face.end());
      sizes.push_back(static_cast<std::int32_t>(face.size()));
    }
    cageproof_cage* made = nullptr;
    check(cageproof_cage_make(dimension, vertices.data(), vertices.size(), corners.data(), corners.size(), sizes.data(),
                              sizes.size(), &made));
    own_.reset(made);
  }
  static Cage read(const std::string& file) { return from(cageproof_cage_read, file); }
  static Cage embedded(const std::string& name) { return from(cageproof_cage_embedded, name); }

  std::vector<double> vertices() const {
    std::size_t numbers = 0, corners = 0, faces = 0;
    check(cageproof_cage_sizes(get(), nullptr, &numbers, &corners, &faces));
    std::vector<double> found(numbers);
    std::vector<std::int32_t> all(corners), sizes(faces);
    check(cageproof_cage_copy(get(), found.data(), numbers, all.data(), corners, sizes.data(), faces));
    return found;
  }
  const cageproof_cage* get() const { return own_.get(); }

 private:
  Cage() = default;
  static Cage from(int (*make)(const char*, cageproof_cage**), const std::string& text) {
    cageproof_cage* made = nullptr;
    check(make(text.c_str(), &made));
    Cage cage;
    cage.own_.reset(made);
    return cage;
  }
  struct Free {
    void operator()(cageproof_cage* cage) const { cageproof_cage_free(cage); }
  };
  std::unique_ptr<cageproof_cage, Free> own_;
};

/// Coordinates of one kind in one cage. All functions \throw Error
class Coordinates {
 public:
  Coordinates(const Cage& cage, const std::string& kind, const Options& options = {}) {
    const auto given = as_c(options);
    cageproof_coordinates* made = nullptr;
    check(cageproof_coordinates_make(cage.get(), kind.c_str(), given.data(), given.size(), &made));
    own_.reset(made);
    check(cageproof_coordinates_sizes(made, nullptr, nullptr, &row_, nullptr, nullptr));
  }
  /// Numbers per point of the values.
  std::size_t row() const { return row_; }
  void evaluate(std::span<const double> points, std::span<double> values, std::span<double> gradients = {},
                std::span<double> hessians = {}) const {
    check(cageproof_coordinates_evaluate(own_.get(), points.data(), points.size(), values.data(), values.size(),
                                         gradients.data(), gradients.size(), hessians.data(), hessians.size()));
  }
  /// Computes the change of values under a change of the cage's vertices.
  void jvp(std::span<const double> points, std::span<const double> change, std::span<double> values) const {
    check(cageproof_coordinates_jvp(own_.get(), points.data(), points.size(), change.data(), change.size(),
                                    values.data(), values.size()));
  }
  /// Computes a function's derivatives by the cage's vertices from those by the values.
  void vjp(std::span<const double> points, std::span<const double> weights, std::span<double> vertices) const {
    check(cageproof_coordinates_vjp(own_.get(), points.data(), points.size(), weights.data(), weights.size(),
                                    vertices.data(), vertices.size()));
  }
  const cageproof_coordinates* get() const { return own_.get(); }

 private:
  struct Free {
    void operator()(cageproof_coordinates* coordinates) const { cageproof_coordinates_free(coordinates); }
  };
  std::unique_ptr<cageproof_coordinates, Free> own_;
  std::size_t row_ = 0;
};

/// Points whose coordinates a Deformer keeps.
class BoundPoints {
 public:
  const cageproof_bound* get() const { return own_.get(); }

 private:
  friend class Deformer;
  struct Free {
    void operator()(cageproof_bound* bound) const { cageproof_bound_free(bound); }
  };
  std::unique_ptr<cageproof_bound, Free> own_;
};

/// The map of points by a posed cage, with one method. All functions \throw Error
class Deformer {
 public:
  Deformer(const Cage& rest, const std::string& method, const Options& options = {}) {
    const auto given = as_c(options);
    cageproof_deformer* made = nullptr;
    check(cageproof_deformer_make(rest.get(), method.c_str(), given.data(), given.size(), &made));
    own_.reset(made);
  }
  void pose(std::span<const double> vertices) {
    check(cageproof_deformer_pose(own_.get(), vertices.data(), vertices.size()));
  }
  BoundPoints bind(std::span<const double> points, bool jacobians = false) const {
    BoundPoints bound;
    cageproof_bound* made = nullptr;
    check(cageproof_deformer_bind(own_.get(), points.data(), points.size(), jacobians ? 1 : 0, &made));
    bound.own_.reset(made);
    return bound;
  }
  void images(std::span<const double> points, std::span<double> images, std::span<double> jacobians = {}) const {
    check(cageproof_deformer_images(own_.get(), points.data(), points.size(), images.data(), images.size(),
                                    jacobians.data(), jacobians.size()));
  }
  void images(const BoundPoints& points, std::span<double> images, std::span<double> jacobians = {}) const {
    check(cageproof_bound_images(own_.get(), points.get(), images.data(), images.size(), jacobians.data(),
                                 jacobians.size()));
  }
  /// Computes the change of images under a change of the posed vertices.
  void jvp(std::span<const double> points, std::span<const double> change, std::span<double> images) const {
    check(cageproof_deformer_jvp(own_.get(), points.data(), points.size(), change.data(), change.size(), images.data(),
                                 images.size()));
  }
  void jvp(const BoundPoints& points, std::span<const double> change, std::span<double> images) const {
    check(cageproof_bound_jvp(own_.get(), points.get(), change.data(), change.size(), images.data(), images.size()));
  }
  /// Computes a function's derivatives by the posed vertices from those by the images.
  void vjp(std::span<const double> points, std::span<const double> weights, std::span<double> vertices) const {
    check(cageproof_deformer_vjp(own_.get(), points.data(), points.size(), weights.data(), weights.size(),
                                 vertices.data(), vertices.size()));
  }
  void vjp(const BoundPoints& points, std::span<const double> weights, std::span<double> vertices) const {
    check(cageproof_bound_vjp(own_.get(), points.get(), weights.data(), weights.size(), vertices.data(),
                              vertices.size()));
  }

 private:
  struct Free {
    void operator()(cageproof_deformer* deformer) const { cageproof_deformer_free(deformer); }
  };
  std::unique_ptr<cageproof_deformer, Free> own_;
};

}  // namespace cageproof::shared
