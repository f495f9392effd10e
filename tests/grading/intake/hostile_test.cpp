// Hand-ins that mean harm, or come from broken tools: each costs little, says why, and harms
// nobody.
#include <sys/resource.h>

#include <ctime>
#include <random>

#include "catch2.hpp"
#include "container.hpp"
#include "intake_test.hpp"
#include "limits.hpp"
#include "test_folder.hpp"
#include "test_zip.hpp"

using namespace fos;
using namespace fos::grading;

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif
/// Sanitizers take many times the time and memory; how much is not what they are there to find.
constexpr long factor = sanitized ? 20 : 1;

/// The most memory that this process has ever had, in MiB.
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// CPU time: a busy machine fails nothing.
double seconds_of(const auto& work) {
  const std::clock_t began = std::clock();
  work();
  return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
}

/// The bytes as a hand-in among others, whatever is wrong with them.
HandIn read_broken(const TestFolder& folder, const std::string& bytes) {
  folder.write("class/broken.zip", bytes);
  folder.write("class/other.zip", zip_of({{"point.cpp", "other"}}));
  const ClassFiles files = read_class(folder.path() / "class", stages);
  CHECK(file_of(files.read(1), "point").content == "other");
  return files.read(0);
}

}  // namespace

TEST_CASE("a stage file that unpacks to much") {
  const TestFolder folder;
  const std::uint64_t much = 400ULL << 20U;
  const std::string zip = zip_of({{"point.cpp", "", much},
                                  {"ambient.cpp", "", 64 << 20, true, 0100644, 0, 0xFFFF, 10},
                                  {"combined.cpp", "fine"}});
  folder.write("bomb.zip", zip);
  const long before = peak_memory();
  HandIn hand_in;
  CHECK(seconds_of([&] { hand_in = read_one(folder.path() / "bomb.zip"); }) < 2 * factor);
  CHECK(peak_memory() - before < 50 * factor);
  CHECK(file_of(hand_in, "point").why == Why::too_large);
  CHECK(file_of(hand_in, "ambient").why == Why::too_large);
  CHECK(file_of(hand_in, "combined").content == "fine");
}

TEST_CASE("zips of zips that unpack without end") {
  const TestFolder folder;
  const std::string inner = zip_of({{"zeros.cpp.zip", "", 30 << 20}});
  std::vector<TestEntry> many;
  many.reserve(1000);
  for (int i = 0; i < 200; ++i) many.push_back({std::to_string(i) + ".zip", inner});
  std::string zip = zip_of(many);
  zip = zip_of({{"a.zip", zip}, {"b.zip", zip}, {"c.zip", zip}, {"point.cpp", "mine"}});
  folder.write("one/many.zip", zip);
  const long before = peak_memory();
  HandIn hand_in;
  CHECK(seconds_of([&] { hand_in = read_one(folder.path() / "one"); }) < 10 * factor);
  CHECK(peak_memory() - before < 150 * factor);
  CHECK(file_of(hand_in, "point").content == "mine");
  CHECK(hand_in.notes.size() <= most_notes + std::size(stages));

  // Zips that claim to be small, and are not zips either.
  many.clear();
  for (int i = 0; i < 8; ++i) {
    many.push_back({std::to_string(i) + ".zip", "", 33 << 20, true, 0100644, 0, 0xFFFF, 10});
  }
  folder.write("lies/lies.zip", zip_of(many));
  CHECK(seconds_of([&] { hand_in = read_one(folder.path() / "lies"); }) < 10 * factor);
  CHECK(has_note(hand_in, "unpacks to more"));
}

