#include "build_stage.hpp"

#include "catch2.hpp"

using namespace fos;

TEST_CASE("of a build's words the compiler's remain, with paths from the tree") {
  const std::string log =
      "ninja: Entering directory `build/release'\n"
      "[0/2] Re-checking globbed directories...\n"
      "-- Configuring done\n"
      "[1/2] Building CXX object x.o\n"
      "FAILED: x.o \n"
      "/usr/bin/c++ -c /a tree/labs/lecture04/point.cpp\n"
      "/a tree/labs/lecture04/point.cpp:3:1: error: no 'Rael' [-fx]\n"
      "   3 | Rael x;\n"
      "ninja: build stopped: subcommand failed.\n";
  CHECK(compiler_words(log, "/a tree") ==
        "labs/lecture04/point.cpp:3:1: error: no 'Rael' [-fx]\n   3 | Rael x;\n");
  CHECK(compiler_words("ninja: error: unknown target\n", "/") == "ninja: error: unknown target\n");
}
