// SPDX-License-Identifier: Apache-2.0
// Where something stands in the scene's texts. Lines and columns are counted only when a message needs them.
#pragma once
#include <cstdint>

namespace proxima {

/// A place in one of the texts that a scene is made of.
struct SourceLocation {
    uint32_t file = 0;   ///< index into SourceFiles
    uint32_t offset = 0; ///< bytes from the start of the text; texts are below 4 GiB
};

} // namespace proxima
