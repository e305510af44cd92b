// SPDX-License-Identifier: Apache-2.0
// The writing half of the image module, see image_module.h.
#pragma once
#include "renderer/output_name.h"

#include <cstdint>
#include <string>
#include <vector>

namespace proxima {

/// A picture in the form that the file keeps, three channels, rows from top to bottom.
struct EncodeRequest {
    ImageFormat format = ImageFormat::png;
    SampleType type = SampleType::uint8;
    uint32_t width = 0;
    uint32_t height = 0;
    const void* samples = nullptr; ///< uint8_t, uint16_t, or float (for half and float32)
    std::string color_encoding;    ///< "sRGB", "Linear", "Gamma2.4" or empty: goes to the header where it fits
    std::string software;          ///< the program and its version
    std::string scene;             ///< the scene's file name
    int64_t frame = 0;
};

/// The file's bytes. The same request gives the same bytes. Throws std::runtime_error.
using EncodeImage = std::vector<unsigned char>(const EncodeRequest& request);

inline constexpr const char encoder_function[] = "proxima_encode_image";

} // namespace proxima
