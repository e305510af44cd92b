// SPDX-License-Identifier: Apache-2.0
// The hash in a frame's file: of everything that its bytes follow from. That is the evaluated scene (and so every file
// that was read for it), the frame and its clock, each option that changes the picture or its file, the precision that
// the frame is rendered in, the colour transform, the kind of device and the program's version; not the scene's text,
// nor how the work was shared.
#pragma once
#include "renderer/options.h"
#include "renderer/scene_facts.h"

#include <string>
#include <string_view>
#include <vector>

namespace proxima {

class FrameHash {
public:
    /// `color` names what happens to colours, see ColorTransform::identity.
    FrameHash(const RenderOptions& options, std::string_view color);

    /// 32 hexadecimal digits. `backend` is "cpu" or "cuda".
    std::string of(int64_t frame, const SceneFacts& scene, std::string_view backend) const;

private:
    Precision precision_; ///< that is asked for
    std::string settings_;
};

/// The kind of the devices of a record: "cuda" for "cuda:0,cuda:1". Of a frame that several kinds made, all of them,
/// which is nobody's hash: how much each of them made differs between runs.
std::string backend_of(std::string_view devices);

} // namespace proxima
