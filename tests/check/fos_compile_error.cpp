// `fos_compile_error FILE [NAME]`: reads what the compiler said, in English, and says why FILE,
// called NAME, does not compile. Exit status 1, as for any stage that does not build; 2 for wrong
// usage.
#include <iostream>
#include <iterator>
#include <string>

#include "compile_error.hpp"
#include "fos/text.hpp"

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << fos::say(fos::text::tool_error) << ": " << fos::say(fos::text::tool_usage) << '\n';
    return 2;
  }
  const std::string output{std::istreambuf_iterator<char>(std::cin), {}};
  std::cout << fos::describe_compile_error(output, argv[1], argv[argc - 1]);
  return 1;
}
