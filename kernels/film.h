// SPDX-License-Identifier: Apache-2.0
// The picture while it is made: where its samples lie, in which order its pixels are traced, and how the sums of
// samples become linear light.
#pragma once
#include "kernels/camera.h"

#include <span>

namespace proxima {

/// The curve of a scene's working space; the numbers of parser/scene_program.h's WorkingCurve.
enum class FilmCurve : uint32_t { linear, power, srgb };

/// Where the samples of a pixel lie.
enum class SamplePattern : uint32_t {
    sequence,        ///< the R2 sequence from the centre on
    grid,            ///< the centres of `grid_side` by `grid_side` cells
    center_and_grid, ///< the same after the pixel's centre
    corner,          ///< the upper left corner
};

/// What is known of a sample of a film with marks.
enum SampleMark : uint8_t { sample_unknown, sample_wanted, sample_known };

struct PixelPosition {
    uint32_t x, y; ///< may lie outside the picture, in the part of a tile that sticks out
};

/// Sums of samples. A film may be finer than the picture, or begin outside of it: its pixel (x, y) lies at origin +
/// step * (x, first_row + y), in pixels of the picture.
struct FilmView {
    std::span<glm::vec3> pixels; ///< rows from top to bottom
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t samples = 1;
    uint32_t picture_width = 0;  ///< 0: the film's own
    uint32_t picture_height = 0; ///< 0: the film's own
    SamplePattern pattern = SamplePattern::sequence;
    uint32_t grid_side = 1;
    float origin = 0.0f;
    float step = 1.0f;
    uint32_t first_row = 0;     ///< of a band of a larger film: what is traced does not depend on where that is cut
    std::span<uint8_t> marks{}; ///< a SampleMark a pixel: only what is wanted is traced; without marks, all

    HD uint32_t columns() const { return picture_width ? picture_width : width; }
    HD uint32_t rows() const { return picture_height ? picture_height : height; }
    /// Where a pixel of the band lies in the whole film.
    HD PixelPosition in_whole(PixelPosition pixel) const { return {pixel.x, pixel.y + first_row}; }
};

/// Pixels are traced in tiles of 8x4, so that neighbours in a warp or a cache see the same primitives.
inline constexpr uint32_t tile_width = 8, tile_height = 4;

/// Tiles come in groups of 2 by 2.
HD inline uint64_t tiled_pixel_count(uint32_t width, uint32_t height) {
    constexpr uint32_t group_width = 2 * tile_width, group_height = 2 * tile_height;
    return uint64_t((width + group_width - 1) / group_width) * ((height + group_height - 1) / group_height) *
           (group_width * group_height);
}

HD inline PixelPosition tiled_pixel(uint64_t index, uint32_t width) {
    constexpr uint32_t tile = tile_width * tile_height;
    const uint32_t groups_across = (width + 2 * tile_width - 1) / (2 * tile_width);
    const uint32_t group = uint32_t(index / (4 * tile)); // films have fewer: see FramePipeline
    const uint32_t in_group = uint32_t(index / tile) % 4, within = uint32_t(index) % tile;
    return {(group % groups_across * 2 + in_group % 2) * tile_width + within % tile_width,
            (group / groups_across * 2 + in_group / 2) * tile_height + within / tile_width};
}

/// Where sample `index` lies in its pixel, in [0, 1): the R2 sequence from the centre on (Roberts, "The Unreasonable
/// Effectiveness of Quasirandom Sequences", 2018), in fixed point so that every processor has the same.
template <class Real> struct SampleOffset { Real x, y; };

template <class Real> HD SampleOffset<Real> sample_offset(uint32_t index) {
    constexpr Real unit = Real(1) / Real(16777216); // 2^-24: exact in either precision
    return {Real((0x80000000u + index * 3242174889u) >> 8) * unit,
            Real((0x80000000u + index * 2447445414u) >> 8) * unit};
}

/// The same for the other patterns.
template <class Real> HD SampleOffset<Real> sample_offset(const FilmView& film, uint32_t index) {
    if (film.pattern == SamplePattern::sequence)
        return sample_offset<Real>(index);
    if (film.pattern == SamplePattern::corner)
        return {Real(0), Real(0)};
    if (film.pattern == SamplePattern::center_and_grid && index-- == 0)
        return {Real(0.5), Real(0.5)};
    return {(Real(index % film.grid_side) + Real(0.5)) / Real(film.grid_side),
            (Real(index / film.grid_side) + Real(0.5)) / Real(film.grid_side)};
}

/// The camera ray through a place of a pixel of the whole film.
template <class Real>
HD_INNER Ray<Real> pixel_ray(const Camera<Real>& camera, const FilmView& film, PixelPosition pixel,
                             const SampleOffset<Real>& offset) {
    // As signed numbers: few processors have vector instructions for the others.
    const Real x = Real(int32_t(pixel.x)) * Real(film.step) + Real(film.origin) + offset.x;
    const Real y = Real(int32_t(pixel.y)) * Real(film.step) + Real(film.origin) + offset.y;
    return camera_ray(camera, x / Real(film.columns()) - Real(0.5), Real(0.5) - y / Real(film.rows()));
}

/// The camera ray through a sample.
template <class Real>
HD Ray<Real> pixel_ray(const Camera<Real>& camera, const FilmView& film, PixelPosition pixel, uint32_t sample) {
    return pixel_ray(camera, film, pixel, sample_offset<Real>(film, sample));
}

HD inline float srgb_to_linear(float v) {
    return v <= 0.04045f ? v / 12.92f : power((v + 0.055f) / 1.055f, 2.4f);
}

/// Pixel -> the mean of its samples, in linear light.
struct ResolvePixels {
    FilmView film;
    FilmCurve curve = FilmCurve::linear;
    float gamma = 1.0f;

    HD void operator()(uint32_t index) const {
        glm::vec3 v = film.pixels[index] / float(film.samples);
        for (int i = 0; i < 3; ++i) {
            if (curve == FilmCurve::power)
                v[i] = power(larger(v[i], 0.0f), gamma);
            else if (curve == FilmCurve::srgb)
                v[i] = srgb_to_linear(v[i]);
        }
        film.pixels[index] = v;
    }
};

/// Pixel -> the mean of several pictures: run once for each of them in turn, it leaves the mean in the last one.
struct AverageExposures {
    std::span<glm::vec3> picture;
    std::span<glm::vec3> sum;
    uint32_t exposure = 0; ///< the picture's number, from 0
    uint32_t exposures = 1;

    HD void operator()(uint32_t index) const {
        const glm::vec3 total = exposure == 0 ? picture[index] : sum[index] + picture[index];
        sum[index] = total;
        if (exposure + 1 == exposures)
            picture[index] = total / float(exposures);
    }
};

} // namespace proxima
