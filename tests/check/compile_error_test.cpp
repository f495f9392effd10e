// What a compiler says, and what is made of it. broken.sh has real outputs of the compiler here;
// these are outputs of others, of several files at once, and of linkers.
#include "compile_error.hpp"

#include <fstream>
#include <sstream>

#include "../common/folder.hpp"
#include "catch2.hpp"
#include "clean_message.hpp"
#include "compiler_output.hpp"
#include "layout.hpp"
#include "matches.hpp"

using namespace fos;

namespace {

/// A student's file of these lines.
struct StudentFile {
  explicit StudentFile(const std::string& text) {
    std::filesystem::create_directory(folder.path / "lecture04");
    path = folder.path / "lecture04" / "point.cpp";
    std::ofstream(path) << text;
  }
  Folder folder;
  std::filesystem::path path;
};

CompileError found(const std::string& output, const std::filesystem::path& file) {
  const auto error = find_compile_error(output, file);
  REQUIRE(error);
  return *error;
}

}  // namespace

TEST_CASE("patterns with holes", "[compile]") {
  CHECK(matches("the 'a' of 'b'", "'*' of '*'") == std::vector<std::string>{"a", "b"});
  CHECK(matches("x: end", ": *") == std::vector<std::string>{"end"});
  CHECK(matches("no holes", "hole") == std::vector<std::string>{});
  CHECK_FALSE(matches("'a of", "'*' of"));
}

TEST_CASE("messages made readable", "[compile]") {
  CHECK(
      clean_message("cannot convert ‘glm::vec<3, double, glm::packed_highp>’ to ‘const fos::Real’ "
                    "{aka ‘const double’} in initialization") ==
      "cannot convert 'Vec3' to 'const Real' in initialization");
  CHECK(clean_message("no viable conversion from 'vec<3, double, (glm::qualifier)0U>' to 'const "
                      "fos::Real' (aka 'const double')") ==
        "no viable conversion from 'Vec3' to 'const Real'");
  CHECK(clean_message("‘const struct fos::Scene’ has no member named ‘Lights’") ==
        "'const Scene' has no member named 'Lights'");
  CHECK(clean_message("‘hit.std::optional<fos::Hit>::operator->()->fos::Hit::sphere’ is") ==
        "'hit->sphere' is");
  CHECK(clean_message("‘class std::vector<fos::PointLight, std::allocator<fos::PointLight> >’ x") ==
        "'std::vector<PointLight>' x");
  CHECK(clean_message("no return statement in function [-Werror=return-type]") ==
        "no return statement in function");
  CHECK(clean_message("an odd vec<3, double that never ends") ==
        "an odd vec<3, double that never ends");
}

TEST_CASE("the first error in the student's file, of several files", "[compile]") {
  const StudentFile file("int main() {\n  return x;\n}\n");
  const std::string output =
      "[1/4] Building CXX object CMakeFiles/lab_ambient.dir/labs/lecture04/ambient.cpp.o\n"
      "FAILED: CMakeFiles/lab_ambient.dir/labs/lecture04/ambient.cpp.o \n"
      "/usr/bin/c++ -c /t/labs/lecture04/ambient.cpp\n"
      "/t/labs/lecture04/ambient.cpp:3:1: error: ‘first’ was not declared in this scope\n"
      "FAILED: CMakeFiles/lab_point.dir/labs/lecture04/point.cpp.o \n"
      "/t/labs/lecture04/point.cpp: In function ‘int main()’:\n"
      "/t/labs/lecture04/point.cpp:1:3: warning: unused variable ‘a’ [-Wunused-variable]\n"
      "../../labs/lecture04/point.cpp:2:10: error: ‘x’ was not declared in this scope\n"
      "    2 |   return x;\n"
      "      |          ^\n"
      "/t/labs/lecture04/point.cpp:3:1: error: a later one\n"
      "ninja: build stopped: cannot make progress due to previous errors.\n";
  const CompileError error = found(output, file.path);
  CHECK(error.line == 2);
  CHECK(error.column == 10);
  CHECK(error.message == "'x' was not declared in this scope");
  CHECK(error.source == "  return x;");
  CHECK_FALSE(find_compile_error(output, "labs/lecture04/combined.cpp"));
  CHECK_FALSE(find_compile_error(output, "labs/lecture03/point.cpp"));
}

TEST_CASE("an error in a library is told at the student's line", "[compile]") {
  const StudentFile file("#include \"a.hpp\"\n\nint f() { return g(1); }\n");
  SECTION("g++") {
    const std::string output =
        "In file included from /usr/include/a.hpp:1,\n"
        "                 from /t/lecture04/point.cpp:1:\n"
        "/usr/include/a.hpp: In instantiation of ‘int g(T) [with T = int]’:\n"
        "/usr/include/b.hpp:7:8:   required from ‘int h(T) [with T = int]’\n"
        "/t/lecture04/point.cpp:3:20:   required from here\n"
        "/usr/include/a.hpp:9:15: error: static assertion failed: no\n";
    CHECK(found(output, file.path).line == 3);
    CHECK(found(output, file.path).column == 20);
  }
  SECTION("clang++") {
    const std::string output =
        "In file included from /t/lecture04/point.cpp:1:\n"
        "/usr/include/a.hpp:9:15: error: static_assert failed \"no\"\n"
        "/t/lecture04/point.cpp:3:19: note: in instantiation of function template specialization "
        "'g<int>' requested here\n"
        "1 error generated.\n";
    CHECK(found(output, file.path).line == 3);
    CHECK(found(output, file.path).column == 19);
  }
  SECTION("the header itself is broken") {
    const std::string output =
        "In file included from /t/lecture04/point.cpp:1:\n"
        "/usr/include/a.hpp:9:15: error: expected ‘;’ before ‘}’ token\n";
    CHECK(found(output, file.path).line == 1);
  }
  SECTION("another file's inclusions do not count for the next error") {
    const std::string output =
        "In file included from /t/lecture04/point.cpp:1:\n"
        "/usr/include/a.hpp:9:15: warning: hm\n"
        "/t/lecture04/other.cpp:9:15: error: expected ‘;’ before ‘}’ token\n";
    CHECK_FALSE(find_compile_error(output, file.path));
  }
}

