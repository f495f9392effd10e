#include "watch.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <sstream>
#include <utility>

#include "child.hpp"
#include "fos/text.hpp"

namespace fos {
namespace {

constexpr std::chrono::milliseconds interval(100);

}  // namespace

Watch::Watch(const WatchOptions& options)
    : options_(options),
      paint_(colors_of_output()),
      checker_(options.places, paint_.colors()),
      file_(options.places.root / stage_file(*options.stage)),
      measure_(options.measure),
      stage_(options.stage) {}

std::filesystem::path Watch::file() const { return options_.places.root / stage_file(*stage_); }

const Stage* Watch::next_stage() const {
  const Stage* next = stage_ + 1;
  return next == std::end(stages) ? nullptr : next;
}

int Watch::run() {
  terminal_.clear();
  show(wrapped(say(text::watch_begins, {stage_file(*stage_)}), 0, terminal_.size().columns) +
       say(text::watch_viewer, {checker_.view().url()}) + "\n\n");
  looked_ = Clock::now();
  saved_ = looked_;
  check(true);  // an older build may be of another content, whatever its time
  while (!done_) {
    wait();
    while (const int signal = signals_.next()) on_signal(signal);
    for (const CheckEvent& event : checker_.take()) {
      std::visit([&](const auto& each) { on_event(each); }, event);
    }
    if (Clock::now() - looked_ >= interval) look();
    if (measure_.is_on() && has_verdict_) measure_.save_when_due(file(), Clock::now());
  }
  if (terminal_.is_there()) show("\n");
  if (measure_.is_on() && measure_.is_done()) show(measure_.report());
  if (signal_ != 0) return 128 + signal_;
  return has_verdict_ && !is_checking_ && verdict_.passes ? 0 : 1;
}

void Watch::wait() {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(looked_ + interval - Clock::now());
  const int keyboard = terminal_.is_there() ? STDIN_FILENO : -1;
  std::array<pollfd, 3> descriptors{pollfd{keyboard, POLLIN, 0},
                                    pollfd{signals_.descriptor(), POLLIN, 0},
                                    pollfd{checker_.descriptor(), POLLIN, 0}};
  poll(descriptors.data(), descriptors.size(), std::max(0, static_cast<int>(left.count())));
  if (descriptors[0].revents == 0) return;
  std::array<char, 64> bytes{};
  const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count == 0 || (count < 0 && errno == EIO)) done_ = true;  // the terminal is gone
  if (count <= 0) return;
  for (const Key key : keys_.take({bytes.data(), static_cast<std::size_t>(count)})) on_key(key);
}

void Watch::look() {
  looked_ = Clock::now();
  const std::string before = file_.content();
  switch (file_.look(looked_)) {
    case FileWatcher::Change::none:
      return;
    case FileWatcher::Change::missing:
      show("\n" + wrapped(say(text::watch_missing, {stage_file(*stage_)})));
      return;
    case FileWatcher::Change::changed:
      saved_ = looked_ - interval;  // since the last look, at which it was not there yet
      check(file_.content() != before);
  }
}

void Watch::check(bool anew) {
  const Terminal::Size size = terminal_.size();
  constexpr int rows_below = 5;  // for the status, and the picture's line
  serial_ = checker_.start(
      {stage_,
       anew,
       {terminal_.is_there(), size.columns, terminal_.is_there() ? size.rows - rows_below : 0}});
  is_checking_ = true;
  if (terminal_.is_there()) show(say(text::watch_checking) + "\n");
}

void Watch::on_event(const Checked& checked) {
  if (checked.serial != serial_) return;
  look();  // what has changed in the meantime is checked, and this verdict never shown
  if (checked.serial != serial_) return;
  is_checking_ = false;
  has_verdict_ = true;
  verdict_ = checked;
  seconds_ = std::chrono::duration<double>(Clock::now() - saved_).count();
  measure_.verdict(Clock::now());
  if (!measure_.is_on()) draw();
}

void Watch::on_event(const Pictured& pictured) {
  if (pictured.serial != serial_) return;
  if (!pictured.trouble.empty()) show(wrapped(pictured.trouble));
  measure_.pictures(pictured.seconds, Clock::now());
  done_ = measure_.is_on() ? measure_.is_done() : !terminal_.is_there() && verdict_.passes;
}

void Watch::draw() {
  shows_other_ = false;
  terminal_.clear();
  show(verdict_.screen + status());
}

