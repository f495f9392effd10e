// fos_picture: asks stage programs for frames and makes files of them. `./lab` calls it.
//   fos_picture render --scene F --images FOLDER [--size WxH] [--output F] [--sheet] JOB...
//     A JOB is NAME:STAGE:PROGRAM; its picture is FOLDER/NAME.png, or the one --output. --sheet
//     also makes FOLDER/all.png of them all.
//   fos_picture serve      makes what it is asked on standard input (fos/picture_job.hpp)
#include <fmt/core.h>
#include <getopt.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>

#include "fos/picture.hpp"
#include "fos/progress.hpp"
#include "fos/stage_list.hpp"
#include "fos/stage_program.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "picture_serve.hpp"

namespace {

using fos::say;
namespace text = fos::text;

constexpr int sheet_columns = 5;
constexpr int sheet_panel = 300;

/// What is wrong with the command line, and the exit status it ends with.
struct Failure {
  int status;
  std::string message;
};

struct Job {
  std::string name;
  std::string stage;
  std::filesystem::path program;
};

struct Options {
  std::filesystem::path scene;
  std::filesystem::path images;
  std::filesystem::path output;
  std::string size;
  bool sheet = false;
  std::vector<Job> jobs;
};

Job parse_job(const std::string& argument) {
  const std::size_t first = argument.find(':');
  const std::size_t second = argument.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) {
    throw Failure{2, say(text::tool_usage)};
  }
  return {argument.substr(0, first), argument.substr(first + 1, second - first - 1),
          argument.substr(second + 1)};
}

Options parse_options(int argc, char** argv) {
  Options options;
  const option known[] = {
      {"scene", required_argument, nullptr, 's'},  {"images", required_argument, nullptr, 'i'},
      {"output", required_argument, nullptr, 'o'}, {"size", required_argument, nullptr, 'z'},
      {"sheet", no_argument, nullptr, 'h'},        {}};
  for (int which = 0; (which = getopt_long(argc, argv, "", known, nullptr)) != -1;) {
    switch (which) {
      case 's':
        options.scene = optarg;
        break;
      case 'i':
        options.images = optarg;
        break;
      case 'o':
        options.output = optarg;
        break;
      case 'z':
        options.size = optarg;
        break;
      case 'h':
        options.sheet = true;
        break;
      default:
        throw Failure{2, say(text::tool_usage)};
    }
  }
  std::transform(argv + optind, argv + argc, std::back_inserter(options.jobs), parse_job);
  const bool usable = !options.scene.empty() && !options.images.empty() && !options.jobs.empty();
  if (!usable) throw Failure{2, say(text::tool_usage)};
  if (!options.output.empty() && !fos::picture_format(options.output)) {
    throw Failure{2, say(text::tool_bad_output, {options.output.string()})};
  }
  return options;
}

/// `300x200` into the canvas of the request, with a warning where the shape no longer fits.
void resize(const std::string& size, const fos::SceneText& scene, fos::Request& request) {
  std::istringstream in(size);
  char x = 0;
  const bool read = static_cast<bool>(in >> request.width >> x >> request.height) && x == 'x' &&
                    in.peek() == std::istringstream::traits_type::eof();
  const auto fits = [](int side) { return side >= 1 && side <= fos::max_canvas; };
  if (!read || !fits(request.width) || !fits(request.height)) {
    throw Failure{2, say(text::tool_bad_size, {size, std::to_string(fos::max_canvas)})};
  }
  const double canvas = static_cast<double>(request.width) / request.height;
  const auto number = [](const fos::Decimal& d) { return std::strtod(d.text.c_str(), nullptr); };
  const double viewport = number(scene.viewport_size[0]) / number(scene.viewport_size[1]);
  if (std::abs(canvas / viewport - 1) > 0.01) {
    std::cerr << say(text::scene_warning) << ": "
              << say(text::scene_stretched,
                     {std::to_string(request.width), std::to_string(request.height)})
              << '\n';
  }
}

/// Counts the pixels that are no colors, and remembers the first.
struct NotFinite {
  long count = 0;
  int column = 0;
  int row = 0;

  void look_at(int at_row, const fos::Row& pixels) {
    for (std::size_t i = 0; i < pixels.unwritten.size(); ++i) {
      if (fos::is_finite(std::span<const long double, 3>(&pixels.channels[3 * i], 3))) continue;
      if (count++ == 0) column = static_cast<int>(i), row = at_row;
    }
  }
};

std::string unanswered(const Job& job, const fos::Answer& answer, int height) {
  const std::string detail = std::to_string(answer.detail);
  const std::string rows = std::to_string(answer.rows);
  switch (answer.ending) {
    case fos::Ending::crashed:
      return say(text::tool_crashed,
                 {job.name, strsignal(answer.detail), rows, std::to_string(height)});
    case fos::Ending::exited:
      return say(text::tool_exited, {job.name, detail, rows, std::to_string(height)});
    case fos::Ending::did_not_start:
      return say(text::tool_did_not_start, {job.program.string(), std::strerror(answer.detail)});
    default:
      return say(text::tool_malformed, {job.name});
  }
}

