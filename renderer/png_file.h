// SPDX-License-Identifier: Apache-2.0
// PNG files, made inside the program: compressed by ISA-L, and without the time that OpenImageIO takes to load.
#pragma once
#include "renderer/image_encoder.h"

#include <vector>

namespace proxima {

/// The file of a picture with 8 or 16 bits a channel: "Portable Network Graphics (PNG) Specification", 3rd edition.
/// The same request gives the same bytes on processors with the same vector instructions, and the same levels on all.
std::vector<unsigned char> encode_png(const EncodeRequest& request);

} // namespace proxima
