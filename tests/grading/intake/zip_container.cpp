// A zip, by libzip: its list, and its files read with a limit that does not trust what it claims.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <utility>

#include "container.hpp"
#include "encoding.hpp"
#include "file_names.hpp"
#include "limits.hpp"
#include "zip_bytes.hpp"

namespace fos::grading {
namespace {

Trouble trouble_of(int libzip_error) {
  switch (libzip_error) {
    case ZIP_ER_NOZIP:
      return Trouble::not_a_zip;
    case ZIP_ER_COMPNOTSUPP:
    case ZIP_ER_MULTIDISK:
      return Trouble::unsupported;
    case ZIP_ER_ENCRNOTSUPP:
    case ZIP_ER_NOPASSWD:
    case ZIP_ER_WRONGPASSWD:
      return Trouble::encrypted;
    default:
      return Trouble::damaged;
  }
}

/// By the rights and type that a Unix zip keeps with each file; other systems have no links.
FileKind kind_of(zip_t* zip, zip_uint64_t index) {
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  if (zip_file_get_external_attributes(zip, index, 0, &system, &attributes) != 0)
    return FileKind::regular;
  if (system != ZIP_OPSYS_UNIX && system != ZIP_OPSYS_OS_X) return FileKind::regular;
  const mode_t type = (attributes >> 16U) & S_IFMT;
  if (type == 0 || type == S_IFREG) return FileKind::regular;
  if (type == S_IFDIR) return FileKind::folder;
  return type == S_IFLNK ? FileKind::link : FileKind::special;
}

class Zip : public Container {
 public:
  Zip(std::unique_ptr<ZipBytes> bytes, ListLimits limits);
  ~Zip() override { zip_discard(zip_); }
  Zip(const Zip&) = delete;
  Zip& operator=(const Zip&) = delete;

  void list(const std::function<void(const FileEntry&)>& visit) override;
  std::string read(const FileEntry& entry, std::size_t most) override;
  std::unique_ptr<Container> open_zip(const FileEntry& entry, std::size_t& budget) override;

 private:
  FileEntry entry_at(zip_uint64_t index);

  std::unique_ptr<ZipBytes> bytes_;
  zip_t* zip_ = nullptr;
};

Zip::Zip(std::unique_ptr<ZipBytes> bytes, ListLimits limits) : bytes_(std::move(bytes)) {
  // A zip that lost its end is a damaged zip, not another kind of file.
  if (bytes_->size() == 0) throw ContainerError(Trouble::not_a_zip);  // to libzip, a new zip
  const bool begins_as_zip = bytes_->head(4).starts_with("PK");
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = bytes_->source(&error);
  if (source == nullptr) throw ContainerError(Trouble::damaged);
  bytes_->limit(limits.directory);
  zip_ = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (zip_ == nullptr) {
    Trouble trouble = trouble_of(zip_error_code_zip(&error));
    zip_source_free(source);
    zip_error_fini(&error);
    if (trouble == Trouble::not_a_zip && begins_as_zip) trouble = Trouble::damaged;
    if (bytes_->limit_was_met()) trouble = Trouble::too_many_files;
    throw ContainerError(trouble);
  }
  bytes_->no_limit();
  if (std::cmp_greater(zip_get_num_entries(zip_, 0), limits.files)) {
    zip_discard(zip_);
    throw ContainerError(Trouble::too_many_files);
  }
}

FileEntry Zip::entry_at(zip_uint64_t index) {
  FileEntry entry;
  entry.index = index;
  zip_stat_t stat;
  zip_stat_init(&stat);
  const char* name = zip_get_name(zip_, index, ZIP_FL_ENC_RAW);
  if (name == nullptr || zip_stat_index(zip_, index, 0, &stat) != 0) {
    entry.kind = FileKind::outside;  // nobody can say where it belongs
    return entry;
  }
  const std::string decoded = read_name(name);
  auto path = clean_path(decoded);
  entry.path = path ? std::move(*path) : decoded.substr(0, 200);
  entry.size = (stat.valid & ZIP_STAT_SIZE) != 0 ? stat.size : 0;
  const bool locked =
      (stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE;
  entry.kind = !path                                               ? FileKind::outside
               : decoded.ends_with('/') || decoded.ends_with('\\') ? FileKind::folder
                                                                   : kind_of(zip_, index);
  if (entry.kind == FileKind::regular && locked) entry.kind = FileKind::encrypted;
  return entry;
}

void Zip::list(const std::function<void(const FileEntry&)>& visit) {
  const zip_int64_t count = zip_get_num_entries(zip_, 0);
  for (zip_int64_t i = 0; i < count; ++i) visit(entry_at(static_cast<zip_uint64_t>(i)));
}

std::string Zip::read(const FileEntry& entry, std::size_t most) {
  if (entry.kind == FileKind::encrypted) throw ContainerError(Trouble::encrypted);
  if (entry.size > most) throw ContainerError(Trouble::too_large);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen_index(zip_, entry.index, 0), zip_fclose);
  if (!file) throw ContainerError(trouble_of(zip_error_code_zip(zip_get_error(zip_))));
  std::string out;
  std::array<char, 65536> part;
  for (;;) {
    const zip_int64_t got = zip_fread(file.get(), part.data(), part.size());
    if (got < 0) throw ContainerError(Trouble::damaged);
    if (got == 0) return out;
    out.append(part.data(), static_cast<std::size_t>(got));
    if (out.size() > most) throw ContainerError(Trouble::too_large);
  }
}

std::unique_ptr<Container> Zip::open_zip(const FileEntry& entry, std::size_t& budget) {
  const std::size_t most = std::min(budget, most_inner_zip);
  std::string bytes;
  try {
    bytes = read(entry, most);
  } catch (const ContainerError& error) {
    // One that claimed less than it holds was unpacked all the same, as far as that went.
    if (error.trouble == Trouble::too_large && entry.size <= most) budget -= most;
    throw;
  }
  budget -= bytes.size();
  return open_zip_bytes(std::move(bytes), {most_directory, most_files});
}

}  // namespace

std::unique_ptr<Container> open_zip_descriptor(int owned, ListLimits limits) {
  struct stat status {};
  if (fstat(owned, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(owned);
    throw ContainerError(Trouble::changed);
  }
  return std::make_unique<Zip>(
      std::make_unique<ZipBytes>(owned, static_cast<std::uint64_t>(status.st_size)), limits);
}

std::unique_ptr<Container> open_zip_file(const std::filesystem::path& path, ListLimits limits) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0) {
    throw ContainerError(errno == EACCES || errno == EPERM ? Trouble::not_allowed
                                                           : Trouble::changed);
  }
  return open_zip_descriptor(descriptor, limits);
}

std::unique_ptr<Container> open_zip_bytes(std::string bytes, ListLimits limits) {
  return std::make_unique<Zip>(std::make_unique<ZipBytes>(std::move(bytes)), limits);
}

}  // namespace fos::grading
