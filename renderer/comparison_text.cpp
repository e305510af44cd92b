// SPDX-License-Identifier: Apache-2.0
#include "renderer/comparison_text.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace proxima {
namespace {

/// A sample in the words of its scale.
std::string sample_text(float sample, double white) {
    return white == 1 || !std::isfinite(sample) ? fmt::format("{:.6g}", sample) : fmt::format("{}", sample);
}

std::string pixel_text(const WorstPixel& pixel, double white) {
    const auto values = [&](const std::vector<float>& samples) {
        std::vector<std::string> texts;
        for (const float sample : samples)
            texts.push_back(sample_text(sample, white));
        return fmt::format("({})", fmt::join(texts, ", "));
    };
    return fmt::format("x {}, y {}: A {}, B {}", pixel.x, pixel.y, values(pixel.a), values(pixel.b));
}

std::string error_text(double error, double white) {
    if (white == 1)
        return fmt::format("{:.6g}", error);
    return fmt::format("{:.6g} ({:.4g} of {})", error, error * white, white);
}

std::string psnr_text(const std::optional<double>& psnr) {
    return psnr ? fmt::format("{:.2f} dB", *psnr) : "- (equal)";
}

std::string ssim_text(const std::optional<double>& ssim) {
    return ssim ? fmt::format("{:.6f}", *ssim) : "- (under 11 pixels a side)";
}

} // namespace

std::string full_text(const PairRecord& pair, double tolerance) {
    const ImageFigures& figures = *pair.figures;
    std::string text = fmt::format("A: {}\nB: {}\n", pair.a, pair.b);
    const auto line = [&](const char* what, const std::string& value) {
        text += fmt::format("  {:<14}{}\n", what, value);
    };
    line("size", fmt::format("{} x {}, {} channels", pair.width, pair.height, pair.channels));
    line("compared", pair.rule);
    if (!pair.ignored_channels.empty())
        line("not compared", fmt::format("channels {}", fmt::join(pair.ignored_channels, ", ")));
    line("not finite", fmt::format("{} pixels in A, {} in B", figures.non_finite_a, figures.non_finite_b));
    line("max error", error_text(figures.max_error, pair.white));
    line("RMS error", error_text(figures.rms_error, pair.white));
    line("PSNR", psnr_text(figures.psnr));
    line("SSIM", ssim_text(figures.ssim));
    line("over",
         fmt::format("{} of {} pixels ({:.4f} %), tolerance {}", figures.pixels_over, figures.pixels,
                     100 * double(figures.pixels_over) / double(figures.pixels), error_text(tolerance, pair.white)));
    if (figures.worst)
        line("worst pixel", pixel_text(*figures.worst, pair.white));
    return text + to_string(pair.verdict) + '\n';
}

std::string short_text(const PairRecord& pair) {
    if (!pair.figures)
        return fmt::format("{:<24} {}: {}\n", pair.name, to_string(pair.verdict), pair.reason);
    const ImageFigures& figures = *pair.figures;
    return fmt::format("{:<24} {:<9}  max {:<12.6g} rms {:<12.6g} ssim {:<8}  over {:.4f} %{}\n", pair.name,
                       to_string(pair.verdict), figures.max_error, figures.rms_error,
                       figures.ssim ? fmt::format("{:.6f}", *figures.ssim) : "-",
                       100 * double(figures.pixels_over) / double(figures.pixels),
                       figures.non_finite_a + figures.non_finite_b > 0
                           ? fmt::format("  not finite {}, {}", figures.non_finite_a, figures.non_finite_b)
                           : "");
}

} // namespace proxima
