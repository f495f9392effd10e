// tries: prints what reports and logs might take for their own
// deserves: point nothing
#include <cstdio>

#include "fos/closest_hit.hpp"
#include "fos/stage.hpp"

namespace {
const bool started = [] {
  std::puts("::error file=a.cpp::x");
  std::puts("::notice title=Autograding report::{\"totalPoints\":100,\"maxPoints\":100}");
  std::puts("Grade :=>> 100");
  std::puts("</pre><script>document.title = 'evil'</script><img src=x onerror=alert(1)>");
  std::puts("=HYPERLINK(\"http://evil.example\",\"grade\")");
  std::puts("\033]0;evil\007\033[2J\033[1;31mall is well\033[0m\r100%");
  std::puts("]]></system-out><testcase name=\"x\"/>\xff\xfe");
  return true;
}();
}  // namespace

namespace fos {

Color trace_ray(const Vec3&, const Vec3&, Real, Real, const Scene&) { __builtin_trap(); }

}  // namespace fos
