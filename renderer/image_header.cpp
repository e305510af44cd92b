// SPDX-License-Identifier: Apache-2.0
#include "renderer/image_header.h"

namespace proxima {
namespace {

constexpr int jpeg_quality = 95; ///< of 100

const char* name_of(Compression compression) {
    switch (compression) {
    case Compression::zip:
        return "zip";
    case Compression::zips:
        return "zips";
    case Compression::piz:
        return "piz";
    case Compression::dwaa:
        return "dwaa";
    case Compression::none:
        break;
    }
    return "none";
}

const OIIO::TypeDesc rational(OIIO::TypeDesc::INT, OIIO::TypeDesc::VEC2, OIIO::TypeDesc::RATIONAL);
const OIIO::TypeDesc time_code_type(OIIO::TypeDesc::UINT, OIIO::TypeDesc::SCALAR, OIIO::TypeDesc::TIMECODE, 2);
const OIIO::TypeDesc matrix(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::MATRIX44);

/// SMPTE 12M: two digits a byte, frames lowest.
uint32_t packed(const TimeCode& code) {
    const auto digits = [](uint32_t value) { return value / 10 << 4 | value % 10; };
    return digits(code.hours) << 24 | digits(code.minutes) << 16 | digits(code.seconds) << 8 | digits(code.frames);
}

void add_rate(OIIO::ImageSpec& spec, const FrameRate& rate) {
    const int fraction[2] = {int(rate.numerator), int(rate.denominator)};
    spec.attribute("FramesPerSecond", rational, fraction);
}

/// Everything by its type, under the names that OpenEXR and its users know.
void add_typed_facts(OIIO::ImageSpec& spec, const ImageFacts& facts) {
    if (facts.chromaticities)
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), facts.chromaticities->data());
    if (!facts.color_interop_id.empty())
        spec.attribute("colorInteropID", facts.color_interop_id);
    spec.attribute("proxima:scene", facts.scene);
    spec.attribute("proxima:frame", int(facts.frame));
    if (!facts.hash.empty())
        spec.attribute("proxima:hash", facts.hash);
    if (facts.rate) {
        add_rate(spec, *facts.rate);
        const uint32_t code[2] = {packed(time_code(facts.frame, *facts.rate)), 0};
        if (facts.rate->nominal() < 40) // a time code has two digits for frames, of which the first is at most 3
            spec.attribute("smpte:TimeCode", time_code_type, code);
    }
    if (facts.world_to_camera)
        spec.attribute("worldToCamera", matrix, facts.world_to_camera->data());
    if (facts.world_to_ndc)
        spec.attribute("worldToNDC", matrix, facts.world_to_ndc->data());
}

/// A channel for each number of each layer. Z is OpenEXR's own name for a depth, and N.X to N.Z are pbrt's for a
/// normal; OpenEXR's documentation has 32-bit floats for depths and integers for the numbers of objects.
void add_layers(OIIO::ImageSpec& spec, const AovLayers& layers) {
    const auto add = [&](const char* name, OIIO::TypeDesc type) {
        spec.channelnames.emplace_back(name);
        spec.channelformats.push_back(type);
    };
    spec.channelformats.assign(3, spec.format);
    if (layers.depth)
        add("Z", OIIO::TypeDesc::FLOAT);
    if (layers.normal)
        for (const char* name : {"N.X", "N.Y", "N.Z"})
            add(name, spec.format);
    if (layers.id)
        add("id", OIIO::TypeDesc::UINT);
    if (layers.steps)
        add("steps", OIIO::TypeDesc::FLOAT); // of integers, OpenImageIO's tools show fractions of 2^32
    spec.nchannels = int(spec.channelnames.size());
    if (layers.depth)
        spec.z_channel = 3;
}

} // namespace

const char* file_name_of(ImageFormat format) {
    switch (format) {
    case ImageFormat::png:
        return "frame.png";
    case ImageFormat::exr:
        return "frame.exr";
    case ImageFormat::tiff:
        return "frame.tif";
    case ImageFormat::gif:
        return "frame.gif";
    case ImageFormat::jpeg:
        break;
    }
    return "frame.jpg";
}

OIIO::TypeDesc file_type(SampleType type) {
    switch (type) {
    case SampleType::uint8:
        return OIIO::TypeDesc::UINT8;
    case SampleType::uint16:
        return OIIO::TypeDesc::UINT16;
    case SampleType::half:
        return OIIO::TypeDesc::HALF;
    case SampleType::float32:
        break;
    }
    return OIIO::TypeDesc::FLOAT;
}

OIIO::ImageSpec describe(const EncodeRequest& request) {
    const ImageFacts& facts = request.facts;
    OIIO::ImageSpec spec(int(request.width), int(request.height), 3, file_type(request.type));
    spec.attribute("Software", facts.software);
    spec.attribute("DateTime", ""); // unset, EXR and TIFF get the present time
    // OpenImageIO 2.4 writes TIFF's sRGB into a second directory, and in memory over the first one: no one can read the
    // file then.
    const bool is_known = !facts.color_encoding.empty();
    if (is_known && !(request.format == ImageFormat::tiff && facts.color_encoding == "sRGB"))
        spec.attribute("oiio:ColorSpace", facts.color_encoding);
    if (request.format != ImageFormat::exr && !facts.hash.empty())
        spec.attribute("ImageDescription", facts.sentence());
    switch (request.format) {
    case ImageFormat::exr:
        spec.attribute("compression", name_of(request.compression));
        add_typed_facts(spec, facts);
        if (request.layers.any())
            add_layers(spec, request.layers);
        break;
    case ImageFormat::png: // is made by png_file.h
        break;
    case ImageFormat::tiff:
        spec.attribute("compression", "zip");
        break;
    case ImageFormat::jpeg:
        spec.attribute("CompressionQuality", jpeg_quality);
        spec.attribute("jpeg:subsampling", "4:4:4");
        break;
    case ImageFormat::gif:
        add_rate(spec, facts.rate.value_or(FrameRate{}));
        break;
    }
    return spec;
}

} // namespace proxima
