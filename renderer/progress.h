// SPDX-License-Identifier: Apache-2.0
// What a person (or a farm) sees while frames are made: a bar that redraws itself on a terminal, a line a frame
// elsewhere, JSON lines for programs, the lines of Open Job Description for farms. All of it goes to standard error.
#pragma once
#include "renderer/timing.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace proxima {

enum class ProgressStyle { automatic, bar, plain, json, openjd, none };

class Progress {
public:
    /// `automatic` is a bar when standard error is a terminal that can redraw a line (TERM is not "dumb").
    Progress(ProgressStyle style, size_t frame_count);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A frame's file is complete. Any thread.
    void frame_written(int64_t frame, const std::string& file);
    /// A line that is shown in every style but none. Any thread.
    void note(const std::string& text);
    /// What was noted up to now, in every style; of very many the first thousand. Any thread.
    std::vector<std::string> notes() const;

private:
    void draw_bar();
    void erase_bar();

    ProgressStyle style_;
    bool bar_ = false;
    bool drawn_ = false; ///< the bar stands on the terminal's last line
    size_t total_;
    size_t done_ = 0;
    Stopwatch watch_;
    std::vector<std::string> notes_;
    mutable std::mutex mutex_;
};

} // namespace proxima
