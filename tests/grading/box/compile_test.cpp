// Stages compiled in the box: right ones, wrong ones and evil ones.
#include "grading/box/compile.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "catch2.hpp"
#include "fos/stage_program.hpp"
#include "grading/box/box_under_test.hpp"
#include "grading/box/workshop_under_test.hpp"

using namespace fos;
using namespace fos::grading;

namespace {

namespace fs = std::filesystem;

struct Compiled {
  CompileResult result;
  fs::path program;
};

Compiled compile_file(const fs::path& source, const std::string& stage, int lecture,
                      bool sanitized = false) {
  Compiled compiled;
  compiled.program = workshop_under_test().programs() / (stage + (sanitized ? "-sanitized" : ""));
  const std::string name = "labs/lecture0" + std::to_string(lecture) + "/" + stage + ".cpp";
  compiled.result = compile(workshop_under_test(), make_box(), 0,
                            {source, name, lecture, sanitized, compiled.program});
  INFO(compiled.result.output);
  CHECK(compiled.result.ending != CompileEnding::infrastructure);
  return compiled;
}

Compiled compile_text(const std::string& text, int lecture = 4, bool sanitized = false) {
  const fs::path file = test_folder() / "source.cpp";
  std::ofstream(file) << text;
  return compile_file(file, lecture == 4 ? "point" : "flat_color", lecture, sanitized);
}

const std::string black =
    "#include \"fos/stage.hpp\"\nnamespace fos {\nColor trace_ray(const Vec3&,"
    " const Vec3&, Real, Real, const Scene&) { return Color(7); }\n}\n";

Answer ask(const fs::path& program, Frame& frame, bool fresh, std::string* words = nullptr,
           bool sanitized = false) {
  BoxLimits limits;
  limits.memory = std::uint64_t{1} << 30;
  StageProgram stage(stage_command(make_box(), program, limits, sanitized),
                     {std::chrono::minutes(1), 0, true, fresh});
  const Answer answer = stage.ask({"scene", "canvas_size = 4 x 4\n", 4, 4}, frame);
  if (words != nullptr) *words = stage.words();
  return answer;
}

}  // namespace

TEST_CASE("the solutions compile without a word, and answer") {
  FOS_NEEDS_BOX();
  const fs::path solutions = FOS_SOURCE_FOLDER "/solutions";
  for (const char* stage : {"ambient", "point", "directional", "combined"}) {
    const auto compiled =
        compile_file(solutions / "lecture04" / (std::string(stage) + ".cpp"), stage, 4);
    CHECK(compiled.result.ending == CompileEnding::compiled);
    CHECK(compiled.result.output.empty());
    Frame frame;
    CHECK(ask(compiled.program, frame, true).ending == Ending::complete);
    CHECK(frame.channels.size() == 48);
  }
  const auto flat = compile_file(solutions / "lecture03/flat_color.cpp", "flat_color", 3);
  CHECK(flat.result.ending == CompileEnding::compiled);
}

TEST_CASE("what lecture 3 builds is not there for it") {
  FOS_NEEDS_BOX();
  const std::string text = "#include \"fos/closest_hit.hpp\"\n" + black;
  const auto early = compile_text(text, 3);
  CHECK(early.result.ending == CompileEnding::rejected);
  CHECK_THAT(early.result.output, ContainsSubstring("labs/lecture03/flat_color.cpp:1:10"));
  CHECK(compile_text(text, 4).result.ending == CompileEnding::compiled);
  // A student's own, where the header is not asked for.
  CHECK(
      compile_text(black + "namespace fos { struct Hit {}; int closest_hit; }", 4).result.ending ==
      CompileEnding::compiled);
}

TEST_CASE("what the compiler says is kept, and warnings do not count") {
  FOS_NEEDS_BOX();
  const auto warned = compile_text(black + "int unused(double x) { int y = x; return 3; }\n");
  CHECK(warned.result.ending == CompileEnding::compiled);
  CHECK_THAT(warned.result.output, ContainsSubstring("labs/lecture04/point.cpp:5:"));
  CHECK_THAT(warned.result.output, ContainsSubstring("warning:"));
  const auto wrong = compile_text(black + "int f() { return a; }\n");
  CHECK(wrong.result.ending == CompileEnding::rejected);
  CHECK_THAT(wrong.result.output, ContainsSubstring("labs/lecture04/point.cpp:5:18: error:"));
  CHECK(wrong.result.output.find(test_folder().string()) == std::string::npos);
  CHECK(compile_text("#include \"fos/stage.hpp\"\n").result.ending == CompileEnding::rejected);
}

