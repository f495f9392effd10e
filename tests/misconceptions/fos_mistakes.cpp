// fos_mistakes: what is made of the catalogue of mistakes.
//   fos_mistakes data FOLDER     the data of every stage
//   fos_mistakes pages DOCS      DOCS/en/mistakes.md and DOCS/el/mistakes.md
//   fos_mistakes list STAGE      the ids of its mistakes, a line each
#include <fmt/core.h>

#include <exception>
#include <filesystem>
#include <string>

#include "diagnostic_scenes.hpp"
#include "fos/whole_file.hpp"
#include "make_mistakes.hpp"
#include "pages.hpp"

int main(int argc, char** argv) {
  try {
    const std::string command = argc > 1 ? argv[1] : "";
    if (command == "data" && argc == 3) {
      for (const fos::Stage& stage : fos::stages) {
        const std::filesystem::path folder = argv[2];
        fos::write_whole_file(folder / fmt::format("{}.mistakes", stage.id),
                              fos::encode(fos::make_mistakes(stage), fos::base_scenes()));
      }
      return 0;
    }
    if (command == "pages" && argc == 3) {
      const std::filesystem::path docs = argv[2];
      fos::write_whole_file(docs / "en/mistakes.md", fos::mistakes_page(fos::Language::en));
      fos::write_whole_file(docs / "el/mistakes.md", fos::mistakes_page(fos::Language::el));
      return 0;
    }
    if (command == "list" && argc == 3) {
      for (const fos::Misconception& each : fos::misconceptions()) {
        if ((each.stages & fos::stage_bit(argv[2])) != 0) fmt::print("{}\n", each.id);
      }
      return 0;
    }
    fmt::print(stderr, "usage: fos_mistakes data FOLDER, or pages DOCS, or list STAGE\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "fos_mistakes: {}\n", error.what());
    return 3;
  }
}
