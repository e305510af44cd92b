// SPDX-License-Identifier: Apache-2.0
#include "renderer/render_page.h"
#include "embedded_render_page.h"
#include "parser/source_files.h"
#include "renderer/atomic_file.h"
#include "renderer/page_template.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proxima {
namespace {

constexpr uint32_t thumbnail_width = 240; // pixels

} // namespace

RenderPage::RenderPage(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(folder_ / "pictures", error);
    if (error)
        throw FileError(fmt::format("{}: cannot be made: {}", (folder_ / "pictures").string(), error.message()));
    check_writable(folder_ / "index.html");
    check_writable(folder_ / "pictures" / "0.png");
}

Image RenderPage::thumbnail(const Image& image) {
    const uint32_t step = std::max(1u, (image.width + thumbnail_width - 1) / thumbnail_width);
    Image small{std::max(1u, image.width / step), std::max(1u, image.height / step), {}};
    small.rgb.resize(size_t(small.width) * small.height * 3);
    const uint32_t wide = std::min(step, image.width), high = std::min(step, image.height);
    for (uint32_t y = 0; y < small.height; ++y)
        for (uint32_t x = 0; x < small.width; ++x)
            for (uint32_t channel = 0; channel < 3; ++channel) {
                float sum = 0;
                for (uint32_t v = 0; v < high; ++v)
                    for (uint32_t u = 0; u < wide; ++u)
                        sum += image.rgb[(size_t(y * step + v) * image.width + x * step + u) * 3 + channel];
                small.rgb[(size_t(y) * small.width + x) * 3 + channel] = sum / float(wide * high);
            }
    return small;
}

void RenderPage::add_picture(int64_t frame, const Image& picture, ImageEncoder& encoder) const {
    write_file(folder_ / "pictures" / fmt::format("{}.png", frame),
               encoder.encode(picture, {.facts = {.color_encoding = "sRGB"}}));
}

void RenderPage::add_frame(const FrameRecord& record) {
    const std::lock_guard lock(mutex_);
    frames_.push_back(record);
}

void RenderPage::add_kept(int64_t frame, const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    kept_.emplace(frame, file.string());
}

void RenderPage::finish(RunRecord run, const std::vector<std::string>& notes, const std::string& error) const {
    const std::lock_guard lock(mutex_);
    run.frames = frames_;
    std::ranges::sort(run.frames, {}, &FrameRecord::frame);
    auto json = nlohmann::ordered_json::parse(to_json(run));
    json["kept"] = nlohmann::ordered_json::array();
    for (const auto& [frame, file] : kept_)
        json["kept"].push_back({{"frame", frame}, {"file", file}});
    json["notes"] = notes;
    json["error"] = error;
    const std::string page = fill_page(embedded_render_page, "/*RUN*/",
                                       json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    write_file(folder_ / "index.html", {reinterpret_cast<const unsigned char*>(page.data()), page.size()});
}

} // namespace proxima
