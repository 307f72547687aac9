/* SPDX-License-Identifier: MIT */
/* The C interface from C99: values that are known, and calls with wrong sizes and null pointers, which must give errors. */
#include <cageproof.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  printf("FAILED: %s (%s)\n", what, cageproof_error());
  ++failures;
}

/* An error with a text that says that. */
static void refuses(int code, const char* word, const char* what) {
  expect(code == CAGEPROOF_BAD_INPUT && strstr(cageproof_error(), word) != NULL, what);
}

static const double kPi = 3.14159265358979323846;
static const double kCorners[24] = {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1};
static const int32_t kFaces[24] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
static const int32_t kSizes[6] = {4, 4, 4, 4, 4, 4};
static const double kPoints[6] = {0.5, 0, 0, 0, 0.25, 0.5};

static cageproof_cage* cube(void) {
  cageproof_cage* cage = NULL;
  expect(cageproof_cage_make(3, kCorners, 24, kFaces, 24, kSizes, 6, &cage) == CAGEPROOF_OK, "a cube");
  return cage;
}

static void cages(void) {
  cageproof_cage *cage = cube(), *other = NULL;
  const cageproof_option threads = {"threads", "1"};
  double vertices[24];
  int32_t corners[24], sizes[6], negative = -1, far[3] = {0, 1, 99}, three = 3;
  int dimension = 0;
  size_t numbers = 0, of_faces = 0, faces = 0;
  expect(cageproof_cage_sizes(cage, &dimension, &numbers, &of_faces, &faces) == CAGEPROOF_OK, "sizes");
  expect(dimension == 3 && numbers == 24 && of_faces == 24 && faces == 6, "a cube's sizes");
  expect(cageproof_cage_copy(cage, vertices, 24, corners, 24, sizes, 6) == CAGEPROOF_OK, "copies");
  expect(memcmp(vertices, kCorners, sizeof vertices) == 0 && memcmp(corners, kFaces, sizeof corners) == 0, "as given");
  expect(cageproof_cage_check(cage, NULL, 0) == CAGEPROOF_OK, "a sound cage");
  expect(cageproof_cage_warning(cage, 0) == NULL && cageproof_cage_warning(NULL, 0) == NULL, "no warnings");
  refuses(cageproof_cage_copy(cage, vertices, 23, corners, 24, sizes, 6), "24", "too little room");
  refuses(cageproof_cage_copy(cage, NULL, 24, corners, 24, sizes, 6), "null", "no room");
  refuses(cageproof_cage_make(4, kCorners, 24, kFaces, 24, kSizes, 6, &other), "dimension", "four dimensions");
  refuses(cageproof_cage_make(3, kCorners, 23, kFaces, 24, kSizes, 6, &other), "multiple", "a broken vertex");
  refuses(cageproof_cage_make(3, NULL, 24, kFaces, 24, kSizes, 6, &other), "null", "no vertices");
  refuses(cageproof_cage_make(3, kCorners, 24, kFaces, 23, kSizes, 6, &other), "face 5", "too few corners");
  refuses(cageproof_cage_make(3, kCorners, 24, kFaces, 24, kSizes, 5, &other), "20", "too many corners");
  refuses(cageproof_cage_make(3, kCorners, 24, kFaces, 24, &negative, 1, &other), "face 0", "a negative size");
  refuses(cageproof_cage_make(3, kCorners, 24, kFaces, 24, kSizes, 6, NULL), "null", "no handle");
  refuses(cageproof_cage_embedded("nonsense", &other), "nonsense", "an unknown cage");
  refuses(cageproof_cage_embedded(NULL, &other), "null", "no name");
  refuses(cageproof_cage_read("/nonexistent/file.obj", &other), "nonexistent", "no file");
  expect(cageproof_cage_make(3, kCorners, 24, far, 3, &three, 1, &other) == CAGEPROOF_OK, "is checked later");
  refuses(cageproof_cage_check(other, NULL, 0), "face 0", "an index out of range");
  refuses(cageproof_cage_check(other, &threads, 1), "flip_inward", "an option that means nothing here");
  cageproof_cage_free(other);
  cageproof_cage_free(cage);
  cageproof_cage_free(NULL);
}

