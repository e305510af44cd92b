// SPDX-License-Identifier: Apache-2.0
// Arrangements of spheres, all in or near the unit cube: a sphere's number among how many in, its place and size out.
#pragma once
#include "kernels/vector_math.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <random>
#include <utility>
#include <vector>

namespace proxima::bench {

using Point = Vec3<double>;

/// A sequence of spheres, all in or near the unit cube.
class Dice {
public:
    explicit Dice(uint32_t seed) : engine_(seed) {}
    double number() { return double(engine_()) / 4294967296.0; }
    double between(double low, double high) { return low + (high - low) * number(); }
    /// Box and Muller, "A Note on the Generation of Random Normal Deviates", 1958.
    double normal() { return std::sqrt(-2 * std::log(1 - number())) * std::cos(6.283185307179586 * number()); }
    Point in_cube() {
        const double x = number(), y = number();
        return {x, y, number()};
    }
    Point normal_point() {
        const double x = normal(), y = normal();
        return {x, y, normal()};
    }
    Point direction() { return glm::normalize(normal_point()); }

private:
    std::mt19937 engine_;
};

struct Ball {
    Point center;
    double radius;
};
using Arrangement = std::function<Ball(Dice&, uint32_t index, uint32_t count)>;

/// `count` things, each of dice of its own.
template <class Make> auto made_once(uint32_t seed, uint32_t count, const Make& make) {
    std::vector<decltype(make(std::declval<Dice&>()))> things;
    for (uint32_t i = 0; i < count; ++i) {
        Dice dice(seed + i);
        things.push_back(make(dice));
    }
    return things;
}
inline std::vector<Point> points(uint32_t seed, uint32_t count) {
    return made_once(seed, count, [](Dice& dice) { return dice.in_cube(); });
}

inline double spacing(uint32_t count) {
    return std::pow(double(count), -1.0 / 3);
}

inline Arrangement uniform(double size) {
    return [=](Dice& dice, uint32_t, uint32_t count) { return Ball{dice.in_cube(), size * spacing(count)}; };
}
inline Arrangement planes(uint32_t sheets, double size) {
    return [=](Dice& dice, uint32_t index, uint32_t count) {
        Point at = dice.in_cube();
        at.z = sheets == 1 ? 0.5 : 0.05 + 0.9 * (index % sheets) / (sheets - 1);
        return Ball{at, size / std::sqrt(double(count) / sheets)};
    };
}
inline Arrangement clusters(uint32_t number, double width, double size) {
    return [=, middles = points(1000, number)](Dice& dice, uint32_t index, uint32_t count) {
        return Ball{middles[index % number] + width * dice.normal_point(),
                    size * width / std::cbrt(double(count) / number)};
    };
}
inline Arrangement shell(double thickness, double size) {
    return [=](Dice& dice, uint32_t, uint32_t count) {
        return Ball{Point(0.5) + dice.between(0.5 - thickness, 0.5) * dice.direction(),
                    size / std::sqrt(double(count))};
    };
}
inline Arrangement lines(uint32_t number, double width, double size) {
    const auto ends = made_once(2000, number, [](Dice& dice) {
        const Point from = dice.in_cube();
        return std::pair(from, dice.in_cube());
    });
    return [=](Dice& dice, uint32_t index, uint32_t count) {
        const auto& [from, to] = ends[index % number];
        return Ball{from + dice.number() * (to - from) + width * dice.normal_point(), size * number / double(count)};
    };
}
inline Arrangement mixed(double decades) {
    return [=](Dice& dice, uint32_t, uint32_t count) {
        const Point at = dice.in_cube();
        return Ball{at, 0.5 * spacing(count) * std::pow(10.0, -decades * dice.number())};
    };
}
inline Arrangement lattice(double size) {
    return [=](Dice&, uint32_t index, uint32_t count) {
        const uint32_t n = std::max(1u, uint32_t(std::cbrt(double(count))));
        const Point cell(index % n, index / n % n, index / n / n);
        return Ball{(cell + Point(0.5)) / double(n), size / n};
    };
}
/// Dense in the middle, with an edge that fades out.
inline Arrangement disc(double flatness) {
    return [=](Dice& dice, uint32_t, uint32_t count) {
        const double far = -0.12 * std::log(1 - dice.number()), turn = dice.between(0, 6.283185307179586);
        return Ball{{0.5 + far * std::cos(turn), 0.5 + flatness * dice.normal(), 0.5 + far * std::sin(turn)},
                    0.1 * spacing(count)};
    };
}
/// A part of the cube is full, the rest empty.
inline Arrangement corner(double part) {
    return [=](Dice& dice, uint32_t index, uint32_t count) {
        const Point at = dice.in_cube();
        return Ball{index < 8 ? at : at * part, 0.3 * part * spacing(count)};
    };
}
/// A dense ball, and one sphere in `rare` far away.
inline Arrangement outliers(double width, uint32_t rare) {
    return [=](Dice& dice, uint32_t index, uint32_t count) {
        if (index % rare == 0)
            return Ball{dice.in_cube(), width * spacing(count)};
        return Ball{Point(0.5) + width * std::cbrt(dice.number()) * dice.direction(), 0.3 * width * spacing(count)};
    };
}
/// Uniform but for large holes.
inline Arrangement sponge(uint32_t holes, double width) {
    return [=, middles = points(3000, holes)](Dice& dice, uint32_t, uint32_t count) {
        for (;;) {
            const Point at = dice.in_cube();
            const auto holds = [&](const Point& middle) { return glm::distance(at, middle) < width; };
            if (std::none_of(middles.begin(), middles.end(), holds))
                return Ball{at, 0.25 * spacing(count)};
        }
    };
}
/// A surface of hills.
inline Arrangement hills(double size) {
    return [=](Dice& dice, uint32_t, uint32_t count) {
        const double x = dice.number(), z = dice.number();
        return Ball{{x, 0.3 + 0.1 * std::sin(9 * x) * std::cos(7 * z), z}, size / std::sqrt(double(count))};
    };
}
inline Arrangement spiral(double size) {
    return [=](Dice& dice, uint32_t index, uint32_t count) {
        const double t = double(index) / count, turn = 40 * t;
        return Ball{Point(0.5 + 0.4 * t * std::cos(turn), t, 0.5 + 0.4 * t * std::sin(turn)) +
                        0.004 * dice.normal_point(),
                    size / double(count)};
    };
}

} // namespace proxima::bench