TEST_CASE("each zip within costs of what a hand-in may unpack, whatever it claims") {
  const auto zip =
      open_zip_bytes(zip_of({{"lies.zip", "", 33 << 20, true, 0100644, 0, 0xFFFF, 10},
                             {"big.zip", "", 33 << 20},
                             {"true.zip", zip_of({{"a", std::string(1000, 'a')}}), 0, false}}),
                     {most_directory, most_files});
  std::vector<FileEntry> entries;
  zip->list([&](const FileEntry& entry) { entries.push_back(entry); });
  std::size_t budget = most_unpacked;
  CHECK_THROWS_AS(zip->open_zip(entries[0], budget), ContainerError);
  CHECK(budget == most_unpacked - most_inner_zip);
  CHECK_THROWS_AS(zip->open_zip(entries[1], budget), ContainerError);  // not even begun
  CHECK(budget == most_unpacked - most_inner_zip);
  CHECK_NOTHROW(zip->open_zip(entries[2], budget));
  CHECK(budget == most_unpacked - most_inner_zip - entries[2].size);
  budget = 10;
  CHECK_THROWS_AS(zip->open_zip(entries[2], budget), ContainerError);

  // The hundredth zip is not looked into any more.
  std::vector<TestEntry> many;
  many.reserve(1000);
  for (int i = 0; i < 99; ++i) many.push_back({std::to_string(100 + i) + ".zip", zip_of({})});
  many.push_back({"199.zip", zip_of({{"point.cpp", "late"}})});
  const TestFolder folder;
  folder.write("in/many.zip", zip_of(many));
  const HandIn hand_in = read_one(folder.path() / "in");
  CHECK(file_of(hand_in, "point").why == Why::missing);
}