static void coordinates(void) {
  cageproof_cage* cage = cube();
  cageproof_coordinates *green = NULL, *other = NULL;
  cageproof_block block;
  double values[2 * 20], gradients[3 * 2 * 20], normals[36], sums[2], change[24], changed[2 * 20], back[24], sum = 0;
  int32_t corners[48], faces[12];
  size_t row = 0, blocks = 0, elements = 0, i;
  cageproof_option options[2] = {{"threads", "1"}, {"nu", "0.7"}}, broken = {NULL, "1"}, number = {"threads", "many"};
  expect(cageproof_coordinates_make(cage, "green", options, 1, &green) == CAGEPROOF_OK, "green");
  expect(cageproof_coordinates_sizes(green, NULL, NULL, &row, &blocks, &elements) == CAGEPROOF_OK, "sizes");
  expect(row == 20 && blocks == 2 && elements == 12, "8 vertices and 12 triangles");
  expect(cageproof_coordinates_block(green, 1, &block) == CAGEPROOF_OK && block.count == 12 && block.offset == 8 &&
             strcmp(block.label, "psi") == 0 && strcmp(block.reproduces, "normals") == 0, "psi");
  refuses(cageproof_coordinates_block(green, 2, &block), "2", "no third block");
  expect(cageproof_coordinates_elements(green, corners, 48, faces, 12, normals, 36) == CAGEPROOF_OK &&
             corners[3] == -1 && faces[11] == 5, "elements");
  refuses(cageproof_coordinates_elements(green, corners, 47, NULL, 0, NULL, 0), "48", "room for elements");
  expect(cageproof_coordinates_evaluate(green, kPoints, 6, values, 40, gradients, 120, NULL, 0) == CAGEPROOF_OK, "values");
  for (i = 0; i < 8; ++i) sum += values[i];
  expect(fabs(sum - 1) < 1e-14, "phi sum to one");
  refuses(cageproof_coordinates_evaluate(green, kPoints, 5, values, 40, NULL, 0, NULL, 0), "multiple", "half a point");
  refuses(cageproof_coordinates_evaluate(green, kPoints, 6, values, 39, NULL, 0, NULL, 0), "values", "room for values");
  refuses(cageproof_coordinates_evaluate(green, kPoints, 6, NULL, 40, NULL, 0, NULL, 0), "null", "no room");
  refuses(cageproof_coordinates_evaluate(NULL, kPoints, 6, values, 40, NULL, 0, NULL, 0), "null", "no handle");
  for (i = 0; i < 20; ++i) gradients[i] = i < 8 ? 1 : 0;
  expect(cageproof_coordinates_apply(green, kPoints, 6, gradients, 20, 1, sums, 2) == CAGEPROOF_OK &&
             fabs(sums[1] - 1) < 1e-14, "applied to ones");
  refuses(cageproof_coordinates_apply(green, kPoints, 6, gradients, 20, -1, sums, 2), "functions", "fewer than none");
  /* By the cage's vertices: a shift of them all is one of the points, back. */
  for (i = 0; i < 24; ++i) change[i] = i % 3 == 0;
  expect(cageproof_coordinates_evaluate(green, kPoints, 6, values, 40, gradients, 120, NULL, 0) == CAGEPROOF_OK, "gradients");
  expect(cageproof_coordinates_jvp(green, kPoints, 6, change, 24, changed, 40) == CAGEPROOF_OK, "by the cage's vertices");
  for (i = 0; i < 40; ++i) expect(fabs(changed[i] + gradients[3 * i]) < 1e-14, "a shift of the cage");
  expect(cageproof_coordinates_vjp(green, kPoints, 6, values, 40, back, 24) == CAGEPROOF_OK, "back to the cage's vertices");
  for (i = 0, sum = 0; i < 24; ++i) sum += back[i] * change[i];
  for (i = 0; i < 40; ++i) sum -= values[i] * changed[i];
  expect(fabs(sum) < 1e-14, "both directions by the cage's vertices");
  refuses(cageproof_coordinates_jvp(green, kPoints, 6, change, 21, changed, 40), "8", "too few vertices");
  refuses(cageproof_coordinates_jvp(green, kPoints, 6, change, 24, changed, 39), "values", "room for values");
  refuses(cageproof_coordinates_vjp(green, kPoints, 6, values, 39, back, 24), "weights", "too few weights");
  expect(cageproof_coordinates_make(cage, "mean_value", NULL, 0, &other) == CAGEPROOF_OK, "another kind");
  refuses(cageproof_coordinates_jvp(other, kPoints, 6, change, 24, changed, 16), "green", "a kind without derivatives names others");
  cageproof_coordinates_free(other);
  other = NULL;
  refuses(cageproof_coordinates_make(cage, "somigliana", options, 2, &other), "nu", "a parameter out of range");
  refuses(cageproof_coordinates_make(cage, "nonsense", NULL, 0, &other), "nonsense", "an unknown kind");
  refuses(cageproof_coordinates_make(cage, "green", &broken, 1, &other), "null", "an option without name");
  refuses(cageproof_coordinates_make(cage, "green", &number, 1, &other), "threads", "an option of another type");
  refuses(cageproof_coordinates_make(cage, "green", NULL, 1, &other), "null", "options that are not there");
  cageproof_coordinates_free(green);
  cageproof_cage_free(cage);
}

