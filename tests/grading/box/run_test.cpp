#include "catch2.hpp"
#include "grading/box/run.hpp"
using namespace fos::grading;
TEST_CASE("t") {
  for (Level level : {Level::bubblewrap, Level::landlock, Level::uid}) {
    Box box({level, FOS_BOX_INSIDE, "/usr/bin/g++", 0}, 0, "/tmp/bx_scratch");
    Errand e; e.words = {"/usr/bin/id"}; e.compiler = true;
    const auto r = run(box, e);
    INFO(std::string(name(level)) << " " << (int)r.ending << " " << r.status << " " << r.output << r.cpu_seconds);
    CHECK(r.succeeded());
    CHECK(r.output == "");
    }
}
