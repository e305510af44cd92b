// SPDX-License-Identifier: Apache-2.0
// What a frame costs between the renderer and its file, at 1920x1080: the processor time of our encoding beside that of
// OpenImageIO's own of the same pixels, and how colour conversion scales from one core to two. Usage: output_bench
// [RUNS]; pictures are a smooth one with noise in a part of it.
#include "renderer/color.h"
#include "renderer/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <tbb/global_control.h>
#include <vector>

using namespace proxima;

namespace {

constexpr uint32_t width = 1920, height = 1080;

Image picture() {
    Image image{width, height, {}};
    image.rgb.resize(size_t(width) * height * 3);
    uint32_t state = 1;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width * 3; ++x) {
            state = state * 747796405u + 2891336453u;
            const float noise = x / 3 > width / 2 ? float(state >> 8) * 0x1p-24f * 0.1f : 0.0f;
            image.rgb[size_t(y) * width * 3 + x] =
                0.4f + 0.3f * std::sin(float(x) * 0.004f) * std::cos(float(y) * 0.01f) + noise;
        }
    return image;
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
    return values[values.size() / 2];
}

std::vector<unsigned char> encode_alone(const char* name, OIIO::TypeDesc type, const void* samples,
                                        OIIO::TypeDesc sample_type) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(name, &memory);
    OIIO::ImageSpec spec(int(width), int(height), 3, type);
    spec.attribute("compression", "zip");
    output->open(name, spec);
    output->write_image(sample_type, samples);
    output->close();
    return bytes;
}

/// The medians of both, taken in turns: what else runs on the machine slows both.
void compare(const char* what, int runs, const std::function<size_t()>& ours, const std::function<size_t()>& theirs) {
    std::vector<double> our_seconds, their_seconds;
    size_t our_bytes = 0, their_bytes = 0;
    for (int i = 0; i < runs; ++i)
        for (const bool is_ours : {true, false}) {
            const double start = processor_seconds();
            (is_ours ? our_bytes : their_bytes) = is_ours ? ours() : theirs();
            (is_ours ? our_seconds : their_seconds).push_back(processor_seconds() - start);
        }
    fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} | {:.2f} | {:.2f} |\n", what, 1000 * median(our_seconds),
               double(our_bytes) / 1e6, 1000 * median(their_seconds), double(their_bytes) / 1e6,
               median(our_seconds) / median(their_seconds));
}

double conversion_seconds(const ColorTransform& color, const Image& image, int threads, int runs) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(threads));
    std::vector<double> seconds;
    for (int i = 0; i < runs; ++i) {
        Image copy = image;
        const double start = wall_seconds();
        color.apply(copy);
        seconds.push_back(wall_seconds() - start);
    }
    return *std::ranges::min_element(seconds); // the run that was disturbed least
}

} // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::atoi(argv[1]) : 15;
    Image image = picture();
    ImageEncoder encoder;
    encoder.encode(image, {}); // loads it

    fmt::print("| 1920x1080 | ours, ms | MB | OpenImageIO alone, ms | MB | ratio |\n|---|---|---|---|---|---|\n");
    compare(
        "EXR half, zip", runs,
        [&] {
            replace_non_finite(image); // in place, as the finisher has it; neither finds anything
            clamp_to_half(image);
            return encoder.encode(image, {.format = ImageFormat::exr, .type = SampleType::half}).size();
        },
        [&] { return encode_alone("a.exr", OIIO::TypeDesc::HALF, image.rgb.data(), OIIO::TypeDesc::FLOAT).size(); });
    for (const SampleType type : {SampleType::uint8, SampleType::uint16}) {
        const bool is_wide = type == SampleType::uint16;
        const OIIO::TypeDesc stored = is_wide ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
        compare(
            is_wide ? "PNG 16" : "PNG 8", runs, [&] { return encoder.encode(image, {.type = type}).size(); },
            [&] { return encode_alone("a.png", stored, image.rgb.data(), OIIO::TypeDesc::FLOAT).size(); });
    }

    fmt::print("\n| view | one core, ms | two cores, ms | times |\n|---|---|---|---|\n");
    for (const char* view : {"Un-tone-mapped", "ACES 1.0 - SDR Video"}) {
        const ColorTransform color(ColorSettings{.view = view});
        const double one = conversion_seconds(color, image, 1, runs), two = conversion_seconds(color, image, 2, runs);
        fmt::print("| {} | {:.1f} | {:.1f} | {:.2f} |\n", view, 1000 * one, 1000 * two, one / two);
    }
}
