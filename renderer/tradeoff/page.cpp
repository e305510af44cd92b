// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/page.h"
#include "parser/source_files.h"
#include "renderer/atomic_file.h"
#include "renderer/color.h"
#include "renderer/difference_picture.h"
#include "renderer/page_template.h"
#include "renderer/timing.h"
#include "renderer/tradeoff/chart.h"
#include "renderer/tradeoff/text.h"
#include "tradeoff/embedded_page.h"

#include <fmt/format.h>

namespace proxima {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
    write_file(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

/// Two linear pictures as they are compared.
ImagePair pair_of(const Image& picture, const Image& reference) {
    return {.width = picture.width, .height = picture.height, .is_linear = true, .a = picture.rgb, .b = reference.rgb};
}

struct FileKind {
    const char* bits;
    SampleType type;
    const char* name;
    Compression compression;
};

constexpr FileKind file_kinds[] = {
    {"half", SampleType::half, "zip", Compression::zip},      {"half", SampleType::half, "zips", Compression::zips},
    {"half", SampleType::half, "piz", Compression::piz},      {"half", SampleType::half, "none", Compression::none},
    {"half", SampleType::half, "dwaa", Compression::dwaa},    {"float", SampleType::float32, "zip", Compression::zip},
    {"float", SampleType::float32, "none", Compression::none}};

} // namespace

TradeoffPage::TradeoffPage(std::filesystem::path folder) : folder_(std::move(folder)) {
    for (const char* part : {"pictures", "files"}) {
        std::error_code error;
        std::filesystem::create_directories(folder_ / part, error);
        if (error)
            throw FileError(fmt::format("{}: cannot be made: {}", (folder_ / part).string(), error.message()));
        check_writable(folder_ / part / "1.png");
    }
    check_writable(folder_ / "index.html");
}

void TradeoffPage::add_reference(const Image& reference) {
    write_file(folder_ / "pictures" / "reference.png",
               encoder_.encode(displayed(pair_of(reference, reference), reference.rgb),
                               {.facts = {.color_encoding = "sRGB"}}));
}

void TradeoffPage::add_point(size_t index, const Image& picture, const Image& reference) {
    const ImagePair pair = pair_of(picture, reference);
    const ImageFileSettings shown{.facts = {.color_encoding = "sRGB"}};
    write_file(folder_ / "pictures" / fmt::format("{}.png", index + 1),
               encoder_.encode(displayed(pair, pair.a), shown));
    write_file(folder_ / "pictures" / fmt::format("{}.difference.png", index + 1),
               encoder_.encode(difference_map(pair, 1.0 / 255), shown));
}

void TradeoffPage::add_files(TradeoffRecord& record, const Image& picture) {
    Image image{picture.width, picture.height, picture.rgb};
    replace_non_finite(image);
    for (const FileKind& kind : file_kinds) {
        FilePoint point{.bits = kind.bits, .compression = kind.name};
        Image written = image;
        if (kind.type == SampleType::half)
            clamp_to_half(written);
        const ImageFileSettings settings{
            .format = ImageFormat::exr, .type = kind.type, .compression = kind.compression};
        std::vector<unsigned char> bytes = encoder_.encode(written, settings); // the first one loads the encoder
        for (uint32_t repeat = 0; repeat < record.repeats; ++repeat) {
            double ms = 0;
            timed(ms, [&] { bytes = encoder_.encode(written, settings); });
            point.repeats.push_back(ms);
        }
        point.file = fmt::format("files/{}-{}.exr", kind.bits, kind.name);
        write_file(folder_ / point.file, bytes);
        const StoredImage read = read_image_file(folder_ / point.file);
        point.bytes = bytes.size();
        point.ms = median(point.repeats);
        point.error = measure_error({read.width, read.height, read.samples}, image);
        record.files.push_back(std::move(point));
    }
}

void TradeoffPage::finish(const TradeoffRecord& record) const {
    const std::string json = tradeoff_json(record);
    write_text(folder_ / "table.txt", tradeoff_text(record));
    write_text(folder_ / "table.csv", tradeoff_csv(record));
    write_text(folder_ / "table.json", json);
    write_text(folder_ / "chart.svg", tradeoff_svg(record));
    write_text(folder_ / "index.html", fill_page(embedded_tradeoff_page, "/*TRADEOFF*/", json));
}

} // namespace proxima
