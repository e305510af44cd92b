// SPDX-License-Identifier: Apache-2.0
// A picture file in, what a display shows of it out.
#pragma once
#include "renderer/color.h"
#include "renderer/stored_image.h"

namespace proxima {

/// Display colours, white is 1. Levels are those already; scene-linear numbers, which are taken for the working space's,
/// go through `view`. The picture has three channels.
Image displayed_picture(StoredImage picture, const ColorTransform& view);

} // namespace proxima
