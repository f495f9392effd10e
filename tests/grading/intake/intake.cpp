#include "intake.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <numeric>
#include <system_error>
#include <utility>

#include "class_layout.hpp"
#include "container.hpp"
#include "encoding.hpp"
#include "file_names.hpp"
#include "fos/text.hpp"
#include "limits.hpp"
#include "platform_names.hpp"
#include "stage_finder.hpp"
#include "trouble_words.hpp"

namespace fos::grading {

struct ClassFiles::Contents {
  std::unique_ptr<Container> container;
  std::span<const Stage> stages;
  ClassKind kind = ClassKind::one;
  std::vector<HandInFiles> hand_ins;
  std::vector<std::string> notes;
};

namespace {

constexpr ListLimits class_limits = {most_class_directory, most_class_files};

std::unique_ptr<Container> open_path(const std::filesystem::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    const std::string why = std::generic_category().message(errno);
    throw IntakeError(say(text::intake_no_path, {shown_path(path.string()), why}));
  }
  try {
    if (S_ISDIR(status.st_mode)) return open_folder(path, class_limits);
    if (S_ISREG(status.st_mode)) return open_zip_file(path, class_limits);
    throw ContainerError(Trouble::not_a_zip);
  } catch (const ContainerError& error) {
    throw IntakeError(
        say(text::intake_bad_path, {shown_path(path.string()), trouble_words(error.trouble)}));
  }
}

/// What PATH is called, also where it is `.` or ends in a slash; without `.zip`.
std::string name_of(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::path whole = std::filesystem::canonical(path, failed);
  if (failed) whole = path;
  std::string name = whole.filename().string();
  if (is_zip_name(name)) name.resize(name.size() - 4);
  return name.empty() ? "submission" : name;
}

/// Gradescope's list has the names that its folders lack.
void add_gradescope_names(const Listing& listing, Layout& layout, Container& container) {
  for (const FileEntry& entry : listing.metadata) {
    if (entry.path != layout.root + "submission_metadata.yml") continue;
    const auto names = gradescope_names(container.read(entry, most_table));
    for (HandInFiles& hand_in : layout.hand_ins) {
      const auto found = names.find(std::string(file_name(hand_in.whose.source)));
      if (found == names.end()) continue;
      hand_in.whose.name = found->second.name;
      hand_in.whose.number = found->second.number;
      hand_in.whose.email = found->second.email;
    }
  }
}

/// What the id is made of: the name that the platform gave, which stays the same from run to run.
std::string id_base(const Whose& whose, ClassKind kind) {
  if (kind == ClassKind::gradescope) return std::string(file_name(whose.source));
  if (whose.number.empty()) return whose.name;
  return whose.name + "-" + whose.number;
}

void set_ids(std::vector<HandInFiles>& hand_ins, ClassKind kind) {
  std::vector<std::string> bases;
  std::vector<std::string> sources;
  for (HandInFiles& hand_in : hand_ins) {
    hand_in.whose.name = read_name(hand_in.whose.name);  // folders too may have come from Windows
    bases.push_back(id_base(hand_in.whose, kind));
    sources.push_back(hand_in.whose.source);
  }
  const std::vector<std::string> ids = unique_ids(bases, sources);
  for (std::size_t i = 0; i < ids.size(); ++i) hand_ins[i].whose.id = ids[i];
  std::sort(hand_ins.begin(), hand_ins.end(),
            [](const auto& a, const auto& b) { return a.whose.id < b.whose.id; });
}

std::string left_out_words(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < 5; ++i) {
    list += (i == 0 ? "" : ", ") + shown_path(names[i]);
  }
  if (names.size() > 5) list += ", …";
  return say(text::intake_left_out, {std::to_string(names.size()), list});
}

}  // namespace

ClassFiles read_class(const std::filesystem::path& path, std::span<const Stage> stages, bool one) {
  auto contents = std::make_unique<ClassFiles::Contents>();
  contents->stages = stages;
  contents->container = open_path(path);
  try {
    Listing listing;
    contents->container->list([&](const FileEntry& entry) { listing.add(entry, stages); });
    Layout layout =
        one ? layout_of_one(listing, name_of(path)) : find_layout(listing, name_of(path), stages);
    if (layout.kind == ClassKind::gradescope) {
      add_gradescope_names(listing, layout, *contents->container);
    }
    set_ids(layout.hand_ins, layout.kind);
    contents->kind = layout.kind;
    contents->hand_ins = std::move(layout.hand_ins);
    if (!layout.left_out.empty()) contents->notes.push_back(left_out_words(layout.left_out));
  } catch (const ContainerError& error) {
    throw IntakeError(
        say(text::intake_bad_path, {shown_path(path.string()), trouble_words(error.trouble)}));
  }
  if (contents->hand_ins.empty()) {
    throw IntakeError(say(text::intake_nobody, {shown_path(path.string())}));
  }
  return ClassFiles(std::move(contents));
}

ClassFiles::ClassFiles(std::unique_ptr<Contents> contents) : contents_(std::move(contents)) {}
ClassFiles::ClassFiles(ClassFiles&& other) noexcept = default;
ClassFiles& ClassFiles::operator=(ClassFiles&& other) noexcept = default;
ClassFiles::~ClassFiles() = default;

ClassKind ClassFiles::kind() const { return contents_->kind; }

std::string ClassFiles::words() const {
  const std::string count = std::to_string(size());
  switch (contents_->kind) {
    case ClassKind::folder:
      return say(text::intake_kind_folder, {count});
    case ClassKind::moodle:
      return say(text::intake_kind_moodle, {count});
    case ClassKind::eclass:
      return say(text::intake_kind_eclass, {count});
    case ClassKind::gradescope:
      return say(text::intake_kind_gradescope, {count});
    default:
      return say(text::intake_kind_one);
  }
}

const std::vector<std::string>& ClassFiles::notes() const { return contents_->notes; }
std::size_t ClassFiles::size() const { return contents_->hand_ins.size(); }
const Whose& ClassFiles::whose(std::size_t i) const { return contents_->hand_ins.at(i).whose; }

HandIn ClassFiles::read(std::size_t i) const {
  const HandInFiles& mine = contents_->hand_ins.at(i);
  StageFinder finder(contents_->stages);
  if (mine.files.size() > most_files) {
    finder.note(trouble_words(Trouble::too_many_files));
  } else {
    finder.look(*contents_->container, mine.files, "");
  }
  HandIn hand_in;
  hand_in.whose = mine.whose;
  hand_in.files = finder.files();
  hand_in.notes = finder.notes();
  return hand_in;
}

}  // namespace fos::grading
