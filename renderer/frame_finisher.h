// SPDX-License-Identifier: Apache-2.0
// A rendered picture in, its file out: colour, encoding, writing. The writer's side of a run, a function of one frame
// that any thread may call; and what follows when all frames are there.
#pragma once
#include "renderer/color.h"
#include "renderer/frame_audit.h"
#include "renderer/frame_hash.h"
#include "renderer/frame_watch.h"
#include "renderer/frame_writer.h"
#include "renderer/image_file.h"
#include "renderer/movie.h"
#include "renderer/options.h"
#include "renderer/progress.h"
#include "renderer/render_page.h"
#include "renderer/sequence_file.h"

#include <mutex>
#include <optional>

namespace proxima {

class FrameFinisher {
public:
    /// Throws UsageError and FileError when the colours or the film that `options` ask for are not to be had. `options`
    /// must outlive this.
    explicit FrameFinisher(const RenderOptions& options);

    const FrameHash& hash() const { return hash_; }

    /// Begins to load what encodes, beside what the caller does next, and says where messages go and who watches the
    /// steps. Before the first frame.
    void start(Progress& progress, RunWatch watch = {});

    /// Puts frames that are there already, and stay as they are, on the page, if there is to be one. After start().
    /// Throws FileError.
    void show_kept(const std::vector<AuditedFrame>& frames);

    /// Writes the file of a frame, or puts the frame into the animation's file, and completes its record. Throws
    /// FileError.
    void operator()(FinishedFrame& frame);
    /// Tells the user that the frame is there.
    void announce(const FrameRecord& record);
    /// Every frame is there: writes what is made of all of them. Throws FileError.
    void finish();
    /// Writes the page that --report asks for, if it does. `run` has everything but its frames; `error` is what ended
    /// it early, or empty. Throws FileError.
    void write_page(const RunRecord& run, const std::string& error) const;

private:
    void show(const FinishedFrame& frame);
    void prepare(FinishedFrame& frame);
    void report(const FrameRecord& record);
    ImageFileSettings file_settings(const FrameRecord& record) const;
    SequenceFile& sequence(const FinishedFrame& frame);

    const RenderOptions& options_;
    ColorTransform color_;
    std::optional<ColorTransform> view_; ///< of the film and of the page
    std::optional<Movie> movie_;
    std::optional<RenderPage> page_;
    FrameHash hash_;
    std::optional<ImageEncoder> encoder_;
    std::mutex mutex_;
    std::unique_ptr<SequenceFile> sequence_; ///< made for the first frame
    Progress* progress_ = nullptr;
    RunWatch watch_;
};

} // namespace proxima
