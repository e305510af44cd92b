// SPDX-License-Identifier: Apache-2.0
// A sine that is the same on every processor, since it needs nothing but exact additions and multiplications: what it
// would cost beside the one of each processor's library, and how far the two are apart.
#pragma once
#include "kernels/vector_math.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

namespace proxima::bench {

/// |x| at most about 1e5. Reduction in three parts: Cody and Waite, "Software Manual for the Elementary Functions",
/// 1980; the polynomials' coefficients are those of Sun's fdlibm, 1993.
struct PortableSine {
    HD double operator()(double x) const {
        const double quarters = round_down(x * 6.36619772367581382433e-01 + 0.5);
        const double r = ((x - quarters * 1.57079632673412561417e+00) - quarters * 6.07710050630396597660e-11) -
                         quarters * 2.02226624879595063154e-21;
        const double z = r * r;
        const double sine_part = -1.66666666666666324348e-01 +
                                 z * (8.33333333332248946124e-03 +
                                      z * (-1.98412698298579493134e-04 +
                                           z * (2.75573137070700676789e-06 +
                                                z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10))));
        const double cosine_part = 4.16666666666666019037e-02 +
                                   z * (-1.38888888888741095749e-03 +
                                        z * (2.48015872894767294178e-05 +
                                             z * (-2.75573143513906633035e-07 +
                                                  z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))));
        const auto quarter = uint64_t(int64_t(quarters));
        const double v = quarter & 1 ? (1.0 - 0.5 * z) + z * z * cosine_part : r + r * z * sine_part;
        return quarter & 2 ? -v : v;
    }
};

struct LibrarySine {
    HD double operator()(double x) const { return sine(x); }
};

template <class Sine> struct TakeSines {
    std::span<const double> angles;
    std::span<double> sines;
    HD void operator()(uint32_t i) const { sines[i] = Sine{}(angles[i]); }
};

inline int64_t ulps_apart(double a, double b) {
    const auto ordered = [](double v) {
        const int64_t bits = std::bit_cast<int64_t>(v);
        return bits < 0 ? INT64_MIN - bits : bits;
    };
    return std::abs(ordered(a) - ordered(b));
}

/// Three million sines by both ways: prints the median times of 21 runs and the greatest distance; returns the
/// portable ones.
template <class Backend> std::vector<double> measure_sines(Backend& backend) {
    const uint32_t count = 3'000'000;
    typename Backend::template Buffer<double> angles(backend), sines(backend);
    angles.upload(count, [](uint32_t i) { return double(i) * 3.1e-5 - 20.0; });
    sines.resize(count);
    const auto median_of = [&](const auto& kernel) {
        std::vector<double> times;
        for (int run = 0; run < 21; ++run) {
            typename Backend::Moment begin(backend), end(backend);
            begin.record();
            backend.for_each(count, kernel);
            end.record();
            backend.synchronize();
            times.push_back(end.milliseconds_since(begin));
        }
        std::nth_element(times.begin(), times.begin() + 10, times.end());
        return times[10];
    };
    std::vector<double> library(count), portable(count);
    const double library_ms = median_of(TakeSines<LibrarySine>{angles.view(), sines.view()});
    sines.download(library.data());
    const double portable_ms = median_of(TakeSines<PortableSine>{angles.view(), sines.view()});
    sines.download(portable.data());
    backend.synchronize();
    int64_t apart = 0;
    for (uint32_t i = 0; i < count; ++i)
        apart = std::max(apart, ulps_apart(library[i], portable[i]));
    std::printf("%s: %u sines in double: library %.3f ms, portable %.3f ms (%.2f times); at most %lld ulp apart\n",
                backend.name().c_str(), count, library_ms, portable_ms, portable_ms / library_ms,
                static_cast<long long>(apart));
    return portable;
}

} // namespace proxima::bench
