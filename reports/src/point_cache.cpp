// SPDX-License-Identifier: MIT
#include "cageproof/reports/point_cache.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

namespace cageproof::reports {
namespace {

enum class CacheOrder { Little, Big };

// Numbers of 32 bits, one after the other.
class CacheBytes {
 public:
  explicit CacheBytes(CacheOrder order) : order_(order) {}

  void add(std::uint32_t bits) {
    for (int k = 0; k < 4; ++k) {
      const int shift = order_ == CacheOrder::Little ? 8 * k : 24 - 8 * k;
      text_ += static_cast<char>((bits >> shift) & 0xffU);
    }
  }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
  void add(std::string_view characters) { text_ += characters; }
  std::string take() { return std::move(text_); }

 private:
  CacheOrder order_;
  std::string text_;
};

std::uint32_t cache_count(std::size_t count, std::string_view what) {
  if (count > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw InputError(
        fmt::format("point caches count at most 2147483647 {}, and there are {}; write fewer", what, count));
  return static_cast<std::uint32_t>(count);
}

std::string frame_called(const std::vector<CacheFrame>& frames, std::size_t frame) {
  return fmt::format("frame {} ({})", frame + 1, frames[frame].name);
}

void require_same_length(const std::vector<CacheFrame>& frames) {
  for (std::size_t frame = 1; frame < frames.size(); ++frame)
    if (frames[frame].vertices.size() != frames[0].vertices.size())
      throw InputError(
          fmt::format("{} has {} vertices, and {} has {}: a point cache holds one mesh; write a file for each frame",
                      frame_called(frames, frame), frames[frame].vertices.size(), frame_called(frames, 0),
                      frames[0].vertices.size()));
}

// Returns whether a place was rounded.
bool add_frames(CacheBytes& bytes, const std::vector<CacheFrame>& frames) {
  bool rounded = false;
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    for (std::size_t vertex = 0; vertex < frames[frame].vertices.size(); ++vertex)
      for (int k = 0; k < 3; ++k) {
        const double place = frames[frame].vertices[vertex][k];
        const auto value = static_cast<float>(place);
        if (!std::isfinite(value))
          throw InputError(fmt::format(
              "{}, vertex {} (counted from 0): {:g} is beyond single precision, which point caches have; write .obj, "
              ".ply or .vtp",
              frame_called(frames, frame), vertex, place));
        rounded |= value != place;
        bytes.add(value);
      }
  return rounded;
}

}  // namespace

PointCache pc2_of(const std::vector<CacheFrame>& frames) {
  require_same_length(frames);
  CacheBytes bytes(CacheOrder::Little);
  bytes.add(std::string_view("POINTCACHE2\0", 12));
  bytes.add(std::uint32_t{1});  // the format's version
  bytes.add(cache_count(frames.front().vertices.size(), "vertices"));
  bytes.add(1.0F);  // the first frame
  bytes.add(1.0F);  // frames per sample
  bytes.add(cache_count(frames.size(), "frames"));
  const bool rounded = add_frames(bytes, frames);
  return {bytes.take(), rounded};
}

PointCache mdd_of(const std::vector<CacheFrame>& frames, double rate) {
  require_same_length(frames);
  CacheBytes bytes(CacheOrder::Big);
  bytes.add(cache_count(frames.size(), "frames"));
  bytes.add(cache_count(frames.front().vertices.size(), "vertices"));
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    bytes.add(static_cast<float>(static_cast<double>(frame) / rate));
  const bool rounded = add_frames(bytes, frames);
  return {bytes.take(), rounded};
}

}  // namespace cageproof::reports
