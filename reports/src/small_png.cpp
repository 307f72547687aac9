// SPDX-License-Identifier: MIT
#include "small_png.h"

#include <gd.h>

#include <memory>

namespace cageproof::reports {

std::optional<std::string> small_png(std::string_view bytes, int colours) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n", end = "IEND\xae\x42\x60\x82";
  if (!bytes.starts_with(signature) || !bytes.ends_with(end)) return std::nullopt;
  // gd takes the bytes by a pointer to non-const and does not change them.
  const std::unique_ptr<gdImage, void (*)(gdImagePtr)> image(
      gdImageCreateFromPngPtr(static_cast<int>(bytes.size()), const_cast<char*>(bytes.data())), gdImageDestroy);
  if (!image) return std::nullopt;
  const int background = gdImageGetTrueColorPixel(image.get(), 0, 0);
  if (!gdImageTrueColorToPalette(image.get(), 0, colours)) return std::nullopt;
  // The palette's colours are averages, but the background must keep its exact colour.
  const int index = gdImageGetPixel(image.get(), 0, 0);
  image->red[index] = gdTrueColorGetRed(background);
  image->green[index] = gdTrueColorGetGreen(background);
  image->blue[index] = gdTrueColorGetBlue(background);
  int size = 0;
  const std::unique_ptr<void, void (*)(void*)> small(gdImagePngPtrEx(image.get(), &size, 6), gdFree);
  if (!small) return std::nullopt;
  return std::string(static_cast<const char*>(small.get()), size);
}

}  // namespace cageproof::reports