/// Says that a file is there, by its path from here where it lies below.
void announce(const std::filesystem::path& path) {
  const std::filesystem::path from_here = path.lexically_proximate(std::filesystem::current_path());
  const bool below = !from_here.empty() && *from_here.begin() != "..";
  std::cout << (below ? from_here : path).string() << '\n' << std::flush;
}

/// Renders one job to its file. Keeps the frame in `kept` where that is given.
void render(const Options& options, const Job& job, const fos::Request& request,
            const fos::PictureInfo& info, fos::Frame* kept) {
  const std::filesystem::path path =
      options.output.empty() ? options.images / (job.name + ".png") : options.output;
  fos::Progress progress(job.name, request.height);
  NotFinite not_finite;
  std::unique_ptr<fos::PictureWriter> writer;
  fos::StageProgram program(job.program);
  const fos::Answer answer = program.ask(
      request,
      [&](const fos::FrameHeader& header) {
        writer = std::make_unique<fos::PictureWriter>(path, header, info);
        if (kept != nullptr) kept->header = header;
      },
      [&](int row, const fos::Row& pixels) {
        not_finite.look_at(row, pixels);
        writer->write(pixels);
        if (kept != nullptr) kept->append(pixels);
        progress.update(row + 1);
      },
      [&] { progress.wait(); });
  // What refused a scene has said why, and every other precision or stage may still take it.
  if (answer.ending == fos::Ending::refused) throw Failure{2, ""};
  if (answer.ending != fos::Ending::complete) {
    const bool ours = answer.ending == fos::Ending::did_not_start;
    std::string message = unanswered(job, answer, request.height);
    if (std::filesystem::exists(path)) {
      message.append("\n").append(say(text::tool_older_picture, {path.filename().string()}));
    }
    throw Failure{ours ? 3 : 1, message};
  }
  writer->finish();
  if (not_finite.count > 0) {
    std::cerr << say(text::tool_not_finite,
                     {job.name, std::to_string(not_finite.count), std::to_string(not_finite.column),
                      std::to_string(not_finite.row)})
              << '\n';
  }
  announce(path);
}

std::string label(const Job& job) {
  const bool solution = job.name != job.stage;
  const auto stage = std::find_if(std::begin(fos::stages), std::end(fos::stages),
                                  [&](const fos::Stage& each) { return each.id == job.stage; });
  const std::string name = stage == std::end(fos::stages) ? job.stage : say(stage->name);
  return solution ? say(text::tool_solution, {name}) : name;
}

/// What the person typed, which ./lab hands on; else how this program was called.
std::string command_line(int argc, char** argv) {
  const char* typed = std::getenv("FOS_COMMAND");
  if (typed != nullptr) return typed;
  std::string line;
  for (int i = 0; i < argc; ++i) line.append(i == 0 ? "" : " ").append(argv[i]);
  return line;
}

/// Stands on the sheet for a picture that could not be made, so that the others keep their places.
fos::Panel no_picture(const Job& job) {
  return {label(job) + ": " + say(text::tool_no_picture), {1, 1, {200, 200, 200}}};
}

int render_all(int argc, char** argv) {
  const Options options = parse_options(argc - 1, argv + 1);
  const fos::SceneText scene = fos::read_scene_text(options.scene);
  for (const std::string& warning : fos::scene_warnings(scene)) std::cerr << warning << '\n';
  fos::Request request = fos::request_for(scene);
  if (!options.size.empty()) resize(options.size, scene, request);
  std::error_code error;
  std::filesystem::create_directories(options.images, error);
  const fos::PictureInfo info{command_line(argc, argv), scene.source};

  int status = 0;
  std::vector<fos::Panel> panels;
  for (const Job& job : options.jobs) {
    fos::Frame frame;
    try {
      render(options, job, request, info, options.sheet ? &frame : nullptr);
      if (options.sheet) panels.push_back({label(job), fos::to_bitmap(frame)});
    } catch (const Failure& failure) {
      if (!failure.message.empty()) std::cerr << failure.message << '\n';
      status = std::max(status, failure.status);
      if (options.sheet) panels.push_back(no_picture(job));
      if (failure.status == 2) return status;  // the scene: the others would refuse it as well
    }
  }
  if (!panels.empty()) {
    const std::filesystem::path path = options.images / "all.png";
    fos::write_sheet(path, panels, sheet_columns, sheet_panel);
    announce(path);
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  const auto failed = [](int status, const std::string& message) {
    std::cerr << say(text::tool_error) << ": " << message << '\n';
    return status;
  };
  std::ios::sync_with_stdio(false);  // pictures come by the megabyte
  try {
    const std::string command = argc > 1 ? argv[1] : "";
    if (command == "render") return render_all(argc, argv);
    if (command == "serve") return fos::serve_pictures(std::cin, std::cout);
    return failed(2, say(text::tool_usage));
  } catch (const Failure& failure) {
    return failed(failure.status, failure.message);
  } catch (const fos::SceneError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const fos::FileError& error) {
    return failed(error.exit_status, error.what());
  } catch (const std::exception& error) {
    return failed(3, error.what());
  }
}
