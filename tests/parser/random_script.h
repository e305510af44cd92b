// SPDX-License-Identifier: Apache-2.0
// Random scripts in which numbers follow from the time by every way that the scene language has: expressions, names,
// vectors, arrays, macros, loops, functions and transforms.
#pragma once
#include <random>
#include <string>
#include <vector>

namespace proxima::testing {

class RandomScript {
public:
    explicit RandomScript(uint64_t seed) : random_(seed) {}

    /// Declares what numbers and vectors may ask for: the random numbers R, splines, functions, arrays and macros.
    std::string declarations();
    /// A number, of names that are declared.
    std::string number(int depth = 3);
    std::string vector(int depth = 2);
    /// A whole scene. With `control`, conditions and the like may look at the time.
    std::string scene(bool control);

private:
    uint32_t below(uint32_t count) { return uint32_t(random_() % count); }
    bool chance(double share) { return double(random_() >> 11) * 0x1p-53 < share; }
    std::string constant();
    std::string name(const char* letter, size_t count) { return letter + std::to_string(below(uint32_t(count))); }
    std::string one_of(std::initializer_list<const char*> words) {
        return words.begin()[below(uint32_t(words.size()))];
    }
    std::string condition();
    std::string index(uint32_t size);
    std::string element();
    std::string spline();
    std::string function_body(int depth);
    std::string transform();
    std::string color();
    std::string surface();
    std::string sphere();
    std::string object(int depth);
    std::string statement(bool control, int depth);

    std::mt19937_64 random_;
    size_t numbers_ = 0; ///< N0, N1, ... are declared
    size_t vectors_ = 0; ///< V0, V1, ...
    std::string loop_;   ///< the variable of the loop around, or empty
};

} // namespace proxima::testing
