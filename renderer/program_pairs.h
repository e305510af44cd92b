// SPDX-License-Identifier: Apache-2.0
// A scene in, a pair of pictures for each of its frames out: A by POV-Ray, B by Proxima, both linear light at 16 bits.
#pragma once
#include "renderer/options.h"
#include "renderer/picture_pairs.h"

namespace proxima {

/// Reads the scene now and renders when a pair is loaded. Throws what render_command throws, and as
/// render_with_povray. `options` must outlive the pairs.
std::vector<PicturePair> pair_programs(const CompareOptions& options);

} // namespace proxima
