// SPDX-License-Identifier: MIT
// Packed texts come back, and damaged ones are refused.
#include "cageproof/reports/packed_file.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "sample_run.h"

#include <gtest/gtest.h>

namespace cageproof::reports {
namespace {

class PackedFile : public ::testing::Test {
 protected:
  std::filesystem::path put(const std::string& bytes) const {
    write_file(scratch_.path() / "text", bytes);
    return scratch_.path() / "text";
  }

 private:
  ScratchFolder scratch_;
};

// Longer than what is read at once, with lines that are longer, empty, and without an end.
std::string long_text() {
  std::string text;
  for (int i = 0; i < 40'000; ++i)
    text += std::to_string(i * 2654435761U) + (i % 7 == 0 ? "\n\n" : i == 9 ? std::string(200'000, 'x') : " ");
  return text + "end";
}

TEST_F(PackedFile, ComesBack) {
  for (const std::string& text :
       {std::string(), std::string("\n"), std::string("one line"), long_text(), long_text() + "\n"}) {
    EXPECT_EQ(read_packed(put(packed(text))), text);
    EXPECT_EQ(read_packed(put(text)), text) << "not packed";
  }
  EXPECT_LT(packed(long_text()).size(), long_text().size() / 2);
  EXPECT_EQ(packed(long_text()), packed(long_text()));
  Packer in_parts;
  const std::string whole = long_text();
  std::string_view rest = whole;
  for (std::size_t size = 0; !rest.empty(); size = 2 * size + 1) {
    in_parts.add(rest.substr(0, size));
    rest.remove_prefix(std::min(size, rest.size()));
  }
  EXPECT_EQ(read_packed(put(in_parts.finish())), whole);
}

TEST_F(PackedFile, ReadsLines) {
  LineFile file(put(packed("a\n\nb")));
  EXPECT_TRUE(file.packed());
  EXPECT_EQ(file.next(), "a");
  EXPECT_EQ(file.next(), "");
  EXPECT_TRUE(file.whole());
  EXPECT_EQ(file.next(), "b");
  EXPECT_FALSE(file.whole());
  EXPECT_EQ(file.next(), std::nullopt);
  EXPECT_FALSE(LineFile(put("a")).packed());
}

TEST_F(PackedFile, OfSeveralTextsIsAllOfThem) {
  EXPECT_EQ(read_packed(put(packed("a\n") + packed("") + packed("b"))), "a\nb");
}

TEST_F(PackedFile, WithMoreBehindItIsRefused) {
  for (const std::string& more : {std::string("x"), std::string("more\n"), std::string(5, '\0'),
                                  std::string("\x1f\x8b"), std::string(200'000, '\x1f')})
    try {
      read_packed(put(packed(long_text()) + more));
      ADD_FAILURE() << more.size();
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("text: it is packed, and "), std::string::npos) << error.what();
    }
}

TEST_F(PackedFile, ThatIsDamagedIsRefused) {
  const std::string whole = packed(long_text());
  std::string flipped = whole;
  flipped[flipped.size() / 2] ^= 4;
  for (const std::string& bad : {whole.substr(0, whole.size() / 2), whole.substr(0, whole.size() - 3), flipped}) try {
      read_packed(put(bad));
      ADD_FAILURE() << bad.size();
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("text: it is packed, and damaged or cut off"), std::string::npos)
          << error.what();
    }
  EXPECT_THROW(read_packed(put("").parent_path()), InputError);
  EXPECT_THROW(read_packed(put("").parent_path() / "none"), InputError);
}

}  // namespace
}  // namespace cageproof::reports