TEST_CASE("the linker's errors count where the compiler has none", "[compile]") {
  const StudentFile file("int f();\n");
  const std::string undefined =
      "/usr/bin/ld: common/libfos_common.a(render.cpp.o): in function `fos::render(fos::Scene "
      "const&)':\n"
      "render.cpp:(.text+0x390): undefined reference to `fos::trace_ray(glm::vec<3, double, "
      "(glm::qualifier)0> const&, glm::vec<3, double, (glm::qualifier)0> const&, double, double, "
      "fos::Scene const&)'\n"
      "collect2: error: ld returned 1 exit status\n";
  const CompileError error = found(undefined, file.path);
  CHECK(error.line == 0);
  CHECK_THAT(error.word, ContainsSubstring("trace_ray(Vec3 const&, Vec3 const&, double"));
  CHECK_THAT(error.word, ContainsSubstring("namespace fos"));
  CHECK_THAT(describe_compile_error(undefined, file.path, "point.cpp"),
             ContainsSubstring("point.cpp: undefined reference to 'trace_ray("));
  CHECK(found(undefined + "/t/lecture04/point.cpp:1:1: error: other\n", file.path).line == 1);

  const std::string multiple =
      "/usr/bin/ld: stage_main.cpp.o: in function `main':\n"
      "stage_main.cpp:(.text.startup+0x0): multiple definition of `main'; "
      "point.cpp.o:point.cpp:(.text+0x2c6): first defined here\n";
  CHECK_THAT(found(multiple, file.path).word, ContainsSubstring("already has: main."));
}

TEST_CASE("columns are of characters, whatever the compiler counts", "[compile]") {
  const StudentFile file("\tint α = x; // α\n");
  // g++: a tab goes to column 9, α is one column. clang++: bytes.
  const std::string gcc = "/t/lecture04/point.cpp:1:17: error: some error\n";
  const std::string clang = "/t/lecture04/point.cpp:1:11: error: some error\n1 error generated.\n";
  for (const std::string& output : {gcc, clang}) {
    CHECK(found(output, file.path).column == 10);
    CHECK_THAT(describe_compile_error(output, file.path, "point.cpp"),
               ContainsSubstring("    1 |  int α = x; // α\n"
                                 "      |          ^\n"));
  }
}

TEST_CASE("a missing semicolon is shown where it is missing", "[compile]") {
  const StudentFile file("Real i = 0  // zero\n\n  // then\n  return i;\n");
  const auto error =
      found("/t/lecture04/point.cpp:4:3: error: expected ‘,’ or ‘;’ before ‘return’\n", file.path);
  CHECK(error.line == 1);
  CHECK(error.column == 11);
  // In the middle of a line it is there.
  const auto inside =
      found("/t/lecture04/point.cpp:4:10: error: expected ‘;’ before ‘i’\n", file.path);
  CHECK(inside.line == 4);
}

TEST_CASE("what is not common is the compiler's message alone", "[compile]") {
  const StudentFile file("a\n");
  const std::string output = "/t/lecture04/point.cpp:1:1: error: something rare\n";
  CHECK(found(output, file.path).word.empty());
  CHECK(describe_compile_error(output, file.path, "labs/lecture04/point.cpp") ==
        "labs/lecture04/point.cpp:1:1: something rare\n    1 | a\n      | ^\n");
  CHECK_THAT(describe_compile_error("c++: fatal error: Killed signal terminated program cc1plus\n",
                                    file.path, "point.cpp"),
             ContainsSubstring("Killed signal"));
  CHECK_FALSE(describe_compile_error("", file.path, "point.cpp").empty());
  // A file that cannot be read, or has become shorter.
  CHECK(found(output, "/nonexistent/lecture04/point.cpp").source.empty());
  CHECK(found("/t/lecture04/point.cpp:99:7: error: expected ‘;’ before ‘i’\n", file.path).line ==
        99);
}

TEST_CASE("it fits the screen, whatever the compiler says", "[compile]") {
  const StudentFile file(std::string(300, 'x') + " = y;\n");
  std::string longest = "/t/lecture04/point.cpp:1:302: error: no match for ‘operator=’ (";
  for (int i = 0; i < 100; ++i) longest += "std::tuple<μακρύς τύπος> ";
  const std::string words = describe_compile_error(longest + ")\n", file.path, "point.cpp");
  std::istringstream lines(words);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    INFO(line);
    CHECK(columns_of(line) <= terminal_width);
  }
  CHECK(count <= 8);
  CHECK_THAT(words, ContainsSubstring(" = y;"));
}
