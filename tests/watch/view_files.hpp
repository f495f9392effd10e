// The page in the browser and what it is told, as files beside the pictures.
#pragma once

#include <filesystem>
#include <string>

#include "picture_maker.hpp"
#include "view_data.hpp"

namespace fos {

class ViewFiles {
 public:
  /// Writes the page, viewer.html. Throws FileError.
  explicit ViewFiles(std::filesystem::path images);

  /// file://…, to open the page.
  std::string url() const;

  /// Writes what the page shows of a check: the values of wrong pixels, STAGE-view.js, and at the
  /// end view-now.js, which tells the page to load them. `view` has neither id nor pictures yet.
  /// Throws FileError. Where a picture cannot be made the page shows the words alone, and this
  /// returns why; else nothing.
  std::string write(View view, PictureMaker& maker);

 private:
  std::string png(const Bitmap& bitmap, PictureMaker& maker) const;
  void remove_older_values(const View& view, int last) const;
  std::filesystem::path values_file(const Stage& stage, int part) const;
  std::filesystem::path file(const Stage& stage, const std::string& rest) const;

  std::filesystem::path images_;
};

}  // namespace fos
