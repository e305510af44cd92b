// SPDX-License-Identifier: Apache-2.0
// POV-Ray's two ways to look closer where neighbours differ. Samples of a first pass come in, marks of the samples that
// are missing go out, until none is missing: then the picture is complete, and the same as in POV-Ray, which decides
// and traces in one go.
#pragma once
#include "kernels/film.h"

namespace proxima {

/// Marks a sample that is not there yet and counts it.
HD inline void want(const FilmView& film, uint64_t index, uint32_t* missing) {
    if (film.marks[index] == sample_unknown) {
        film.marks[index] = sample_wanted;
        atomic_add(missing, 1);
    }
}

/// Sample of a lattice -> its mark: the pixels' corners, which lie on multiples of `mask` + 1, are wanted.
struct WantCorners {
    FilmView lattice;
    uint32_t mask = 0;

    HD void operator()(uint32_t index) const {
        const uint32_t x = index % lattice.width, y = index / lattice.width;
        lattice.marks[index] = (x & mask) == 0 && (y & mask) == 0 ? sample_wanted : sample_unknown;
    }
};

/// How different two colours look to POV-Ray's antialiasing: the sum over the channels after the curve of gamma 2.5.
HD inline float visible_difference(const glm::vec3& a, const glm::vec3& b) {
    float sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += magnitude(power(larger(a[i], 0.0f), 0.4f) - power(larger(b[i], 0.0f), 0.4f));
    return sum;
}

/// Method 1, a block of 32 by 32 pixels a call: a pixel whose centre differs from its left or upper neighbour, as far
/// as those are decided, is sampled on a grid, and so is the neighbour when it lies in the same block.
struct DecideBlock {
    static constexpr uint32_t side = 32;

    FilmView picture;            ///< the result
    FilmView centers;            ///< one column and one row wider, on the left and above
    FilmView grids;              ///< sums of `depth` x `depth` samples a pixel, with marks
    std::span<uint8_t> refined;  ///< a flag a pixel
    std::span<uint32_t> missing; ///< one counter
    float threshold = 0.3f;
    uint32_t depth = 3;

    HD void operator()(uint32_t block) const {
        const uint32_t blocks_across = (picture.width + side - 1) / side;
        const uint32_t left = block % blocks_across * side, top = block / blocks_across * side;
        const uint32_t right = smaller(left + side, picture.width), bottom = smaller(top + side, picture.height);
        for (uint32_t y = top; y < bottom; ++y)
            for (uint32_t x = left; x < right; ++x)
                decide(x, y, x > left, y > top);
        for (uint32_t y = top; y < bottom; ++y)
            for (uint32_t x = left; x < right; ++x)
                picture.pixels[at(x, y)] = color(x, y);
    }

private:
    HD uint64_t at(uint32_t x, uint32_t y) const { return uint64_t(y) * picture.width + x; }
    HD glm::vec3 center(uint32_t x, uint32_t y) const {
        return centers.pixels[uint64_t(y + 1) * centers.width + x + 1];
    }
    HD glm::vec3 color(uint32_t x, uint32_t y) const {
        const uint64_t index = at(x, y);
        if (!refined[index] || grids.marks[index] != sample_known)
            return center(x, y);
        return (center(x, y) + grids.pixels[index]) / float(depth * depth + 1);
    }
    HD void refine(uint32_t x, uint32_t y) const {
        refined[at(x, y)] = 1;
        want(grids, at(x, y), &missing[0]);
    }

    /// `left_inside`, `top_inside`: the neighbours belong to the block.
    HD void decide(uint32_t x, uint32_t y, bool left_inside, bool top_inside) const {
        const glm::vec3 own = center(x, y);
        // Neighbours outside the block are known by their centres and stay as they are.
        const glm::vec3 left = left_inside ? color(x - 1, y) : centers.pixels[uint64_t(y + 1) * centers.width + x];
        const glm::vec3 top = top_inside ? color(x, y - 1) : centers.pixels[uint64_t(y) * centers.width + x + 1];
        const bool left_differs = visible_difference(left, own) >= threshold;
        const bool top_differs = visible_difference(top, own) >= threshold;
        refined[at(x, y)] = 0;
        if (left_differs && left_inside)
            refine(x - 1, y);
        if (top_differs && top_inside)
            refine(x, y - 1);
        if (left_differs || top_differs)
            refine(x, y);
    }
};

/// Method 2, a pixel a call: a square is the mean of its corners, or of its quarters when two of the corners differ.
struct DecideSquares {
    static constexpr uint32_t deepest = 5;

    FilmView picture; ///< the result
    FilmView lattice; ///< 2^levels samples a pixel's side, with marks; those of the pixels' corners are known
    std::span<uint32_t> missing; ///< one counter
    float threshold = 0.3f;
    uint32_t levels = 2;

    HD void operator()(uint32_t pixel) const {
        struct Square {
            uint32_t x, y, level;
        };
        const uint32_t side = 1u << levels;
        Square waiting[3 * deepest + 1];
        uint32_t count = 0;
        waiting[count++] = {pixel % picture.width * side, pixel / picture.width * side, 0};
        glm::vec3 sum(0.0f);
        while (count > 0) {
            const Square square = waiting[--count];
            const uint32_t size = side >> square.level, half = size / 2;
            if (square.level < levels && differs(square.x, square.y, size) && has_quarters(square.x, square.y, half)) {
                for (uint32_t i = 0; i < 4; ++i)
                    waiting[count++] = {square.x + i % 2 * half, square.y + i / 2 * half, square.level + 1};
                continue;
            }
            const glm::vec3 corners = at(square.x, square.y) + at(square.x + size, square.y) +
                                      at(square.x, square.y + size) + at(square.x + size, square.y + size);
            sum += corners / float(4u << (2 * square.level));
        }
        picture.pixels[pixel] = sum;
    }

private:
    HD uint64_t index(uint32_t x, uint32_t y) const { return uint64_t(y) * lattice.width + x; }
    HD glm::vec3 at(uint32_t x, uint32_t y) const { return lattice.pixels[index(x, y)]; }

    HD bool differs(uint32_t x, uint32_t y, uint32_t size) const {
        const glm::vec3 corners[4] = {at(x, y), at(x + size, y), at(x, y + size), at(x + size, y + size)};
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j)
                if (visible_difference(corners[i], corners[j]) >= threshold)
                    return true;
        return false;
    }
    /// Whether the five samples that quarters need are there; those that are not are asked for.
    HD bool has_quarters(uint32_t x, uint32_t y, uint32_t half) const {
        const uint64_t needed[5] = {index(x, y + half), index(x + half, y), index(x + half, y + half),
                                    index(x + 2 * half, y + half), index(x + half, y + 2 * half)};
        bool all = true;
        for (const uint64_t sample : needed) {
            all = all && lattice.marks[sample] == sample_known;
            want(lattice, sample, &missing[0]);
        }
        return all;
    }
};

} // namespace proxima
