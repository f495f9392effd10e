// Text that a student made, escaped for where it goes: one function for each place. All of them
// clean it first (clean_text.hpp).
#pragma once

#include <string>
#include <string_view>

namespace fos::grading {

/// HTML and XML, between tags and in attributes that stand in quotation marks.
std::string markup(std::string_view text);

/// One part of an address, in an attribute: no slash, no scheme, nothing but the file of that name.
std::string address(std::string_view text);

/// A cell of CSV (RFC 4180), in quotation marks where it needs them, in one line. What a
/// spreadsheet would take for a formula, also one that splits at another separator, is not: an
/// apostrophe stands before it.
std::string csv_cell(std::string_view text);

/// Whether the cell reads as this very text: what names a user must not be changed.
bool is_plain_cell(std::string_view text);

/// A line of a workflow's log: no command of GitHub Actions (`::notice`, `##[…]`) is left in it.
std::string workflow_text(std::string_view text);

/// GitHub's Markdown, in a paragraph or a cell of a table: nothing in it is markup, a link or a
/// mention. Line ends become <br>.
std::string markdown(std::string_view text);

/// The same between <pre> and </pre>, where line ends are kept.
std::string markdown_block(std::string_view text);

}  // namespace fos::grading
