// SPDX-License-Identifier: Apache-2.0
#include "renderer/png_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <stdexcept>
#include <string_view>

namespace proxima {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr size_t most = size_t(1) << 30;  ///< bytes at a time: chunks' lengths have 31 bits, ISA-L's 32
constexpr uint32_t compression_level = 2; ///< of ISA-L, see tests/bench/NOTES.md

void append(Bytes& bytes, uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<unsigned char>(number >> shift));
}

/// A chunk: its length, its name, `write`'s bytes, and a check of name and bytes.
template <class Write> void add_chunk(Bytes& file, std::string_view name, const Write& write) {
    const size_t start = file.size();
    append(file, 0);
    file.insert(file.end(), name.begin(), name.end());
    write(file);
    const size_t checked = file.size() - start - 4;
    Bytes length;
    append(length, uint32_t(checked - 4));
    std::ranges::copy(length, file.begin() + long(start));
    append(file, crc32_gzip_refl(0, file.data() + start + 4, checked));
}

void add_numbers(Bytes& file, std::string_view name, std::initializer_list<uint32_t> numbers) {
    add_chunk(file, name, [&](Bytes& bytes) {
        for (const uint32_t number : numbers)
            append(bytes, number);
    });
}

void add_text(Bytes& file, std::string_view keyword, std::string_view text) {
    add_chunk(file, "tEXt", [&](Bytes& bytes) {
        bytes.insert(bytes.end(), keyword.begin(), keyword.end());
        bytes.push_back(0);
        bytes.insert(bytes.end(), text.begin(), text.end());
    });
}

/// How levels follow from light, as far as PNG has words for it. `encoding` as in FileColors.
void add_encoding(Bytes& file, const std::string& encoding) {
    const auto add_gamma = [&](double gamma) { add_numbers(file, "gAMA", {uint32_t(std::lround(100'000 / gamma))}); };
    if (encoding == "sRGB") {
        add_gamma(2.2);
        add_chunk(file, "sRGB", [](Bytes& bytes) { bytes.push_back(0); }); // perceptual: what readers expect
        add_numbers(file, "cHRM", {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000});
    } else if (encoding == "Linear") {
        add_gamma(1);
    } else if (encoding.starts_with("Gamma")) {
        add_gamma(std::strtod(encoding.c_str() + 5, nullptr));
    }
}

/// The bytes to compress: each row as the differences from one pixel to the next, after a byte that says so. Of 16 bits
/// the higher byte comes first.
template <class Level> Bytes filtered(const EncodeRequest& request) {
    constexpr unsigned char difference_to_the_left = 1;
    constexpr size_t channels = 3, depth = sizeof(Level), step = channels * depth;
    const size_t count = request.width * channels;
    Bytes result(request.height * (1 + count * depth));
    Bytes row(step + count * depth); // after a pixel of zeros
    for (size_t y = 0; y < request.height; ++y) {
        const Level* levels = static_cast<const Level*>(request.samples) + y * count;
        for (size_t i = 0; i < count; ++i)
            for (size_t b = 0; b < depth; ++b)
                row[step + i * depth + b] = static_cast<unsigned char>(levels[i] >> 8 * (depth - 1 - b));
        unsigned char* out = result.data() + y * (1 + count * depth);
        *out++ = difference_to_the_left;
        for (size_t i = 0; i < count * depth; ++i)
            out[i] = static_cast<unsigned char>(row[step + i] - row[i]);
    }
    return result;
}

/// The zlib stream of `data`.
Bytes compressed(Bytes data) {
    constexpr size_t room = size_t(1) << 18; ///< at least, whenever it goes on
    Bytes memory(ISAL_DEF_LVL2_DEFAULT);
    isal_zstream stream;
    isal_deflate_init(&stream);
    stream.level = compression_level;
    stream.level_buf = memory.data();
    stream.level_buf_size = uint32_t(memory.size());
    stream.gzip_flag = IGZIP_ZLIB;
    Bytes result;
    size_t given = 0, used = 0;
    do {
        const size_t part = std::min<size_t>(data.size() - given, most);
        stream.next_in = data.data() + given;
        stream.avail_in = uint32_t(part);
        given += part;
        stream.end_of_stream = given == data.size();
        do {
            result.resize(std::max(used + room, result.size() + result.size() / 2));
            const uint32_t space = uint32_t(std::min<size_t>(result.size() - used, most));
            stream.next_out = result.data() + used;
            stream.avail_out = space;
            if (isal_deflate(&stream) != COMP_OK)
                throw std::runtime_error("PNG: the compressor failed");
            used += space - stream.avail_out;
        } while (stream.avail_out == 0);
    } while (given < data.size());
    result.resize(used);
    return result;
}

} // namespace

std::vector<unsigned char> encode_png(const EncodeRequest& request) {
    const bool is_wide = request.type == SampleType::uint16;
    Bytes file(std::begin(signature), std::end(signature));
    add_chunk(file, "IHDR", [&](Bytes& bytes) {
        append(bytes, request.width);
        append(bytes, request.height);
        for (const int number : {is_wide ? 16 : 8, 2 /* red, green, blue */, 0, 0, 0 /* not interlaced */})
            bytes.push_back(static_cast<unsigned char>(number));
    });
    add_encoding(file, request.facts.color_encoding);
    add_text(file, "Software", request.facts.software);
    if (!request.facts.color_encoding.empty())
        add_text(file, "oiio:ColorSpace", request.facts.color_encoding); // which OpenImageIO takes before the others
    if (!request.facts.hash.empty())
        add_text(file, "Description", request.facts.sentence());
    const Bytes data = compressed(is_wide ? filtered<uint16_t>(request) : filtered<uint8_t>(request));
    for (size_t given = 0; given < data.size(); given += most)
        add_chunk(file, "IDAT", [&](Bytes& bytes) {
            bytes.insert(bytes.end(), data.begin() + long(given),
                         data.begin() + long(std::min(data.size(), given + most)));
        });
    add_chunk(file, "IEND", [](Bytes&) {});
    return file;
}

} // namespace proxima