TEST_CASE("nothing that the box does not show gets into a program or a message") {
  FOS_NEEDS_BOX();
  const std::string secret = secret_file().string();
  const auto included = compile_text("#include \"" + secret + "\"\n" + black);
  CHECK(included.result.ending == CompileEnding::rejected);
  CHECK(included.result.output.find("the reference") == std::string::npos);
  const auto assembled = compile_text(black + R"(asm(".incbin \")" + secret + R"(\"");)" + "\n");
  CHECK(assembled.result.ending == CompileEnding::rejected);
  if (make_box().level() != Level::uid) {
    const auto passwd = compile_text("#include \"/etc/passwd\"\n" + black);
    CHECK(passwd.result.output.find("root:") == std::string::npos);
    CHECK(compile_text("#include \"" FOS_SOURCE_FOLDER "/solutions/lecture04/point.cpp\"\n")
              .result.ending == CompileEnding::rejected);
  }
}

TEST_CASE("compilers that do not end, or take all there is, are stopped") {
  FOS_NEEDS_BOX();
  for (const char* text :
       {"#include </dev/random>\n", "#include \"/dev/zero\"\n",
        "template <int N> struct A { typename A<N + 1>::t x; typename A<N + 2>::t y; };"
        "A<0> a;\n",
        "constexpr long f(long n) { long s = 0; for (long i = 0; i < n; ++i) for (long j = 0; j < "
        "n;"
        " ++j) s += j; return s; } constexpr long x = f(1000000000);\n",
        "char big[3000000000] = {1};\n", "#include __FILE__\n",
        R"(asm(".rept 1000000000\n.quad 0\n.endr");)"}) {
    INFO(text);
    const auto bomb = compile_text(black + text);
    CHECK(bomb.result.ending != CompileEnding::infrastructure);
    CHECK(bomb.result.output.size() <= 131072);
    CHECK(bomb.result.run.cpu_seconds < 40);
  }
}

TEST_CASE("a crash is found by sanitizers") {
  FOS_NEEDS_BOX();
  const std::string crashing =
      "#include \"fos/stage.hpp\"\nnamespace fos {\nColor trace_ray(const Vec3&, const Vec3&, Real,"
      " Real, const Scene& scene) {\n  return scene.spheres[1000].color;\n}\n}\n";
  const auto compiled = compile_text(crashing, 4, true);
  INFO(compiled.result.output);
  REQUIRE(compiled.result.ending == CompileEnding::compiled);
  Frame frame;
  std::string words;
  CHECK(ask(compiled.program, frame, false, &words, true).ending != Ending::complete);
  CHECK_THAT(words, ContainsSubstring("labs/lecture04/point.cpp:4"));
}

// Not run unless asked for: box_test "[speed]".
TEST_CASE("what the box costs", "[.speed]") {
  FOS_NEEDS_BOX();
  const auto cpu = [] {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  };
  const auto measure = [&](const char* what, int times, const auto& work) {
    work();
    const double before = cpu();
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i) work();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    std::printf("%-34s %7.1f ms of processor time, %7.1f ms by the clock\n", what,
                1e3 * (cpu() - before) / times, 1e3 * wall.count() / times);
  };
  const fs::path source = FOS_SOURCE_FOLDER "/solutions/lecture04/point.cpp";
  measure("nothing, in the box", 50, [] { run(make_box(), attack("nothing")); });
  measure("nothing, outside", 50, [] {
    const std::string command = attack("nothing").shown[0].host.string() + " nothing";
    if (std::system(command.c_str()) != 0) std::puts("?");
  });
  measure("a stage compiled, in the box", 20, [&] { compile_file(source, "point", 4); });
  const fs::path program = workshop_under_test().programs() / "point";
  measure("a stage asked one small scene", 50, [&] {
    Frame frame;
    ask(program, frame, true);
  });
}