TEST_CASE("the list of a zip's files is refused before it fills the memory") {
  std::vector<TestEntry> many;
  many.reserve(1000);
  for (int i = 0; i < 1000; ++i) many.push_back({"file " + std::to_string(i), "", 0, false});
  const std::string zip = zip_of(many);
  Trouble trouble = Trouble::none;
  try {
    open_zip_bytes(zip, {20'000, most_files});
  } catch (const ContainerError& error) {
    trouble = error.trouble;
  }
  CHECK(trouble == Trouble::too_many_files);
  CHECK_NOTHROW(open_zip_bytes(zip, {200'000, most_files}));
}

TEST_CASE("a hundred thousand files") {
  const TestFolder folder;
  std::vector<TestEntry> entries = {{"point.cpp", "mine"}};
  for (int i = 0; i < 60'000; ++i) {
    entries.push_back({"junk/" + std::to_string(i) + ".cpp", "", 0, false});
  }
  folder.write("a.zip", zip_of(entries));
  HandIn hand_in;
  CHECK(seconds_of([&] { hand_in = read_one(folder.path() / "a.zip"); }) < 5 * factor);
  CHECK(file_of(hand_in, "point").content == "mine");

  for (int i = 0; i < 41'000; ++i) {
    entries.push_back({"more/" + std::to_string(i) + ".o", "", 0, false});
  }
  const long before = peak_memory();
  const std::string zip = zip_of(entries);
  CHECK(seconds_of([&] { hand_in = read_broken(folder, zip); }) < 5 * factor);
  CHECK(peak_memory() - before < 200 * factor);
  CHECK(file_of(hand_in, "point").why == Why::missing);
  CHECK(has_note(hand_in, "more files"));

  entries.clear();
  for (int i = 0; i < 5'000; ++i) {
    entries.push_back({std::to_string(i) + "/point.cpp", "copy", 0, false});
  }
  CHECK(file_of(read_broken(folder, zip_of(entries)), "point").why == Why::twice);
}

TEST_CASE("a folder of ten thousand files, and folders without end") {
  const TestFolder folder;
  const auto junk = folder.folder("one/junk");
  for (int i = 0; i < 10'000; ++i) std::ofstream(junk / std::to_string(i));
  folder.write("one/point.cpp", "mine");
  std::string deep = "one";
  for (std::size_t i = 0; i < most_depth + 5; ++i) deep += "/d";
  folder.write(deep + "/ambient.cpp", "deep");
  HandIn hand_in;
  CHECK(seconds_of([&] { hand_in = read_one(folder.path() / "one"); }) < 5 * factor);
  CHECK(file_of(hand_in, "point").content == "mine");
  CHECK(file_of(hand_in, "ambient").why == Why::missing);
  CHECK(has_note(hand_in, "too deep"));
}

TEST_CASE("names that lead elsewhere lead nowhere") {
  const TestFolder folder;
  folder.write("victim.cpp", "before");
  const HandIn hand_in = read_one(
      folder.write("in/slip.zip", zip_of({{"../../victim.cpp", "after"},
                                          {"../point.cpp", "slip"},
                                          {"a/../../ambient.cpp", "slip"},
                                          {"/etc/directional.cpp", "absolute"},
                                          {R"(C:\Users\me\lecture04\combined.cpp)", "windows"},
                                          {std::string(5000, 'a') + "/flat_color.cpp", "long"},
                                          {R"(..\..\flat_color.cpp)", "slip"}})));
  CHECK(file_of(hand_in, "point").why == Why::missing);
  CHECK(file_of(hand_in, "ambient").why == Why::missing);
  CHECK(file_of(hand_in, "flat_color").why == Why::missing);
  CHECK(file_of(hand_in, "directional").content == "absolute");
  CHECK(file_of(hand_in, "combined").content == "windows");
  CHECK(has_note(hand_in, "../point.cpp has a name that leads out"));
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    count += entry.is_regular_file() ? 1 : 0;
  }
  CHECK(count == 2);  // nothing was written
}

TEST_CASE("what is no zip says so") {
  const TestFolder folder;
  CHECK(has_note(read_broken(folder, "Rar!\x1A\x07"), "neither a folder nor a zip"));
  CHECK(has_note(read_broken(folder, ""), "neither a folder nor a zip"));
  const std::string good = zip_of({{"point.cpp", "mine"}});
  CHECK(has_note(read_broken(folder, good.substr(0, good.size() / 2)), "damaged, or cut off"));
  std::string flipped = zip_of({{"point.cpp", "mine", 0, false}});
  flipped[flipped.find("mine")] = 'M';  // its sum does not fit any more
  CHECK(file_of(read_broken(folder, flipped), "point").why == Why::damaged);
  CHECK(file_of(read_broken(folder, zip_of({{"point.cpp", "x", 0, true, 0100644, 0, 77}})), "point")
            .why == Why::damaged);

  CHECK_THROWS_WITH(read_class(folder.write("alone.zip", "no"), stages),
                    ContainsSubstring("neither a folder nor a zip"));
  CHECK_THROWS_AS(read_class(folder.path() / "nothing", stages), IntakeError);
  CHECK_THROWS_AS(read_class("/dev/null", stages), IntakeError);
}

TEST_CASE("names of people in the files' way") {
  const TestFolder folder;
  const HandIn hand_in = read_one(folder.write(
      "names.zip", zip_of({{"\x84\xA8\x9A\x98\xA9\xE5\x98/point.cpp", "1"},  // Εργασία in 737
                           {"Εργασία/ambient.cpp", "2", 0, true, 0100644, 0x800},
                           {"with space/\"quoted\"\n🎓/combined.cpp", "3"},
                           {"caf\x82/directional.cpp", "4"},  // café in 437
                           {"\x84\xA8\x9A\x98\xA9\xE5\x98/\x8D.cpp", "5"}})));
  CHECK(file_of(hand_in, "point").content == "1");
  CHECK(file_of(hand_in, "ambient").content == "2");
  CHECK(file_of(hand_in, "combined").content == "3");
  CHECK(file_of(hand_in, "directional").content == "4");
  CHECK(has_note(hand_in, "Εργασία/Ξ.cpp"));
}

TEST_CASE("every truncation of a zip, and damaged bytes, end in words") {
  const std::string inner = zip_of({{"ambient.cpp", "inner"}});
  const std::string good = zip_of({{"lecture04/point.cpp", std::string(300, 'x')},
                                   {"labs/", "", 0, false},
                                   {"combined.cpp", "stored", 0, false},
                                   {"inner.zip", inner, 0, false}});
  const auto read_all = [](const std::string& bytes) {
    try {
      const auto zip = open_zip_bytes(bytes, {most_directory, most_files});
      std::size_t budget = most_unpacked;
      zip->list([&](const FileEntry& entry) {
        try {
          if (entry.path.ends_with(".zip")) {
            zip->open_zip(entry, budget)->list([](const FileEntry&) {});
          } else if (entry.kind == FileKind::regular) {
            zip->read(entry, most_file);
          }
        } catch (const ContainerError&) {
        }
      });
      return true;
    } catch (const ContainerError&) {
      return false;
    }
  };
  CHECK(read_all(good));
  for (std::size_t size = 0; size < good.size(); ++size) {
    INFO(size << " of " << good.size());
    CHECK_FALSE(read_all(good.substr(0, size)));
  }
  std::mt19937 random(1);
  int opened = 0;
  for (int round = 0; round < 20'000 / factor; ++round) {
    std::string bad = good;
    for (auto flips = 1 + random() % 4; flips > 0; --flips) {
      bad[random() % bad.size()] = static_cast<char>(random() % 256);
    }
    opened += read_all(bad) ? 1 : 0;
  }
  CHECK(opened > 1000 / factor);  // so damage was read past the list, too
}
