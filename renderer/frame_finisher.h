// SPDX-License-Identifier: Apache-2.0
// A rendered picture in, its file out: colour, encoding, writing. The writer's side of a run, a function of one frame
// that any thread may call.
#pragma once
#include "renderer/color.h"
#include "renderer/frame_writer.h"
#include "renderer/image_file.h"
#include "renderer/options.h"
#include "renderer/progress.h"

#include <optional>

namespace proxima {

class FrameFinisher {
public:
    /// Throws UsageError and FileError when the colours that `options` ask for are not to be had. `options` must
    /// outlive this.
    explicit FrameFinisher(const RenderOptions& options);

    /// Begins to load what encodes, beside what the caller does next, and says where messages go. Before the first
    /// frame.
    void start(Progress& progress);

    /// Writes the file of a frame and completes its record. Throws FileError.
    void operator()(FinishedFrame& frame);
    /// Tells the user that the frame's file is there.
    void announce(const FrameRecord& record);

private:
    const RenderOptions& options_;
    std::optional<ColorTransform> color_; ///< empty for scene-linear files
    std::optional<ImageEncoder> encoder_;
    Progress* progress_ = nullptr;
};

} // namespace proxima
