// SPDX-License-Identifier: Apache-2.0
#include "renderer/output_name.h"
#include "renderer/errors.h"
#include "renderer/option_values.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace proxima {
namespace {

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
    if (extension == ".gif")
        return ImageFormat::gif;
    throw UsageError(fmt::format("-o {}: {}; end the name in .png, .exr, .tif, .jpg or .gif", name.string(),
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
    static const std::vector<BitsChoice> palette_or_jpeg{{"8", SampleType::uint8}};
    switch (format) {
    case ImageFormat::png:
        return png;
    case ImageFormat::exr:
        return exr;
    case ImageFormat::tiff:
        return tiff;
    case ImageFormat::jpeg:
    case ImageFormat::gif:
        break;
    }
    return palette_or_jpeg;
}

} // namespace

OutputName::OutputName(const std::filesystem::path& pattern) : name_("-o", pattern), format_(format_of(pattern)) {}

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

Compression choose_compression(ImageFormat format, const std::optional<std::string>& name) {
    if (!name)
        return Compression::zip;
    if (format != ImageFormat::exr)
        throw UsageError(fmt::format("--compression {}: only .exr files have a choice; leave it out", *name));
    return parse_choice<Compression>("--compression", *name,
                                     {{"zip", Compression::zip},
                                      {"zips", Compression::zips},
                                      {"piz", Compression::piz},
                                      {"dwaa", Compression::dwaa},
                                      {"none", Compression::none}});
}

} // namespace proxima
