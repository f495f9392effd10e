#include "class_layout.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "file_names.hpp"
#include "platform_names.hpp"
#include "stage_finder.hpp"

namespace fos::grading {
namespace {

/// What lies right below a folder.
struct Level {
  std::map<std::string, std::vector<FileEntry>> folders;  ///< their files of interest
  std::vector<FileEntry> files;                           ///< of interest
  std::vector<std::string> other_files;
};

Level level_below(const Listing& listing, const std::string& root) {
  Level level;
  const auto name_below = [&](std::string_view path) -> std::optional<std::string_view> {
    if (!path.starts_with(root)) return std::nullopt;
    return path.substr(root.size());
  };
  for (const std::string& folder : listing.folders) {
    const auto name = name_below(folder);
    if (name && !name->empty() && name->find('/') == std::string_view::npos)
      level.folders[std::string(*name)];
  }
  for (const std::string& file : listing.other_files) {
    const auto name = name_below(file);
    if (name && name->find('/') == std::string_view::npos) level.other_files.emplace_back(*name);
  }
  for (const FileEntry& entry : listing.files) {
    const auto name = name_below(entry.path);
    if (!name) continue;
    const std::size_t slash = name->find('/');
    FileEntry& mine = slash == std::string_view::npos
                          ? level.files.emplace_back(entry)
                          : level.folders[std::string(name->substr(0, slash))].emplace_back(entry);
    mine.own_from = root.size() + (slash == std::string_view::npos ? 0 : slash + 1);
  }
  return level;
}

bool is_stage_file(std::string_view path, const Stage& stage) {
  return lower(file_name(path)) == std::string(stage.id) + ".cpp";
}

bool is_archive(std::string_view path) {
  return is_zip_name(path) || !other_archive(file_name(path)).empty();
}

/// A folder that the kit has, or a stage's file: so this is one person's.
bool is_one_persons(const Level& level, std::span<const Stage> stages) {
  const bool kit = std::any_of(level.folders.begin(), level.folders.end(), [](const auto& folder) {
    const std::string name = lower(folder.first);
    const bool lecture = name.starts_with("lecture") && name.size() > 7 &&
                         name.find_first_not_of("0123456789", 7) == std::string::npos;
    return name == "labs" || lecture;
  });
  return kit || std::any_of(level.files.begin(), level.files.end(), [&](const FileEntry& entry) {
           return std::any_of(stages.begin(), stages.end(),
                              [&](const Stage& stage) { return is_stage_file(entry.path, stage); });
         });
}

/// Whether two folders have the same thing: one stage's file, or an archive each.
bool folders_repeat(const Level& level, std::span<const Stage> stages) {
  const auto folders_with = [&](const auto& wanted) {
    return std::count_if(level.folders.begin(), level.folders.end(), [&](const auto& folder) {
      return std::any_of(folder.second.begin(), folder.second.end(), wanted);
    });
  };
  if (folders_with([](const FileEntry& entry) { return is_archive(entry.path); }) > 1) return true;
  return std::any_of(stages.begin(), stages.end(), [&](const Stage& stage) {
    return folders_with([&](const FileEntry& e) { return is_stage_file(e.path, stage); }) > 1;
  });
}

/// One person's project seldom has more folders than this beside each other, and none like the
/// kit's.
constexpr std::size_t most_own_folders = 5;

/// The kind, where this level says it; nothing where it is one folder around all.
std::optional<ClassKind> kind_of(const Level& level, const Listing& listing,
                                 const std::string& root, const std::string& path_name,
                                 std::span<const Stage> stages) {
  const auto any_folder = [&](const auto& wanted) {
    return std::any_of(level.folders.begin(), level.folders.end(),
                       [&](const auto& folder) { return wanted(folder.first); });
  };
  const bool listed = std::any_of(
      listing.metadata.begin(), listing.metadata.end(),
      [&](const FileEntry& entry) { return entry.path == root + "submission_metadata.yml"; });
  if (listed && any_folder([](const std::string& name) { return name.starts_with("submission_"); }))
    return ClassKind::gradescope;
  const auto is_moodle = [](std::string_view name) { return moodle_name(name).has_value(); };
  const bool moodle_files =
      std::any_of(level.files.begin(), level.files.end(),
                  [&](const FileEntry& entry) { return is_moodle(entry.own_path()); }) ||
      std::any_of(level.other_files.begin(), level.other_files.end(), is_moodle);
  if (moodle_files || any_folder(is_moodle)) return ClassKind::moodle;
  if (is_one_persons(level, stages)) return ClassKind::one;

  const bool only_a_folder =
      level.folders.size() == 1 && level.files.empty() && level.other_files.empty();
  if (only_a_folder && root.empty()) return std::nullopt;
  const std::string around(
      file_name(std::string_view(root).substr(0, root.size() - !root.empty())));
  const std::string& last = root.empty() ? path_name : around;
  const bool index =
      std::count(level.other_files.begin(), level.other_files.end(), "index.html") > 0;
  const std::size_t work = last.rfind("work_");
  const bool in_course = path_name.find("_work_") != std::string::npos;
  if (work != std::string::npos && is_eclass_folder(std::string_view(last).substr(work)) &&
      (index || in_course) && (work == 0 || root.empty()))
    return ClassKind::eclass;

  const auto archives =
      std::count_if(level.files.begin(), level.files.end(),
                    [](const FileEntry& entry) { return is_archive(entry.path); });
  const std::size_t folders = level.folders.size();
  if (archives > 1 || (archives == 1 && folders > 0) || folders > most_own_folders ||
      folders_repeat(level, stages))
    return ClassKind::folder;
  if (archives == 0 && folders == 1) return std::nullopt;
  return ClassKind::one;
}

/// Collects the files of each person, who may have several folders or zips.
class People {
 public:
  explicit People(const Layout& layout) : layout_(layout) {}

