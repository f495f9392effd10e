#include "stage_finder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "encoding.hpp"
#include "file_names.hpp"
#include "fos/text.hpp"
#include "trouble_words.hpp"

namespace fos::grading {
namespace {

/// The stage whose file has this name; students on Windows may have changed the case.
std::optional<std::size_t> stage_of(std::string_view file, std::span<const Stage> stages) {
  const std::string name = lower(file);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (name == std::string(stages[i].id) + ".cpp") return i;
  }
  return std::nullopt;
}

/// Whether it lies where the kit has it: there `./lab` builds it, so that is the student's own.
bool is_in_place(std::string_view path, const Stage& stage) {
  const std::string place = fmt::format("labs/lecture{:02}/{}.cpp", stage.lecture, stage.id);
  return path == place || path.ends_with("/" + place);
}

/// A program under another name, such as `point (1).cpp` or `point.cpp.txt`.
bool may_be_source(std::string_view file) {
  const std::string name = lower(file);
  return name.find(".cpp") != std::string::npos || name.ends_with(".cc") || name.ends_with(".cxx");
}

Why why_of(FileKind kind) {
  switch (kind) {
    case FileKind::link:
      return Why::link;
    case FileKind::encrypted:
      return Why::encrypted;
    case FileKind::regular:
      return Why::none;
    default:
      return Why::special;
  }
}

Why why_of(Trouble trouble) {
  switch (trouble) {
    case Trouble::too_large:
      return Why::too_large;
    case Trouble::encrypted:
      return Why::encrypted;
    default:
      return Why::damaged;
  }
}

}  // namespace

bool is_of_interest(const FileEntry& entry, std::span<const Stage> stages) {
  if (entry.kind == FileKind::outside) return true;
  if (entry.kind == FileKind::folder || is_clutter(entry.path)) return false;
  if (entry.kind == FileKind::closed) return true;
  const std::string_view name = file_name(entry.path);
  return stage_of(name, stages) || is_zip_name(name) || !other_archive(name).empty() ||
         may_be_source(name);
}

void StageFinder::note(std::string words) {
  if (notes_full_) return;
  notes_full_ = notes_.size() + 1 >= most_notes;
  notes_.push_back(notes_full_ ? say(text::intake_more_notes) : std::move(words));
}

void StageFinder::look(Container& container, std::vector<FileEntry> entries,
                       const std::string& shown, int nested) {
  std::sort(entries.begin(), entries.end(), [](const FileEntry& a, const FileEntry& b) {
    return std::pair(std::string_view(a.path), a.index) <
           std::pair(std::string_view(b.path), b.index);
  });
  for (const FileEntry& entry : entries) {
    const std::string path = shown + std::string(entry.own_path());
    const std::string_view name = file_name(entry.own_path());
    if (entry.kind == FileKind::closed) {
      note(say(text::intake_closed_folder, {shown_path(path)}));
    } else if (entry.kind == FileKind::outside) {
      note(say(text::intake_outside, {shown_path(path)}));
    } else if (const auto stage = stage_of(name, stages_)) {
      found(container, entry, path, *stage);
    } else if (is_zip_name(name)) {
      look_in_zip(container, entry, path, nested + 1);
    } else if (!other_archive(name).empty()) {
      note(say(text::intake_other_archive, {shown_path(path), other_archive(name)}));
    } else if (others_.size() < 5) {
      others_.push_back(shown_path(path));
    }
  }
}

void StageFinder::look_in_zip(Container& container, const FileEntry& zip, const std::string& shown,
                              int nested) {
  try {
    if (zip.kind == FileKind::link) {
      note(say(text::intake_zip_link, {shown_path(shown)}));
      return;
    }
    if (zip.kind == FileKind::encrypted) throw ContainerError(Trouble::encrypted);
    if (zip.kind != FileKind::regular) throw ContainerError(Trouble::changed);
    if (nested > most_nested) throw ContainerError(Trouble::too_deep);
    if (zips_left_-- <= 0) throw ContainerError(Trouble::too_many_files);
    const auto inner = container.open_zip(zip, unpacked_left_);
    std::vector<FileEntry> entries;
    inner->list([&](const FileEntry& entry) {
      if (is_of_interest(entry, stages_)) entries.push_back(entry);
    });
    look(*inner, std::move(entries), shown.empty() ? "" : shown + "/", nested);
  } catch (const ContainerError& error) {
    note(say(text::intake_zip_trouble, {shown_path(shown), trouble_words(error.trouble)}));
  }
}

