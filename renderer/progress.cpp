// SPDX-License-Identifier: Apache-2.0
#include "renderer/progress.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace proxima {
namespace {

bool can_redraw() {
    const char* terminal = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) && terminal && std::string_view(terminal) != "dumb";
}

size_t terminal_width() {
    winsize size{};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
        return 80;
    return size.ws_col;
}

std::string duration(double seconds) {
    if (seconds < 60)
        return fmt::format("{:.1f} s", seconds);
    const auto whole = uint64_t(seconds);
    if (whole < 3600)
        return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

void print(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

} // namespace

Progress::Progress(ProgressStyle style, size_t frame_count)
    : style_(style), bar_(style == ProgressStyle::bar || (style == ProgressStyle::automatic && can_redraw())),
      total_(frame_count) {
    if (style_ == ProgressStyle::openjd)
        print(fmt::format("openjd_progress: {}\n", total_ == 0 ? 100 : 0));
    draw_bar();
}

Progress::~Progress() {
    erase_bar();
}

void Progress::frame_written(int64_t frame, const std::string& file) {
    const std::lock_guard lock(mutex_);
    ++done_;
    const double seconds = watch_.milliseconds() / 1000;
    if (style_ == ProgressStyle::json) {
        const nlohmann::ordered_json line{{"event", "frame"}, {"frame", frame},  {"file", file},
                                          {"done", done_},    {"total", total_}, {"seconds", seconds}};
        print(line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
    } else if (style_ == ProgressStyle::openjd) {
        print(fmt::format("openjd_progress: {:.1f}\nopenjd_status: wrote {} ({} of {})\n",
                          100 * double(done_) / double(total_), file, done_, total_));
    } else if (style_ != ProgressStyle::none && (!bar_ || done_ == total_)) {
        erase_bar();
        print(total_ == 1 ? fmt::format("wrote {} in {}\n", file, duration(seconds))
                          : fmt::format("wrote {} ({} of {}, {})\n", file, done_, total_, duration(seconds)));
    } else {
        draw_bar();
    }
}

void Progress::note(const std::string& text) {
    constexpr size_t most_notes = 1000;
    const std::lock_guard lock(mutex_);
    if (notes_.size() < most_notes)
        notes_.push_back(text);
    if (style_ == ProgressStyle::none)
        return;
    erase_bar();
    if (style_ == ProgressStyle::json)
        print(nlohmann::ordered_json{{"event", "note"}, {"text", text}}.dump() + '\n');
    else
        print(fmt::format("proxima: note: {}\n", text));
    draw_bar();
}

std::vector<std::string> Progress::notes() const {
    const std::lock_guard lock(mutex_);
    return notes_;
}

void Progress::draw_bar() {
    if (!bar_ || done_ == total_)
        return;
    const double seconds = watch_.milliseconds() / 1000;
    const std::string left = done_ == 0 ? "" : duration(seconds / double(done_) * double(total_ - done_)) + " left";
    const std::string counts = fmt::format(" {}/{} frames  {}", done_, total_, left);
    const size_t room =
        std::clamp<size_t>(terminal_width(), counts.size() + 14, counts.size() + 54) - counts.size() - 4;
    const size_t filled = room * done_ / total_;
    drawn_ = true;
    print(fmt::format("\r[{}{}]{:<12}", std::string(filled, '='), std::string(room - filled, ' '), counts));
}

void Progress::erase_bar() {
    if (std::exchange(drawn_, false))
        print(fmt::format("\r{}\r", std::string(terminal_width() - 1, ' ')));
}

} // namespace proxima
