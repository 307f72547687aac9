// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/random_stream.h"

#include <Random123/philox.h>
#include <boost/crc.hpp>

namespace cageproof {
namespace {

// A stable number for a name; std::hash may differ between builds.
std::uint32_t crc_of(std::string_view name) {
  boost::crc_32_type crc;
  crc.process_bytes(name.data(), name.size());
  return crc.checksum();
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view name, std::uint64_t index)
    : key_{seed, crc_of(name)}, counter_{0, index, 0, 0} {}

std::uint64_t RandomStream::bits() {
  if (used_ == 4) {
    using Generator = r123::Philox4x64;
    const Generator::ctr_type counter{{counter_[0], counter_[1], counter_[2], counter_[3]}};
    const Generator::key_type key{{key_[0], key_[1]}};
    const Generator::ctr_type block = Generator()(counter, key);
    for (int i = 0; i < 4; ++i) block_[i] = block[i];
    ++counter_[0];
    used_ = 0;
  }
  return block_[used_++];
}

double RandomStream::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

}  // namespace cageproof