static void deformers(void) {
  cageproof_cage* cage = cube();
  cageproof_deformer *green = NULL, *other = NULL;
  cageproof_bound* bound = NULL;
  double twice[24], images[6], again[6], jacobians[18], back[24], back_of_bound[24], sum = 0;
  size_t i;
  for (i = 0; i < 24; ++i) twice[i] = 2 * kCorners[i];
  expect(cageproof_deformer_make(cage, "green", NULL, 0, &green) == CAGEPROOF_OK, "a deformer");
  cageproof_cage_free(cage);
  refuses(cageproof_deformer_images(green, kPoints, 6, images, 6, NULL, 0), "pose", "no pose yet");
  expect(cageproof_deformer_bind(green, kPoints, 6, 1, &bound) == CAGEPROOF_OK, "bound");
  refuses(cageproof_deformer_pose(green, twice, 23), "multiple", "a broken pose");
  refuses(cageproof_deformer_pose(green, twice, 21), "8", "too few vertices");
  refuses(cageproof_deformer_pose(green, NULL, 24), "null", "no pose");
  expect(cageproof_deformer_pose(green, twice, 24) == CAGEPROOF_OK, "a pose");
  expect(cageproof_deformer_images(green, kPoints, 6, images, 6, jacobians, 18) == CAGEPROOF_OK, "images");
  for (i = 0; i < 6; ++i) expect(fabs(images[i] - 2 * kPoints[i]) < 1e-14, "twice as large");
  expect(cageproof_bound_images(green, bound, again, 6, jacobians, 18) == CAGEPROOF_OK, "images of bound points");
  expect(memcmp(images, again, sizeof images) == 0, "to the bit");
  refuses(cageproof_bound_images(green, bound, again, 5, NULL, 0), "images", "room for images");
  refuses(cageproof_bound_images(green, NULL, again, 6, NULL, 0), "null", "no points");
  refuses(cageproof_deformer_make(NULL, "green", NULL, 0, &other), "null", "no cage");
  /* Along the pose itself, images grow as it does; back, both directions are one matrix. */
  expect(cageproof_deformer_jvp(green, kPoints, 6, twice, 24, again, 6) == CAGEPROOF_OK, "a derivative");
  for (i = 0; i < 6; ++i) expect(fabs(again[i] - images[i]) < 1e-14, "along the pose");
  expect(cageproof_bound_jvp(green, bound, kCorners, 24, again, 6) == CAGEPROOF_OK && fabs(again[0] - 0.5) < 1e-14, "of bound points");
  expect(cageproof_deformer_vjp(green, kPoints, 6, images, 6, back, 24) == CAGEPROOF_OK, "the transposed derivative");
  expect(cageproof_bound_vjp(green, bound, images, 6, back_of_bound, 24) == CAGEPROOF_OK, "of bound points");
  expect(memcmp(back, back_of_bound, sizeof back) == 0, "the transposed derivative, to the bit");
  for (i = 0; i < 24; ++i) sum += back[i] * kCorners[i];
  for (i = 0; i < 6; ++i) sum -= images[i] * again[i];
  expect(fabs(sum) < 1e-14, "both directions");
  refuses(cageproof_deformer_jvp(green, kPoints, 6, twice, 23, again, 6), "change", "too short a change");
  refuses(cageproof_deformer_vjp(green, kPoints, 6, images, 5, back, 24), "weights", "too few weights");
  refuses(cageproof_bound_vjp(green, bound, images, 6, back, 21), "vertices", "room for vertices");
  refuses(cageproof_bound_jvp(green, NULL, twice, 24, again, 6), "null", "no points");
  cage = cube();
  expect(cageproof_deformer_make(cage, "ahap", NULL, 0, &other) == CAGEPROOF_OK, "another deformer");
  refuses(cageproof_bound_jvp(other, bound, twice, 24, again, 6), "another", "points of another deformer");
  refuses(cageproof_deformer_jvp(other, kPoints, 6, twice, 24, again, 6), "pose", "no pose yet");
  expect(cageproof_deformer_pose(other, twice, 24) == CAGEPROOF_OK, "a pose");
  refuses(cageproof_deformer_jvp(other, kPoints, 6, twice, 24, again, 6), "green", "a method without derivatives names others");
  cageproof_cage_free(cage);
  cageproof_deformer_free(other);
  cageproof_bound_free(bound);
  cageproof_deformer_free(green);
}

