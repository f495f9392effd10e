#include "json.hpp"

#include "catch2.hpp"

using namespace fos;

TEST_CASE("a string stays one string, whatever is in it") {
  CHECK(json_string("") == R"("")");
  CHECK(json_string("φως \"x\" \\ </script>") == R"("φως \"x\" \\ </script>")");
  CHECK(json_string("a\nb\tc\x7F") == R"("a\u000ab\u0009c\u007f")");
  CHECK(json_string(std::string_view("\0", 1)) == R"("\u0000")");
  CHECK(json_string("\u2028\u2029") == R"("\u2028\u2029")");
  CHECK(json_string("😀€") == "\"😀€\"");
}

TEST_CASE("what is no UTF-8 becomes the replacement character") {
  CHECK(json_string("a\xFF"
                    "b") == R"("a\ufffdb")");
  CHECK(json_string("\xCE") == R"("\ufffd")");
  CHECK(json_string("\xC0\xAF") == R"("\ufffd\ufffd")");
  CHECK(json_string("\xED\xA0\x80") == R"("\ufffd\ufffd\ufffd")");
  CHECK(json_string("\xF5\x80\x80\x80") == R"("\ufffd\ufffd\ufffd\ufffd")");
}

TEST_CASE("base64, as RFC 4648 has it") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string_view("\xFF\xFE\x00", 3)) == "//4A");
}
