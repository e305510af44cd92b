// SPDX-License-Identifier: Apache-2.0
// The pixels of a picture with layers as a file has them: all channels of a pixel together, each in its own type, in
// the order of image_header.cpp's add_layers. Part of the image module.
#pragma once
#include "kernels/half.h"
#include "renderer/image_encoder.h"

#include <cstring>
#include <vector>

namespace proxima {

/// Puts numbers behind each other.
class PixelBytes {
public:
    explicit PixelBytes(size_t size) : bytes_(size) {}

    template <class Number> void put(const Number& number) {
        std::memcpy(bytes_.data() + used_, &number, sizeof number);
        used_ += sizeof number;
    }
    std::vector<unsigned char> take() { return std::move(bytes_); }

private:
    std::vector<unsigned char> bytes_;
    size_t used_ = 0;
};

/// Of half and float files. Normals are of the picture's type.
inline std::vector<unsigned char> layered_pixels(const EncodeRequest& request) {
    const bool is_half = request.type == SampleType::half;
    const size_t number = is_half ? sizeof(uint16_t) : sizeof(float);
    const auto& [depth, normal, id, steps] = request.layers;
    const size_t pixel = number * (3 + 3 * normal) + sizeof(float) * (depth + steps) + sizeof(uint32_t) * id;
    const size_t pixels = size_t(request.width) * request.height;
    PixelBytes bytes(pixels * pixel);
    const auto put = [&](float value) { is_half ? bytes.put(half_bits(value)) : bytes.put(value); };
    const auto* halves = static_cast<const uint16_t*>(request.samples);
    const auto* floats = static_cast<const float*>(request.samples);
    for (size_t i = 0; i < pixels; ++i) {
        for (size_t c = 3 * i; c < 3 * i + 3; ++c)
            request.samples_are_halves ? bytes.put(halves[c]) : put(floats[c]);
        const AovSample& aov = request.aovs[i];
        if (depth)
            bytes.put(aov.depth);
        for (int axis = 0; normal && axis < 3; ++axis)
            put(aov.normal[axis]);
        if (id)
            bytes.put(aov.id);
        if (steps)
            bytes.put(float(aov.steps));
    }
    return bytes.take();
}

} // namespace proxima
