// SPDX-License-Identifier: Apache-2.0
// How rays find spheres, grid or cloud, and what is known of the two when one is chosen.
#pragma once
#include <cstddef>
#include <cstdint>

namespace proxima {

/// How rays find spheres, where there is a choice.
enum class SearchMethod : uint8_t { grid, cloud };

constexpr SearchMethod other_than(SearchMethod method) {
    return method == SearchMethod::grid ? SearchMethod::cloud : SearchMethod::grid;
}

/// A value of each method.
template <class T> struct OfMethods {
    T grid{}, cloud{};

    constexpr T& operator[](SearchMethod method) { return method == SearchMethod::grid ? grid : cloud; }
    constexpr const T& operator[](SearchMethod method) const { return method == SearchMethod::grid ? grid : cloud; }
};

/// What a look finds: the bricks of a cloud that need not be built for it.
struct EmptySpace {
    uint64_t primitives = 0; ///< in the bricks
    uint64_t bricks = 0, empty = 0;
    double mean_distance = 0; ///< chessboard, over the empty bricks, in bricks (Cohen and Sheffer's own measure)

    double occupied() const { return bricks > 0 ? 1 - double(empty) / double(bricks) : 0; }
};

/// asked: for by name; few: primitives; prior: by predicted_ms; trial: to be timed; measured: both have been timed.
enum class MethodReason : uint8_t { asked, few, prior, trial, measured };

inline const char* name_of(MethodReason reason) {
    static constexpr const char* names[] = {"asked", "few", "prior", "trial", "measured"};
    return names[size_t(reason)];
}

/// Why a frame is by grid or cloud, and what was known then; milliseconds of build, map and trace, 0 where unknown.
struct MethodRecord {
    MethodReason reason = MethodReason::asked;
    EmptySpace space{};
    OfMethods<double> predicted{}, measured{};
};

} // namespace proxima
