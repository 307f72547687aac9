// SPDX-License-Identifier: MIT
// A journal keeps what was found, exactly, whatever moment its writer died at.
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/journal.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/packed_file.h"
#include "sample_run.h"
#include "small_disk.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <limits>
#include <map>

// The error code that the next locks fail with; 0: the system is asked. It stands in for the C library's function.
static int failing_lock = 0;

extern "C" int flock(int file, int operation) noexcept {
  if (failing_lock == 0) return static_cast<int>(::syscall(SYS_flock, file, operation));
  errno = failing_lock;
  return -1;
}

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

JournalHeader header() {
  JournalHeader h;
  h.version = "0.1.0";
  h.options = {{"seed", "1"}, {"suite", "quick"}};
  h.settings = {{"triangulation", "shortest"}};
  h.notes = {"a note"};
  h.units = h.shard_units = 3;
  return h;
}

Session session(const char* started) { return {started, 0, "cageproof verify", {{"processor", "of the test"}}}; }

// Unit `i` finds numbers that text could spoil, in every kind of finding.
PartialResult found(int i) {
  PartialResult gathered;
  Tally& tally = gathered.rows[{RowKey::Section::Element, "f", "closed_form", "double", "near-edge", "truth", "", 0}];
  tally.unit = "conditioned";
  for (const double error : {0.1 + 0.2 * i, kDenormal, i == 1 ? HUGE_VAL : 1e300})
    tally.add(error, error / 3, i, [&](double e) {
      return WorstCase{
          e, -0.0, 1ULL << 63, {Vec3<double>(0.1, -0.0, kDenormal)}, Vec3<double>(1e308, 1.0 / 3, i), {HUGE_VAL}, 1};
    });
  tally.add_to_curve(1, 3, 1.0 / 7);
  tally.without_truth = 2;
  const auto section = i == 1 ? RowKey::Section::Deformer : RowKey::Section::Cage;
  gathered.rows[{section, "green", "e", "double", fmt::format("cage {}", i), "c", "inside", 2}].declined = 1;
  FieldPart part;
  part.title = "title";
  part.shown = "error";
  part.samples = 6;
  part.first = 2 * static_cast<std::size_t>(i);
  part.image = {"slice",
                {3, 2, 1},
                Vec3<double>(0.1, 0, -1),
                Vec3<double>(1, kDenormal, 3),
                {{"error", "1", 1, {std::nan(""), -HUGE_VAL}}}};
  gathered.fields.emplace(std::pair(7, part.first), part);
  if (i == 0) gathered.meshes["mesh"] = {"mesh", {Vec3<double>(1, 2, 1.0 / 3)}, {{0, 0, 0}}, {}};
  gathered.errata[i] = {"source", "printed", "correct", "f", "e", "generic", 1, 24, 3, 0.1, kDenormal};
  gathered.refused["too thin"].insert(i == 0 ? "one" : "another");
  return gathered;
}

// A journal with the given units; its text.
std::string written(const fs::path& path, const std::vector<int>& units) {
  write_file(path, journal_head(header(), session("then")));
  JournalWriter writer(path);
  for (const int i : units) writer.add(i, found(i), 1.5 * i);
  return read_file(path);
}

