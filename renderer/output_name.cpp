// SPDX-License-Identifier: Apache-2.0
#include "renderer/output_name.h"
#include "renderer/errors.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace proxima {
namespace {

constexpr int digits_of_one_hash = 4;
constexpr int max_digits = 32;

struct Placeholder {
    size_t begin = 0, length = 0;
    int digits = 0;
};

/// The first `###` or `%0Nd` at or after `from`.
std::optional<Placeholder> find_placeholder(const std::string& name, size_t from) {
    for (size_t i = from; i < name.size(); ++i) {
        if (name[i] == '#') {
            const size_t end = std::min(name.find_first_not_of('#', i), name.size());
            return Placeholder{i, end - i, end - i == 1 ? digits_of_one_hash : int(end - i)};
        }
        if (name[i] != '%')
            continue;
        size_t end = i + 1;
        int digits = 0;
        while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) && digits <= max_digits)
            digits = digits * 10 + (name[end++] - '0');
        if (end < name.size() && name[end] == 'd' && (digits == 0 || name[i + 1] == '0'))
            return Placeholder{i, end + 1 - i, digits};
    }
    return std::nullopt;
}

ImageFormat format_of(const std::filesystem::path& name) {
    std::string extension = name.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".png")
        return ImageFormat::png;
    if (extension == ".exr")
        return ImageFormat::exr;
    if (extension == ".tif" || extension == ".tiff")
        return ImageFormat::tiff;
    if (extension == ".jpg" || extension == ".jpeg")
        return ImageFormat::jpeg;
    throw UsageError(fmt::format("-o {}: {}; end the name in .png, .exr, .tif or .jpg", name.string(),
                                 extension.empty() ? "the name has no ending that says what to write"
                                                   : fmt::format("no picture is written as '{}'", extension)));
}

struct BitsChoice {
    const char* bits;
    SampleType type;
};

const std::vector<BitsChoice>& choices_of(ImageFormat format) {
    static const std::vector<BitsChoice> png{{"8", SampleType::uint8}, {"16", SampleType::uint16}};
    static const std::vector<BitsChoice> exr{{"half", SampleType::half}, {"float", SampleType::float32}};
    static const std::vector<BitsChoice> tiff{
        {"8", SampleType::uint8}, {"16", SampleType::uint16}, {"float", SampleType::float32}};
    static const std::vector<BitsChoice> jpeg{{"8", SampleType::uint8}};
    switch (format) {
    case ImageFormat::png:
        return png;
    case ImageFormat::exr:
        return exr;
    case ImageFormat::tiff:
        return tiff;
    case ImageFormat::jpeg:
        break;
    }
    return jpeg;
}

} // namespace

OutputName::OutputName(std::filesystem::path pattern) : folder_(pattern.parent_path()) {
    const std::string name = pattern.filename().string();
    format_ = format_of(pattern);
    const auto placeholder = find_placeholder(name, 0);
    if (!placeholder) {
        before_ = name;
        return;
    }
    before_ = name.substr(0, placeholder->begin);
    after_ = name.substr(placeholder->begin + placeholder->length);
    digits_ = placeholder->digits;
    has_frame_number_ = true;
    if (digits_ > max_digits)
        throw UsageError(
            fmt::format("-o {}: a frame number has at most {} digits; write #### or %04d", name, max_digits));
    if (find_placeholder(name, placeholder->begin + placeholder->length))
        throw UsageError(fmt::format("-o {}: the name has two places for the frame number; leave one of them", name));
}

std::filesystem::path OutputName::path(int64_t frame) const {
    if (!has_frame_number_)
        return folder_ / before_;
    const uint64_t magnitude = frame < 0 ? uint64_t(-frame) : uint64_t(frame);
    return folder_ / fmt::format("{}{}{:0{}}{}", before_, frame < 0 ? "-" : "", magnitude, digits_, after_);
}

SampleType choose_sample_type(ImageFormat format, const std::optional<std::string>& bits) {
    const auto& choices = choices_of(format);
    if (!bits)
        return choices.front().type;
    std::vector<std::string> names;
    for (const BitsChoice& choice : choices) {
        if (*bits == choice.bits)
            return choice.type;
        names.push_back(choice.bits);
    }
    throw UsageError(
        fmt::format("--bits {}: this type of file does not hold it; it holds {}", *bits, fmt::join(names, ", ")));
}

} // namespace proxima
