// SPDX-License-Identifier: MIT
// Parts that several printed forms share, instantiated once, in instances.cpp: they compile slowly.
#pragma once

#include "published/triangle/affine_single_layer.h"

#define CAGEPROOF_PUBLISHED_PARTS(how, R)                                            \
  how template struct Edge<R>;                                                       \
  how template struct Frame<R>;                                                      \
  how template R omega<R>(const Frame<R>&, Misprint);                                \
  how template Vec3<R> omega_gradient<R>(const Frame<R>&);                           \
  how template Mat3<R> omega_hessian<R>(const Frame<R>&);                            \
  how template Jet<R, 1> single_layer<R>(const Frame<R>&, int, Misprint);            \
  how template Jet<R, 1> biharmonic_single_layer<R>(const Frame<R>&, int, Misprint); \
  how template Mat3<R> third_derivative<R>(const Frame<R>&, const Vec3<R>&, Misprint);

#define CAGEPROOF_PUBLISHED_SCALARS(how) \
  CAGEPROOF_PUBLISHED_PARTS(how, float)  \
  CAGEPROOF_PUBLISHED_PARTS(how, double) \
  CAGEPROOF_PUBLISHED_PARTS(how, Mp200)
