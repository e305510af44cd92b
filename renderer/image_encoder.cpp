// SPDX-License-Identifier: Apache-2.0
// It encodes into memory: OpenImageIO 2.4's JPEG writer ends the process on a full disk.
#include "renderer/image_encoder.h"
#include "renderer/image_header.h"
#include "renderer/layered_pixels.h"

#include <OpenImageIO/filesystem.h>
#include <stdexcept>

namespace proxima {
namespace {

std::unique_ptr<OIIO::ImageOutput> make_output(ImageFormat format, OIIO::Filesystem::IOProxy& memory) {
    auto output = OIIO::ImageOutput::create(file_name_of(format), &memory);
    if (!output)
        throw std::runtime_error(OIIO::geterror());
    return output;
}

void check(bool succeeded, const OIIO::ImageOutput& output) {
    if (!succeeded)
        throw std::runtime_error(output.geterror());
}

class AppendingEncoder : public SequenceEncoder {
public:
    explicit AppendingEncoder(const EncodeRequest& request)
        : name_(file_name_of(request.format)), spec_(describe(request)), memory_(bytes_),
          output_(make_output(request.format, memory_)) {}

    void append(const unsigned char* levels) override {
        const auto mode = is_begun_ ? OIIO::ImageOutput::AppendSubimage : OIIO::ImageOutput::Create;
        check(output_->open(name_, spec_, mode), *output_);
        is_begun_ = true;
        check(output_->write_image(OIIO::TypeDesc::UINT8, levels), *output_);
    }

    std::vector<unsigned char> finish() override {
        check(output_->close(), *output_);
        return std::move(bytes_);
    }

private:
    std::string name_;
    OIIO::ImageSpec spec_;
    std::vector<unsigned char> bytes_;
    OIIO::Filesystem::IOVecOutput memory_;
    std::unique_ptr<OIIO::ImageOutput> output_;
    bool is_begun_ = false;
};

std::vector<unsigned char> encode(const EncodeRequest& request) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = make_output(request.format, memory);
    check(output->open(file_name_of(request.format), describe(request)), *output);
    const bool is_float = is_scene_linear(request.type) && !request.samples_are_halves;
    if (request.layers.any())
        check(output->write_image(OIIO::TypeDesc::UNKNOWN, layered_pixels(request).data()), *output);
    else
        check(output->write_image(is_float ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : file_type(request.type),
                                  request.samples),
              *output);
    check(output->close(), *output);
    return bytes;
}

} // namespace
} // namespace proxima

extern "C" {

proxima::EncodeImage proxima_encode_image;
proxima::MakeSequenceEncoder proxima_make_sequence_encoder;

std::vector<unsigned char> proxima_encode_image(const proxima::EncodeRequest& request) {
    return proxima::encode(request);
}

std::unique_ptr<proxima::SequenceEncoder> proxima_make_sequence_encoder(const proxima::EncodeRequest& request) {
    return std::make_unique<proxima::AppendingEncoder>(request);
}
}