static void inside(void) {
  const double asked[12] = {0, 0, 0, 1, 0.5, 0.25, 1.0000000000000002, 0.5, 0.25, 1, 1, 1};
  cageproof_cage *cage = cube(), *cup = NULL;
  cageproof_inside *of_cage = NULL, *of_cup = NULL, *other = NULL;
  cageproof_option keep = {"keep_quads", "1"}, unknown = {"nu", "0.3"};
  int32_t places[4], faces[4];
  double windings[4], bounds[4];
  expect(cageproof_inside_make(cage, 0, &keep, 1, &of_cage) == CAGEPROOF_OK, "inside a cube");
  expect(cageproof_inside_points(of_cage, asked, 12, 0, places, 4, faces, 4, windings, 4, bounds, 4) == CAGEPROOF_OK, "places");
  expect(places[0] == 1 && places[1] == 0 && places[2] == -1 && places[3] == 0, "places of a cube");
  expect(faces[1] == 3 && faces[0] == -1 && windings[0] == 1 && isnan(windings[1]) && bounds[2] == 0, "faces and windings");
  expect(cageproof_cage_make(3, kCorners, 24, kFaces, 20, kSizes, 5, &cup) == CAGEPROOF_OK, "a cube without one side");
  refuses(cageproof_inside_make(cup, 0, NULL, 0, &other), "hole", "no cage");
  expect(cageproof_inside_make(cup, 1, NULL, 0, &of_cup) == CAGEPROOF_OK, "any mesh");
  expect(cageproof_inside_points(of_cup, asked, 3, 1, NULL, 0, NULL, 0, windings, 1, bounds, 1) == CAGEPROOF_OK &&
             fabs(windings[0] - 5. / 6) <= bounds[0] && bounds[0] < 1e-13, "five sixths");
  refuses(cageproof_inside_points(of_cage, asked, 12, 0, places, 3, NULL, 0, NULL, 0, NULL, 0), "places", "room for places");
  refuses(cageproof_inside_points(of_cage, asked, 11, 0, places, 4, NULL, 0, NULL, 0, NULL, 0), "multiple", "a broken point");
  refuses(cageproof_inside_points(NULL, asked, 12, 0, places, 4, NULL, 0, NULL, 0, NULL, 0), "null", "no handle");
  refuses(cageproof_inside_make(cage, 0, &unknown, 1, &other), "nu", "an option that there is not");
  refuses(cageproof_inside_make(cup, 1, &keep, 1, &other), "keep_quads", "quads of any mesh");
  cageproof_inside_free(of_cage);
  cageproof_inside_free(of_cup);
  cageproof_cage_free(cage);
  cageproof_cage_free(cup);
}