std::string Watch::status() const {
  std::string line = say(text::watch_verdict, {fmt::format("{:.1f}", seconds_)});
  const bool keys = terminal_.is_there();
  if (keys) {
    if (verdict_.passes && next_stage() != nullptr) {
      line += " · " + say(text::watch_key_next, {next_stage()->id});
    }
    line += " · " + say(text::watch_keys);
  }
  const int width = terminal_.size().columns;
  std::string out;
  if (verdict_.passes) {
    out = wrapped(say(text::watch_congratulations, {say(stage_->name)}), 0, width);
    out.pop_back();
    out = paint_.green(out) + "\n";
  }
  return out + "\n" + wrapped(line, 0, width);
}

void Watch::on_key(Key key) {
  if (done_) return;
  const bool was_other = std::exchange(shows_other_, false);
  switch (key) {
    case Key::quit:
      done_ = true;
      return;
    case Key::hint:
      return run_lab({"hint", std::string(stage_->id)});
    case Key::explain:
      return explain();
    case Key::list:
      return run_lab({"check"});
    case Key::check:
      saved_ = Clock::now();
      return check(true);
    case Key::next:
      if (has_verdict_ && verdict_.passes && next_stage() != nullptr) {
        return watch_stage(*next_stage());
      }
      if (!was_other) return show(wrapped(say(text::watch_not_yet)));
      break;
    case Key::other:
      break;
  }
  if (was_other && has_verdict_) draw();
}

void Watch::watch_stage(const Stage& stage) {
  stage_ = &stage;
  file_ = FileWatcher(file());
  has_verdict_ = false;
  verdict_ = {};
  terminal_.clear();
  show(wrapped(say(text::watch_begins, {stage_file(stage)}), 0, terminal_.size().columns));
  saved_ = Clock::now();
  check(true);
}

void Watch::run_lab(const std::vector<std::string>& words) {
  std::vector<std::string> command{(options_.places.root / "lab").string()};
  command.insert(command.end(), words.begin(), words.end());
  terminal_.clear();
  terminal_.give_back();
  run_in_terminal(command);
  terminal_.take();
  // Ctrl-C and Ctrl-Z were for the child.
  while (const int signal = signals_.next()) {
    if (signal != SIGINT && signal != SIGQUIT && signal != SIGTSTP && signal != SIGCONT) {
      on_signal(signal);
    }
  }
  shows_other_ = true;
  show("\n" + wrapped(say(text::watch_any_key), 0, terminal_.size().columns));
}

void Watch::explain() {
  const Spot& spot = verdict_.spot;
  const std::string column = std::to_string(spot.pixel.column);
  const std::string row = std::to_string(spot.pixel.row);
  show("\n" + say(text::watch_ask_pixel, {column, row}));
  terminal_.give_back();
  const std::string line = read_line();
  terminal_.take();
  if (done_) return;
  std::istringstream in(line);
  std::vector<std::string> words{"explain", std::string(stage_->id)};
  unsigned typed_column = 0;
  unsigned typed_row = 0;
  if (line.find_first_not_of(" \t") == std::string::npos) {
    words.insert(words.end(), {column, row});
    if (!spot.scene_text.empty()) {
      words.insert(
          words.end(),
          {"--scene",
           (options_.places.images() / (std::string(stage_->id) + "-check.scene")).string()});
    }
  } else if (in >> typed_column >> typed_row && (in >> std::ws).eof()) {
    // A pixel of the picture, not of the small scene that the first failure may be in.
    words.insert(words.end(), {std::to_string(typed_column), std::to_string(typed_row)});
    if (!verdict_.shown_scene.empty()) {
      words.insert(words.end(), {"--scene", verdict_.shown_scene});
    }
  } else {
    return show(wrapped(say(text::watch_bad_pixel, {column, row})));
  }
  run_lab(words);
}

std::string Watch::read_line() {
  std::string line;
  while (!done_) {
    std::array<pollfd, 2> descriptors{pollfd{STDIN_FILENO, POLLIN, 0},
                                      pollfd{signals_.descriptor(), POLLIN, 0}};
    poll(descriptors.data(), descriptors.size(), -1);
    while (const int signal = signals_.next()) {
      if (signal == SIGINT) return "-";
      on_signal(signal);
    }
    if (descriptors[0].revents == 0) continue;
    std::array<char, 256> bytes{};
    const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) return "-";
    line.append(bytes.data(), static_cast<std::size_t>(count));
    if (line.back() == '\n') break;
  }
  return line;
}

void Watch::on_signal(int signal) {
  switch (signal) {
    case SIGTSTP:
      return stop_here();
    case SIGCONT:
      terminal_.take();
      if (has_verdict_ && !shows_other_) draw();
      return;
    default:
      signal_ = signal;
      done_ = true;
  }
}

void Watch::stop_here() {
  terminal_.give_back();
  raise(SIGSTOP);
  terminal_.take();
}

}  // namespace fos