std::string message_of(const fs::path& path) {
  try {
    read_journal(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class Journals : public ::testing::Test {
 protected:
  fs::path path() const { return scratch_.path() / "journal"; }
  ScratchFolder scratch_;
};

TEST_F(Journals, KeepEveryBit) {
  written(path(), {0, 2, 1});
  const Journal journal = read_journal(path());
  EXPECT_EQ(journal.header, header());
  EXPECT_EQ(journal.units_done(), 3u);
  ASSERT_EQ(journal.sessions.size(), 1u);
  EXPECT_EQ(journal.sessions[0].seconds, 3);
  EXPECT_EQ(journal.sessions[0].machine.at("processor"), "of the test");
  const Tally& tally = journal.gathered.rows.begin()->second;
  EXPECT_EQ(tally.unit, "conditioned");
  EXPECT_EQ(tally.errors.count(), 9u);
  EXPECT_EQ(tally.errors.nonfinite(), 1u);
  EXPECT_EQ(tally.without_truth, 6u);
  EXPECT_EQ(tally.by_parameter, (std::vector<double>{-1, 1.0 / 7, -1}));
  ASSERT_EQ(tally.worst.cases().size(), 5u);
  const WorstCase& c = tally.worst.cases()[4];
  EXPECT_EQ(c.error, 0.1 + 0.2 * 1);
  EXPECT_TRUE(std::signbit(c.parameter) && std::signbit(c.corners[0][1]));
  EXPECT_EQ(c.corners[0][2], kDenormal);
  EXPECT_EQ(c.point, Vec3<double>(1e308, 1.0 / 3, 1));
  EXPECT_EQ(c.sample, 1ULL << 63);
  EXPECT_TRUE(std::isinf(c.parameters[0]));
  EXPECT_EQ(c.asked, 1);
  EXPECT_EQ(journal.gathered.rows.size(), 4u);
  const FieldPart field = whole_fields(journal.gathered).at(7);
  EXPECT_EQ(field.image.spacing[1], kDenormal);
  EXPECT_EQ(field.image.points[0], 3);
  EXPECT_TRUE(std::isnan(field.image.arrays[0].values[4]));
  EXPECT_EQ(field.image.arrays[0].values[5], -HUGE_VAL);
  EXPECT_EQ(journal.gathered.meshes.at("mesh").vertices[0][2], 1.0 / 3);
  EXPECT_EQ(journal.gathered.errata.at(2).corrected_error, kDenormal);
  EXPECT_EQ(journal.gathered.errata.at(2).nonfinite, 3u);
  EXPECT_EQ(journal.gathered.refused.at("too thin"), (std::set<std::string>{"another", "one"}));
}

TEST_F(Journals, LoseOnlyTheLineThatIsTorn) {
  const std::string text = written(path(), {0, 1});
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  for (std::size_t cut = last; cut < text.size(); cut += cut + 40 < text.size() ? 29 : 1) {
    write_file(path(), text.substr(0, cut));
    ASSERT_EQ(read_journal(path()).units_done(), 1u) << cut;
    {
      JournalWriter writer(path());
      writer.add_session(session("later"));
      writer.add(1, found(1), 1);
      writer.add(2, found(2), 2);
    }
    const Journal whole = read_journal(path());
    ASSERT_EQ(whole.units_done(), 3u) << cut;
    ASSERT_EQ(whole.sessions.size(), 2u);
    ASSERT_EQ(whole.sessions[1].started, "later");
  }
}

TEST_F(Journals, AreTheSameTextWhenFinished) {
  written(path(), {0, 1, 2});
  Journal journal = read_journal(path());
  const std::string text = journal_text(journal);
  written(path(), {2, 0, 1});
  journal.gathered = read_journal(path()).gathered;
  EXPECT_EQ(journal_text(journal), text);
  write_file(path(), text);
  const Journal again = read_journal(path());
  EXPECT_EQ(again.units_done(), 3u);
  EXPECT_EQ(journal_text(again), text);
  // Cut at the end of a line it holds results of units that it does not name.
  write_file(path(), text.substr(0, text.rfind('\n', text.size() - 2) + 1));
  EXPECT_NE(message_of(path()).find("cut off"), std::string::npos);
}

// A finished journal is packed, and can be gone on with all the same.
TEST_F(Journals, ThatArePackedReadAndGoOn) {
  written(path(), {0, 1});
  const std::string text = journal_text(read_journal(path()));
  write_file(path(), packed(text));
  EXPECT_EQ(find_journal_header(path()), header());
  EXPECT_EQ(journal_text(read_journal(path())), text);
  JournalWriter(path()).add_session(session("later"));
  EXPECT_TRUE(read_file(path()).starts_with(text));
  ASSERT_EQ(read_journal(path()).sessions.size(), 2u);
  const std::string whole = packed(text);
  write_file(path(), whole.substr(0, whole.size() / 2));
  EXPECT_NE(message_of(path()).find("damaged or cut off"), std::string::npos);
}

TEST_F(Journals, ThatAreDamagedAreNamedByTheirLine) {
  const std::string text = written(path(), {0, 1});
  const std::size_t second = text.find('\n') + 1, third = text.find('\n', second) + 1;
  const auto damaged = [&](const std::string& bytes) {
    write_file(path(), bytes);
    return message_of(path());
  };
  const std::string name = path().string();
  EXPECT_NE(damaged(text.substr(0, second) + "{\"units\n" + text.substr(third)).find(name + ":2: malformed"),
            std::string::npos);
  EXPECT_NE(damaged(text + text.substr(third)).find(":4: unit 1 is there twice"), std::string::npos);
  EXPECT_NE(damaged(text + "{\"units\":[[3,3]]}\n").find(":4: there is no unit 3"), std::string::npos);
  EXPECT_NE(
      damaged(text + "{\"rows\":[{\"key\":[\"element\"],\"unit\":\"u\"}],\"units\":[[2,2]]}\n").find(":4: malformed"),
      std::string::npos);
  EXPECT_NE(damaged("{\"schema\":\"another\"}\n").find("not the journal"), std::string::npos);
  EXPECT_NE(damaged("").find("not the journal"), std::string::npos);
  EXPECT_NE(damaged(text.substr(0, 40)).find("not the journal"), std::string::npos);
  EXPECT_NE(message_of(scratch_.path() / "none").find("no journal"), std::string::npos);
  EXPECT_FALSE(find_journal_header(scratch_.path() / "none"));
}

// Older journals say closed_form of recommended rows, which are hybrid today; rows of algebra and quads keep it.
TEST_F(Journals, OfBeforeNameHybrids) {
  std::string text = written(path(), {});
  const auto rows = [](const std::string& subject, const std::string& role) {
    return fmt::format(R"({{"key":["element","{}","closed_form","double","far","truth","",0],"role":"{}","unit":"u"}})",
                       subject, role);
  };
  text += fmt::format("{{\"rows\":[{},{},{}],\"units\":[[0,0]]}}\n", rows("triangle.double_layer", "recommended"),
                      rows("quad.solid_angle", "recommended"), rows("segment.double_layer", "printed"));
  const auto evaluations = [&](const std::string& version) {
    std::string older = text;
    const std::string member = "\"schema_version\":";
    older.replace(older.find(member) + member.size(), 1, version);
    write_file(path(), older);
    std::map<std::string, std::string> names;
    for (const auto& [key, tally] : read_journal(path()).gathered.rows) names[key.subject] = key.evaluation;
    return names;
  };
  using Names = std::map<std::string, std::string>;
  EXPECT_EQ(evaluations("1"), (Names{{"triangle.double_layer", "hybrid"},
                                     {"quad.solid_angle", "closed_form"},
                                     {"segment.double_layer", "closed_form"}}));
  EXPECT_EQ(evaluations("2")["triangle.double_layer"], "closed_form");
  EXPECT_THROW(evaluations("3"), InputError);
}

TEST_F(Journals, HaveOneWriter) {
  written(path(), {});
  const JournalWriter writer(path());
  EXPECT_THROW(JournalWriter second(path()), InputError);
}

TEST_F(Journals, WithoutALockAreNotWritten) {
  const std::string text = written(path(), {0});
  for (const int error : {ENOLCK, EOPNOTSUPP, EINVAL}) {
    failing_lock = error;
    try {
      const JournalWriter writer(path());
      ADD_FAILURE() << "written without a lock: " << error;
    } catch (const InputError& refused) {
      const std::string message = refused.what();
      for (const std::string& part : {path().string(), std::string("cannot be locked"),
                                      std::generic_category().message(error), std::string("choose a folder")})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    failing_lock = 0;
  }
  EXPECT_EQ(read_file(path()), text);
  JournalWriter(path()).add(1, found(1), 1);
}

TEST_F(Journals, OnAFullDiskEndWithAWholeLineOrATornOne) {
  const std::string text = written(path(), {0});
  for (std::size_t room = 1; room < 600; room += 57) {
    write_file(path(), text);
    {
      const SmallDisk disk(text.size() + room);
      JournalWriter writer(path());
      EXPECT_THROW(writer.add(1, found(1), 1), InputError);
      EXPECT_THROW(writer.add(2, found(2), 1), InputError);
    }
    EXPECT_EQ(read_journal(path()).units_done(), 1u) << room;
  }
}

}  // namespace
}  // namespace cageproof::reports