static void potentials(void) {
  /* A face of the cube of edge 2, as two triangles, seen from its centre: a sixth of the sphere. */
  const double face[18] = {1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, -1, 1, 1, 1, 1, -1, 1}, centre[6] = {0, 0, 0, 0, 0, 0};
  const double ones[2] = {1, 1}, on_face[3] = {1, 0.25, -0.25};
  cageproof_request request = {"triangle.solid_angle", NULL, NULL, 0, 0, CAGEPROOF_INSIDE};
  double pairs[4], gradients[12], sums[2], inside, outside, mean;
  cageproof_tensors to_pairs = {{NULL, NULL, NULL}, {4, 0, 0}}, to_sums = {{NULL, NULL, NULL}, {2, 0, 0}};
  cageproof_tensors to_one = {{NULL, NULL, NULL}, {1, 0, 0}};
  cageproof_formula shape;
  to_pairs.data[0] = pairs;
  to_sums.data[0] = sums;
  expect(cageproof_formula_of("triangle.double_layer", &shape) == CAGEPROOF_OK && shape.tensors == 3 &&
             shape.corners == 3 && shape.rows == 1 && shape.dimension == 3, "a formula's shape");
  expect(cageproof_potentials(&request, face, 18, centre, 6, &to_pairs) == CAGEPROOF_OK, "pairs");
  expect(fabs(pairs[0] + pairs[1] - 4 * kPi / 6) < 1e-15, "a sixth of the sphere");
  expect(cageproof_potentials_apply(&request, face, 18, ones, 2, 1, centre, 6, &to_sums) == CAGEPROOF_OK, "sums");
  expect(sums[0] == pairs[0] + pairs[1] && sums[1] == pairs[2] + pairs[3], "sums of pairs");
  to_pairs.size[0] = 2;
  expect(cageproof_evaluate(&request, face, 18, centre, 3, &to_pairs) == CAGEPROOF_OK && pairs[0] == pairs[2], "one point");
  /* On the surface: 2 pi from inside, -2 pi from outside, nothing in the mean. */
  to_one.data[0] = &inside;
  expect(cageproof_evaluate(&request, face, 9, on_face, 3, &to_one) == CAGEPROOF_OK, "inside");
  to_one.data[0] = &outside;
  request.side = CAGEPROOF_OUTSIDE;
  expect(cageproof_evaluate(&request, face, 9, on_face, 3, &to_one) == CAGEPROOF_OK, "outside");
  to_one.data[0] = &mean;
  request.side = CAGEPROOF_MEAN;
  expect(cageproof_evaluate(&request, face, 9, on_face, 3, &to_one) == CAGEPROOF_OK, "mean");
  expect(inside == 2 * kPi && outside == -2 * kPi && mean == 0, "limits");
  request.side = 3;
  refuses(cageproof_evaluate(&request, face, 9, on_face, 3, &to_one), "side", "no fourth side");
  request.side = CAGEPROOF_INSIDE;
  request.order = 1;
  refuses(cageproof_potentials(&request, face, 18, centre, 6, &to_pairs), "values", "room for values");
  to_pairs.size[0] = 4;
  refuses(cageproof_potentials(&request, face, 18, centre, 6, &to_pairs), "gradients", "room for gradients");
  to_pairs.data[1] = gradients;
  to_pairs.size[1] = 12;
  expect(cageproof_potentials(&request, face, 18, centre, 6, &to_pairs) == CAGEPROOF_OK, "gradients");
  request.order = 3;
  refuses(cageproof_potentials(&request, face, 18, centre, 6, &to_pairs), "order 2", "third derivatives");
  request.order = 0;
  to_pairs.size[1] = 0;
  refuses(cageproof_potentials(&request, face, 17, centre, 6, &to_pairs), "multiple", "a broken element");
  refuses(cageproof_potentials(&request, centre, 0, centre, 6, &to_pairs), "values", "no element");
  refuses(cageproof_potentials(&request, NULL, 18, centre, 6, &to_pairs), "null", "no elements");
  refuses(cageproof_potentials(NULL, face, 18, centre, 6, &to_pairs), "null", "no request");
  refuses(cageproof_potentials(&request, face, 18, centre, 6, NULL), "null", "no results");
  refuses(cageproof_potentials_apply(&request, face, 18, ones, 1, 1, centre, 6, &to_sums), "densities", "a density each");
  {
    double flat[9] = {0, 0, 0, 1, 1, 1, 2, 2, 2}, missing[3] = {0, NAN, 0};
    to_one.size[0] = 1;
    refuses(cageproof_evaluate(&request, flat, 9, centre, 3, &to_one), "element 0", "no area");
    refuses(cageproof_evaluate(&request, face, 9, missing, 3, &to_one), "finite", "NaN");
  }
  request.evaluation = "nonsense";
  refuses(cageproof_evaluate(&request, face, 9, centre, 3, &to_one), "nonsense", "an unknown evaluation");
  request.formula = NULL;
  refuses(cageproof_evaluate(&request, face, 9, centre, 3, &to_one), "null", "no formula");
}

static void names(void) {
  char text[4096];
  size_t needed = 0;
  expect(cageproof_list("kinds", NULL, 0, &needed) == CAGEPROOF_OK && needed > 20, "how long");
  expect(cageproof_list("kinds", text, needed, NULL) == CAGEPROOF_OK && strstr(text, "green") != NULL &&
             strlen(text) + 1 == needed, "kinds");
  refuses(cageproof_list("kinds", text, needed - 1, NULL), "room", "too little room");
  expect(cageproof_list("methods", text, sizeof text, NULL) == CAGEPROOF_OK && strstr(text, "somigliana") != NULL, "methods");
  expect(cageproof_list("triangle.mean_value", text, sizeof text, NULL) == CAGEPROOF_OK &&
             strncmp(text, "hybrid", 6) == 0, "evaluations");
  refuses(cageproof_list("nonsense", text, sizeof text, NULL), "nonsense", "an unknown list");
  refuses(cageproof_list(NULL, text, sizeof text, NULL), "null", "no list");
  expect(cageproof_list("cages", text, sizeof text, NULL) == CAGEPROOF_OK && cageproof_error()[0] == '\0', "no error left");
}

int main(void) {
  expect(cageproof_abi_version() == CAGEPROOF_ABI_VERSION, "the interface's version");
  cages();
  coordinates();
  deformers();
  inside();
  potentials();
  names();
  if (failures == 0) printf("cageproof %s does what its C interface says\n", cageproof_version());
  return failures != 0;
}
