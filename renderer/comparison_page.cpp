// SPDX-License-Identifier: Apache-2.0
#include "renderer/comparison_page.h"
#include "embedded_page.h"
#include "parser/source_files.h"
#include "renderer/atomic_file.h"
#include "renderer/difference_picture.h"
#include "renderer/page_template.h"

#include <fmt/format.h>
#include <string_view>

namespace proxima {
namespace {

constexpr std::string_view data_place = "/*COMPARISON*/";

std::span<const unsigned char> bytes_of(std::string_view text) {
    return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

} // namespace

ComparisonPage::ComparisonPage(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(folder_ / "pictures", error);
    if (error)
        throw FileError(fmt::format("{}: cannot be made: {}", (folder_ / "pictures").string(), error.message()));
    check_writable(folder_ / "index.html");
    check_writable(folder_ / "pictures" / "1.a.png");
}

void ComparisonPage::add_pictures(size_t index, const ImagePair& pair, double tolerance, ImageEncoder& encoder) const {
    const auto write = [&](const char* what, const Image& image) {
        write_file(folder_ / "pictures" / fmt::format("{}.{}.png", index + 1, what),
                   encoder.encode(image, {.facts = {.color_encoding = "sRGB"}}));
    };
    write("a", displayed(pair, pair.a));
    write("b", displayed(pair, pair.b));
    write("difference", difference_map(pair, tolerance));
}

void ComparisonPage::finish(const ComparisonRecord& comparison) const {
    const std::string page = fill_page(embedded_comparison_page, data_place, to_json(comparison));
    write_file(folder_ / "index.html", bytes_of(page));
}

} // namespace proxima
