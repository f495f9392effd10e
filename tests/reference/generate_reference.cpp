// generate_reference SCENE.scene OUT.ref: certifies a scene and writes its reference data.
//
// Exit status: 0 done, 2 wrong usage or input, 3 anything else, such as a disk that is full.

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "fos/scene_text.hpp"
#include "generate.hpp"
#include "oracle.hpp"
#include "reference_file.hpp"

namespace {

constexpr int bad_input = 2;
constexpr int trouble = 3;

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) throw std::runtime_error("cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: generate_reference SCENE.scene OUT.ref\n";
    return bad_input;
  }
  const std::string scene_path = argv[1];
  try {
    const fos::SceneText scene = fos::parse_scene_text(read_text(scene_path), scene_path);
    fos::reference::write_reference(argv[2], fos::reference::generate(scene));
  } catch (const fos::SceneError& error) {
    std::cerr << error.what() << '\n';
    return bad_input;
  } catch (const fos::reference::ReferenceError& error) {
    std::cerr << "error: " << error.what() << '\n';
    return trouble;
  } catch (const std::runtime_error& error) {
    std::cerr << scene_path << ": error: " << error.what() << '\n';
    return bad_input;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return trouble;
  }
  return 0;
}
