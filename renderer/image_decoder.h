// SPDX-License-Identifier: Apache-2.0
// The reading half of the image module, see image_module.h.
#pragma once
#include "renderer/stored_image.h"

#include <string>

namespace proxima {

/// Reads a whole picture file. Throws std::runtime_error, without the file's name, when it is damaged or cut short, or
/// holds something else than one flat picture of 8 or 16 bits, half or float.
using DecodeImage = StoredImage(const std::string& path);

inline constexpr const char decoder_function[] = "proxima_decode_image";

} // namespace proxima
