#include "escape.hpp"

#include "catch2.hpp"
#include "clean_text.hpp"
#include "markup_writer.hpp"

using namespace fos::grading;

TEST_CASE("Text is cleaned: valid, in lines, without what a terminal obeys") {
  CHECK(clean("Μαρία 😀\tx\n") == "Μαρία 😀\tx\n");
  CHECK(clean("a\r\nb\rc\u2028d\u2029e") == "a\nb\nc\nd\ne");
  CHECK(clean("\033[31m\007\x7f") == "␛[31m␇␡");
  CHECK(clean(std::string_view("\0", 1)) == "␀");
  CHECK(clean("\u0085\u009b") == "\uFFFD\uFFFD");
  CHECK(clean("\u202Ex\u202C\u2066\u2069\u061C\u200F\uFEFF\uFFFE\uFDD0") ==
        "\uFFFDx\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD");
  CHECK(clean("\xC3\x28") == "\uFFFD(");
  CHECK(clean("\xED\xA0\x80") == "\uFFFD\uFFFD\uFFFD");
  CHECK(clean("\xF4\x90\x80\x80") == "\uFFFD\uFFFD\uFFFD\uFFFD");
  // A slash in two, three and four bytes.
  CHECK(clean("\xC0\xAF") == "\uFFFD\uFFFD");
  CHECK(clean("\xE0\x80\xAF") == "\uFFFD\uFFFD\uFFFD");
  CHECK(clean("\xF0\x80\x80\xAF") == "\uFFFD\uFFFD\uFFFD\uFFFD");
  CHECK(clean("\xE2\x82") == "\uFFFD\uFFFD");
  CHECK(clean("\U0010FFFD é €") == "\U0010FFFD é €");
  CHECK(one_line(" a \n\t b\r\n") == "a b");
  CHECK(shortened("αβγ", 3) == "αβγ");
  CHECK(shortened("αβγ", 2) == "αβ…");
}

TEST_CASE("HTML and XML") {
  CHECK(markup(R"(<a href="x" b='y'>&`)") ==
        "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp;&#96;");
  CHECK(markup("\uFFFF\x01") == "\uFFFD␁");
}

TEST_CASE(
    "A writer of markup keeps the line ends of an attribute, which a reader would make spaces") {
  MarkupWriter out;
  out.raw("<a").attribute("b", "x\n\"y\t").raw(">").text("<\n").raw("</a>").element("c", "");
  CHECK(out.str() == "<a b=\"x&#10;&quot;y&#9;\">&lt;\n</a>");
}

TEST_CASE("An address is a file beside the page") {
  CHECK(address("point-yours.png") == "point-yours.png");
  CHECK(address("javascript:x") == "javascript%3Ax");
  CHECK(address("//evil.example/x?y#z") == "%2F%2Fevil.example%2Fx%3Fy%23z");
  CHECK(address("..") == "_");
  CHECK(address("") == "_");
  CHECK(address(R"(α")") == "%CE%B1%22");
}

TEST_CASE("A cell is no formula, at whichever separator it is cut") {
  CHECK(csv_cell("Μαρία Π.") == "Μαρία Π.");
  CHECK(csv_cell(R"(a, "b")") == R"("a, ""b""")");
  CHECK(csv_cell("=1+1") == R"("'=1+1")");
  for (const char* begin : {"=", "+", "-", "@", "\t=", "\r=", " \n =", "＝", "＋", "－", "＠"}) {
    CAPTURE(begin);
    CHECK(csv_cell(std::string(begin) + "1").substr(0, 2) == R"("')");
    CHECK(!is_plain_cell(std::string(begin) + "1"));
  }
  CHECK(csv_cell("a;=1") == R"("a;'=1")");
  CHECK(csv_cell(R"(a", =1)") == R"("a"", '=1")");
  CHECK(csv_cell("a|@x") == R"("a|'@x")");
  CHECK(csv_cell("a - b, c=d") == R"("a - b, c=d")");
  CHECK(csv_cell("a\nb") == "a b");
  CHECK(is_plain_cell("a, b"));
  CHECK(!is_plain_cell("a\nb"));
}

TEST_CASE("No command of a workflow is left") {
  CHECK(workflow_text("std::vector") == "std: :vector");
  CHECK(workflow_text("::::x") == ": : : :x");
  CHECK(workflow_text(":\u200b\u00ad\uFE0F:error") == ": :error");
  CHECK(workflow_text("##[error]") == "# #[error]");
  CHECK(workflow_text("#\u2060#[x") == "# #[x");
}

TEST_CASE("Markdown shows text as it is") {
  CHECK(markdown("a*b_c|[d](e)\nf") == "a&#42;b&#95;c&#124;&#91;d&#93;(e)<br>f");
  CHECK(markdown("<b> & @x #1 http://x") == "&#60;b&#62; &#38; &#64;x &#35;1 http&#58;&#47;&#47;x");
  CHECK(markdown_block("</pre>::x\n") == "&#60;&#47;pre&#62;&#58;&#58;x\n");
}