void StageFinder::found(Container& container, const FileEntry& entry, const std::string& path,
                        std::size_t stage) {
  std::vector<Copy>& copies = copies_[stage];
  if (copies.size() > most_copies) return;  // too many to be compared, which choose() says
  Copy& copy = copies.emplace_back();
  copy.path = path;
  copy.why = why_of(entry.kind);
  if (copy.why != Why::none) return;
  try {
    auto text = read_text(container.read(entry, most_file));
    copy.why = text ? Why::none : Why::not_text;
    if (text) {
      copy.content = std::move(text->words);
      copy.encoding = text->encoding;
    }
  } catch (const ContainerError& error) {
    copy.why = why_of(error.trouble);
  }
}

std::vector<StageFile> StageFinder::files() {
  std::vector<StageFile> files;
  for (std::size_t i = 0; i < stages_.size(); ++i) files.push_back(choose(i));
  const bool lacking = std::any_of(files.begin(), files.end(),
                                   [](const StageFile& file) { return file.why == Why::missing; });
  if (lacking && !others_.empty()) {
    std::string names;
    for (const std::string& other : others_) names += (names.empty() ? "" : ", ") + other;
    about_files_.push_back(say(text::intake_other_sources, {names}));
  }
  return files;
}

std::vector<std::string> StageFinder::notes() const {
  std::vector<std::string> all = about_files_;
  all.insert(all.end(), notes_.begin(), notes_.end());
  return all;
}

StageFile StageFinder::choose(std::size_t stage) {
  const std::vector<Copy>& copies = copies_[stage];
  // A link beside the file itself is nothing; alone it is why there is no file.
  std::vector<const Copy*> files;
  for (const Copy& copy : copies) {
    if (copy.why != Why::link && copy.why != Why::special) files.push_back(&copy);
  }
  if (files.empty() && !copies.empty()) files.push_back(copies.data());

  std::vector<const Copy*> in_place;
  std::copy_if(files.begin(), files.end(), std::back_inserter(in_place),
               [&](const Copy* copy) { return is_in_place(copy->path, stages_[stage]); });
  const bool some_elsewhere = !in_place.empty() && in_place.size() < files.size();
  StageFile file = choose_among(stage, in_place.empty() ? files : in_place);
  if (some_elsewhere && file.why == Why::none) {
    about_files_.push_back(say(text::intake_in_place, {shown_path(in_place.front()->path)}));
  }
  return file;
}

StageFile StageFinder::choose_among(std::size_t stage, std::vector<const Copy*> copies) {
  StageFile file;
  file.stage = stages_[stage].id;
  const std::string wanted = file.stage + ".cpp";
  const auto not_taken = [&](Why why, std::string words) {
    file.why = why;
    file.words = std::move(words);
    about_files_.push_back(file.words);
    return file;
  };
  if (copies.empty()) return not_taken(Why::missing, say(text::intake_missing, {wanted}));

  const Copy& first = *copies.front();
  const bool alike = std::all_of(copies.begin(), copies.end(), [&](const Copy* copy) {
    return copy->why == first.why && copy->content == first.content;
  });
  if (!alike || copies.size() > most_copies) {
    std::string places;
    for (std::size_t i = 0; i < copies.size() && i < 4; ++i) {
      places += (i == 0 ? "" : ", ") + shown_path(copies[i]->path);
    }
    if (copies.size() > 4) places += ", …";
    return not_taken(Why::twice, say(text::intake_twice, {wanted, places}));
  }
  if (first.why != Why::none)
    return not_taken(first.why, why_words(first.why, shown_path(first.path)));
  file.content = first.content;
  const std::string path = shown_path(first.path);
  if (file_name(first.path) != wanted) {
    about_files_.push_back(say(text::intake_other_case, {path, wanted}));
  }
  if (std::string_view(first.encoding) != "UTF-8") {
    about_files_.push_back(say(text::intake_converted, {path, first.encoding}));
  }
  return file;
}

}  // namespace fos::grading