  HandInFiles& of(const std::string& child) {
    std::string key = child;
    Whose whose;
    if (const auto moodle = moodle_name(child)) {
      whose.name = moodle->name;
      whose.number = moodle->number;
      key = moodle->name + "/" + moodle->number;
    } else {
      const std::string_view ending = is_zip_name(child) ? ".zip" : other_archive(child);
      key.resize(key.size() - ending.size());
      if (layout_.kind == ClassKind::eclass) {
        // A lone file of any kind is named after its student, too.
        const std::size_t dot = key.size() == child.size() ? key.rfind('.') : std::string::npos;
        if (dot != std::string::npos && dot > 0 && key.size() - dot <= 5) key.resize(dot);
        whose = eclass_name(key);
      } else {
        whose.name = key;
      }
    }
    const auto [place, is_new] = places_.try_emplace(key, hand_ins_.size());
    if (is_new) {
      whose.source = layout_.root + child;
      hand_ins_.push_back({std::move(whose), {}});
    }
    return hand_ins_[place->second];
  }

  std::vector<HandInFiles> take() { return std::move(hand_ins_); }

 private:
  const Layout& layout_;
  std::map<std::string, std::size_t> places_;
  std::vector<HandInFiles> hand_ins_;
};

void add_people(Layout& layout, const Level& level) {
  People people(layout);
  const auto is_someones = [&](const std::string& name) {
    if (layout.kind == ClassKind::gradescope) return false;
    if (layout.kind == ClassKind::eclass) return name != "index.html";
    return is_archive(name) || moodle_name(name).has_value();
  };
  for (const auto& [name, files] : level.folders) {
    if (layout.kind == ClassKind::gradescope && !name.starts_with("submission_")) {
      layout.left_out.push_back(name);
      continue;
    }
    HandInFiles& hand_in = people.of(name);
    hand_in.files.insert(hand_in.files.end(), files.begin(), files.end());
  }
  for (const FileEntry& file : level.files) {
    const std::string name(file.own_path());
    if (!is_someones(name)) {
      layout.left_out.push_back(name);
      continue;
    }
    FileEntry& mine = people.of(name).files.emplace_back(file);
    if (const auto moodle = moodle_name(name)) mine.own_from += moodle->rest;
  }
  for (const std::string& name : level.other_files) {
    if (is_someones(name)) {
      people.of(name);
    } else if (name != "index.html" && name != "submission_metadata.yml") {
      layout.left_out.push_back(name);
    }
  }
  layout.hand_ins = people.take();
}

}  // namespace

void Listing::add(const FileEntry& entry, std::span<const Stage> stages) {
  if (entry.kind == FileKind::outside) {
    files.push_back(entry);
    return;
  }
  if (is_clutter(entry.path)) return;
  const auto parts = parts_of(entry.path);
  std::string folder;
  const std::size_t above = parts.size() - (entry.kind == FileKind::folder ? 0 : 1);
  for (std::size_t i = 0; i < above && i < 4; ++i) {
    folder += (i == 0 ? "" : "/") + std::string(parts[i]);
    folders.insert(folder);
  }
  if (entry.kind == FileKind::regular && parts.back() == "submission_metadata.yml" &&
      parts.size() <= 3)
    metadata.push_back(entry);
  if (is_of_interest(entry, stages)) {
    files.push_back(entry);
  } else if (entry.kind != FileKind::folder && parts.size() <= 4) {
    other_files.insert(entry.path);
  }
}

Layout find_layout(const Listing& listing, const std::string& name, std::span<const Stage> stages) {
  Layout layout;
  for (int depth = 0; depth < 4; ++depth) {
    const Level level = level_below(listing, layout.root);
    const auto kind = kind_of(level, listing, layout.root, name, stages);
    if (!kind) {
      layout.root += level.folders.begin()->first + "/";
      continue;
    }
    layout.kind = *kind;
    if (*kind != ClassKind::one) {
      add_people(layout, level);
      return layout;
    }
    break;
  }
  return layout_of_one(listing, name);
}

Layout layout_of_one(const Listing& listing, const std::string& name) {
  Layout layout;
  HandInFiles all;
  all.whose.name = name;
  all.whose.source = ".";
  all.files = listing.files;
  layout.hand_ins.push_back(std::move(all));
  return layout;
}

}  // namespace fos::grading
