// SPDX-License-Identifier: MIT
#error "a plain closed form takes exact geometry: it is to need its own scalar, the standard library and Eigen"
