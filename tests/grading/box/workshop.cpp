#include "grading/box/workshop.hpp"

#include <array>
#include <fstream>
#include <string_view>
#include <utility>

#include "fos/stage_build.inc"  // generated; it needs <string_view>
#include "grading/box/run.hpp"

namespace fos::grading {
namespace {

namespace fs = std::filesystem;

constexpr int lecture_with_closest_hit = 4;  // lecture 3 builds what that header holds
constexpr const char* header_name = "stage.hxx";
constexpr std::string_view sanitizers[] = {"-O1", "-g", "-fsanitize=address,undefined",
                                           "-fno-sanitize-recover=all", "-fno-omit-frame-pointer"};
constexpr auto readable_folder = fs::perms{0755};
constexpr auto readable_file = fs::perms{0444};
constexpr auto runnable_file = fs::perms{0555};

void make_folder(const fs::path& folder, fs::perms permissions = readable_folder) {
  fs::create_directories(folder);
  fs::permissions(folder, permissions);
}

void copy_one(const fs::path& from, const fs::path& to, fs::perms permissions = readable_file) {
  fs::copy_file(from, to, fs::copy_options::overwrite_existing);
  fs::permissions(to, permissions);
}

void copy_tree(const fs::path& from, const fs::path& to) {
  make_folder(to);
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path target = to / entry.path().filename();
    entry.is_directory() ? copy_tree(entry.path(), target) : copy_one(entry.path(), target);
  }
}

void replace_all(std::string& words, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = words.find(what, at)) != std::string::npos; at += with.size()) {
    words.replace(at, what.size(), with);
  }
}

fs::path headers_folder(const fs::path& folder, Headers headers) {
  return folder / (headers == Headers::stage ? "pch-stage" : "pch-closest-hit");
}

}  // namespace

StageBuild this_build() {
  StageBuild build;
  build.compiler = fs::canonical(build_compiler);
  for (const std::string_view flag : build_flags) {
    if (!flag.empty()) build.flags.emplace_back(flag);
  }
  build.source_folder = build_source_folder;
  build.generated = build_generated;
  build.stage_main = build_stage_main;
  build.libraries = {build_common_library, build_base_library};
  build.system_libraries = {build_fmt_library};
  build.inside = build_inside;
  return build;
}

Workshop::Workshop(StageBuild build, fs::path folder)
    : build_(std::move(build)), folder_(std::move(folder)) {
  make_folder(folder_, fs::perms{0711});
  make_folder(programs(), fs::perms{0711});
  copy_one(build_.inside, inside(), runnable_file);
  for (const int lecture : {lecture_with_closest_hit - 1, lecture_with_closest_hit}) {
    make_folder(kit(lecture));
    copy_tree(build_.source_folder / "common/include", kit(lecture) / "include");
    copy_tree(build_.source_folder / "common/text", kit(lecture) / "text");
    make_folder(kit(lecture) / "generated/fos");
    copy_one(build_.generated / "fos/stages.inc", kit(lecture) / "generated/fos/stages.inc");
    copy_one(build_.stage_main, kit(lecture) / "stage_main.o");
    for (const auto& library : build_.libraries) {
      copy_one(library, kit(lecture) / library.filename());
    }
  }
  fs::remove(kit(lecture_with_closest_hit - 1) / "include/fos/closest_hit.hpp");
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path Workshop::slot(unsigned number) const {
  return folder_ / ("slot" + std::to_string(number));
}

fs::path Workshop::kit(int lecture) const {
  return folder_ / (lecture < lecture_with_closest_hit ? "kit-before" : "kit");
}

Errand Workshop::compiler_errand(int lecture, Headers headers, bool sanitized) const {
  Errand errand;
  errand.compiler = true;
  errand.shown = {{kit(lecture), "/box/kit"}};
  errand.words = {build_.compiler.string()};
  errand.words.insert(errand.words.end(), build_.flags.begin(), build_.flags.end());
  for (const char* place : {"-I/box/kit/include", "-I/box/kit/generated", "-I/box/kit/text"}) {
    errand.words.emplace_back(place);
  }
  if (sanitized) {
    errand.words.insert(errand.words.end(), std::begin(sanitizers), std::end(sanitizers));
  } else if (precompiled_[static_cast<std::size_t>(headers)]) {
    errand.shown.push_back({headers_folder(folder_, headers), "/box/pch"});
    errand.words.insert(errand.words.end(), {"-include", std::string("/box/pch/") + header_name});
  }
  errand.limits.cpu_seconds = 30;
  errand.limits.memory = std::uint64_t{1536} << 20;
  errand.limits.file_size = 128 << 20;
  errand.limits.written = 256 << 20;
  return errand;
}

bool Workshop::precompile(const Box& box) {
  bool all = true;
  for (const Headers headers : {Headers::stage, Headers::stage_and_closest_hit}) {
    const fs::path made = slot(0) / "pch";
    make_folder(made);
    {
      std::ofstream header(made / header_name);
      header << "#include \"fos/stage.hpp\"\n";
      if (headers == Headers::stage_and_closest_hit) {
        header << "#include \"fos/closest_hit.hpp\"\n";
      }
    }
    // Both see closest_hit.hpp, since they are compiled with one kit; one of them includes it.
    Errand errand = compiler_errand(lecture_with_closest_hit, headers, false);
    errand.folder = made;
    errand.words.insert(errand.words.end(), {"-x", "c++-header", "-c", header_name, "-o",
                                             std::string(header_name) + ".gch"});
    errand.limits.file_size = 512 << 20;
    errand.limits.written = 512 << 20;
    const RunResult result = run(box, errand);
    const fs::path place = headers_folder(folder_, headers);
    if (result.succeeded()) {
      make_folder(place);
      for (const char* end : {"", ".gch"}) {
        copy_one(made / (std::string(header_name) + end), place / (std::string(header_name) + end));
      }
      precompiled_[static_cast<std::size_t>(headers)] = true;
    }
    all = all && result.succeeded();
    fs::remove_all(made);
  }
  return all;
}

std::vector<std::string> Workshop::linker_words() const {
  // gold takes a third of the time of the usual linker, and makes the same program.
  std::vector<std::string> words;
  if (fs::exists(build_.compiler.parent_path() / "ld.gold")) words.emplace_back("-fuse-ld=gold");
  words.emplace_back("/box/kit/stage_main.o");
  for (const auto& library : build_.libraries) {
    words.push_back("/box/kit/" + library.filename().string());
  }
  for (const auto& library : build_.system_libraries) words.push_back(library.string());
  return words;
}

std::string Workshop::readable(std::string words) const {
  for (const std::string& place :
       {std::string("/box/kit"), kit(lecture_with_closest_hit).string() + "-before",
        kit(lecture_with_closest_hit).string()}) {
    replace_all(words, place + "/include/", "common/include/");
    replace_all(words, place + "/generated/", "generated/");
    replace_all(words, place + "/", "");
  }
  return words;
}

}  // namespace fos::grading
