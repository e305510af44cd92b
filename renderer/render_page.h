// SPDX-License-Identifier: Apache-2.0
// The --report folder of a run: index.html with the frames as a contact sheet, what each took and what was chosen for
// it, and whatever went wrong. The page needs nothing but this folder, no network either.
#pragma once
#include "renderer/image_file.h"
#include "renderer/statistics_json.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace proxima {

class RenderPage {
public:
    /// Makes the folder if it is not there. Throws FileError when it cannot be written.
    explicit RenderPage(std::filesystem::path folder);

    /// A small copy of a picture.
    static Image thumbnail(const Image& image);

    /// Writes a frame's picture, in display colours. Any thread. Throws FileError.
    void add_picture(int64_t frame, const Image& picture, ImageEncoder& encoder) const;
    /// The frame is there. Any thread.
    void add_frame(const FrameRecord& record);
    /// The frame was there before the run, and was left as it is. Any thread.
    void add_kept(int64_t frame, const std::filesystem::path& file);

    /// Writes the page. `run` has everything but its frames; `error` is what ended the run early, or empty.
    void finish(RunRecord run, const std::vector<std::string>& notes, const std::string& error) const;

private:
    std::filesystem::path folder_;
    mutable std::mutex mutex_;
    std::vector<FrameRecord> frames_;
    std::map<int64_t, std::string> kept_; ///< files by their frames
};

} // namespace proxima
