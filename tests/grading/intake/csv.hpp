// Tables that instructors make: CSV as RFC 4180 has it, and as a Greek Excel writes it.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fos/text.hpp"

namespace fos::grading {

/// What is wrong with a table, ready to print: `FILE:LINE: error: …`. `exit_status` is 2.
class TableError : public std::runtime_error {
 public:
  TableError(std::string_view file, int line, std::string_view message);
  /// Of a file that cannot be read at all: `FILE: error: …`.
  TableError(std::string_view file, std::string_view message);
  int exit_status = 2;
};

struct TableRow {
  int line = 1;  ///< on which it begins, from 1
  std::vector<std::string> cells;
};

struct Table {
  std::string file;  ///< what it is called in messages
  std::vector<TableRow> rows;
};

/// Fields with or without quotation marks, in which "" is one and line ends are part of the field;
/// separated by what separates the first row: comma, semicolon or tab (or as a row `sep=;` says).
/// Line ends are LF, CRLF or CR. A byte-order mark and empty lines are skipped; white space around
/// a field is dropped. Throws TableError.
Table parse_table(std::string_view text, std::string file);

/// Reads a file in UTF-8, UTF-16 or Windows-1253. Throws TableError.
Table read_table(const std::filesystem::path& path);

/// What the columns of the first row are called, to find them by: `latin()` of it.
std::vector<std::string> column_names(const Table& table);

}  // namespace fos::grading
