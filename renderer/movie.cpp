// SPDX-License-Identifier: Apache-2.0
#include "renderer/movie.h"
#include "parser/source_files.h"
#include "renderer/atomic_file.h"
#include "renderer/child_process.h"
#include "renderer/displayed_picture.h"
#include "renderer/errors.h"
#include "renderer/image_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <span>
#include <string>
#include <utility>

namespace proxima {
namespace {

/// A kind of film: how ffmpeg is to encode it.
struct MovieKind {
    std::string_view ending, container, encoder;
    std::vector<std::string> quality;
};

const MovieKind kinds[] = {
    {".mp4", "mp4", "libx264", {"-crf", "16", "-movflags", "+faststart"}},
    {".webm", "webm", "libvpx-vp9", {"-crf", "20", "-b:v", "0"}},
};

const MovieKind& kind_of(const std::filesystem::path& path) {
    const auto kind = std::ranges::find(kinds, path.extension().string(), &MovieKind::ending);
    if (kind == std::end(kinds))
        throw UsageError(fmt::format("--movie {}: end the name in .mp4 or .webm", path.string()));
    return *kind;
}

std::vector<std::string> ffmpeg_command(const MovieKind& kind, const FrameRate& rate, uint32_t width, uint32_t height,
                                        const std::filesystem::path& output) {
    std::vector<std::string> arguments = {
        "ffmpeg", "-hide_banner", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
        fmt::format("{}x{}", width, height), "-framerate", fmt::format("{}/{}", rate.numerator, rate.denominator), "-i",
        "pipe:0",
        // Every player shows 4:2:0 of even size with Rec.709's matrix, and takes the curve that is named.
        "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p", "-colorspace",
        "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-c:v", std::string(kind.encoder)};
    arguments.insert(arguments.end(), kind.quality.begin(), kind.quality.end());
    for (const char* argument : {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-y", "-f"})
        arguments.emplace_back(argument); // no time, no version: the same frames make the same film
    arguments.emplace_back(kind.container);
    arguments.push_back("file:" + output.string());
    return arguments;
}

} // namespace

Movie::Movie(std::filesystem::path path, FrameRate rate) : path_(std::move(path)), rate_(rate) {
    const MovieKind& kind = kind_of(path_);
    const ProcessResult encoders = run_process({"ffmpeg", "-hide_banner", "-encoders"}, ".", 30);
    if (encoders.exit_code == 127)
        throw UsageError(
            fmt::format("--movie {}: there is no ffmpeg; install it (Debian's package is called ffmpeg), or "
                        "leave --movie out",
                        path_.string()));
    if (encoders.standard_output.find(fmt::format(" {} ", kind.encoder)) == std::string::npos)
        throw UsageError(
            fmt::format("--movie {}: this ffmpeg cannot encode it, it has no {}", path_.string(), kind.encoder));
    check_writable(path_);
}

void Movie::make(const std::vector<std::filesystem::path>& pictures, const ColorTransform& view) const {
    PendingFile file(path_);
    std::unique_ptr<FedProcess> ffmpeg;
    std::pair<uint32_t, uint32_t> size;
    bool takes_more = true;
    for (size_t i = 0; i < pictures.size() && takes_more; ++i) {
        StoredImage picture = read_image_file(pictures[i]);
        const std::pair own_size{picture.width, picture.height};
        if (!ffmpeg) {
            size = own_size;
            ffmpeg = std::make_unique<FedProcess>(
                ffmpeg_command(kind_of(path_), rate_, size.first, size.second, file.temporary()));
        }
        if (own_size != size)
            throw FileError(fmt::format("{}: it is {}x{}, and the pictures before it are {}x{}", pictures[i].string(),
                                        own_size.first, own_size.second, size.first, size.second));
        takes_more = ffmpeg->write(quantize_to_bytes(displayed_picture(std::move(picture), view)));
    }
    if (!ffmpeg)
        return;
    if (const int code = ffmpeg->finish(); code != 0 || !takes_more)
        throw FileError(
            fmt::format("{}: cannot be written: ffmpeg ended with {}: {}", path_.string(), code, ffmpeg->messages()));
    file.commit();
}

} // namespace proxima
