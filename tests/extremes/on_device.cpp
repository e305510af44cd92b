// SPDX-License-Identifier: Apache-2.0
// Usage: extremes_on_device DEVICE [--scenes FOLDER] [--slow] [TEXT]: every extreme, or those with TEXT in their names,
// on a device ("cuda:0") against the CPU: in float and in double, with the structure that the device chooses and with a
// cloud. Needs no files but the scenes. Ends with a line that begins with PASS or FAIL, and with 0 or 4.
#include "renderer/frame_renderer.h"
#include "renderer/timing.h"
#include "tests/extremes/cases.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>

using namespace proxima;
using namespace proxima::testing;

namespace {

/// How a device's picture differs from the CPU's.
struct Difference {
    static constexpr double most_steps = 1;

    uint64_t ids = 0;        ///< pixels that show another primitive
    uint64_t places = 0;     ///< pixels that show the same one elsewhere: another bit of the depth or of the normal
    uint64_t not_finite = 0; ///< samples
    double steps = 0;        ///< the largest of a sample, in 1/65535 of white, or of itself where it is whiter
    bool same_bits = true;

    bool passes() const { return ids == 0 && places == 0 && not_finite == 0 && steps <= most_steps; }
    std::string text() const {
        if (ids || places)
            return fmt::format("hits {}+{}", ids, places);
        if (not_finite)
            return fmt::format("NaN {}", not_finite);
        return same_bits ? "same" : fmt::format("{:.1e}{}", steps, passes() ? "" : " !");
    }
};

Difference difference(const Image& is, const Image& should) {
    Difference found;
    for (size_t i = 0; i < should.aovs.size(); ++i) {
        const AovSample &a = is.aovs[i], &b = should.aovs[i];
        if (a.id != b.id)
            ++found.ids;
        else
            found.places += a.depth != b.depth || a.normal != b.normal;
    }
    for (size_t i = 0; i < should.rgb.size(); ++i) {
        const double a = is.rgb[i], b = should.rgb[i];
        if (!std::isfinite(a) || !std::isfinite(b))
            ++found.not_finite;
        else
            found.steps = std::max(found.steps, 65535 * std::abs(a - b) / std::max({1.0, std::abs(a), std::abs(b)}));
    }
    found.same_bits = std::memcmp(is.rgb.data(), should.rgb.data(), is.rgb.size() * sizeof(float)) == 0;
    return found;
}

struct Drawn {
    Image image;
    double milliseconds = 0;
};

class Comparison {
public:
    Comparison(std::unique_ptr<FrameRenderer> device, std::filesystem::path scenes)
        : device_(std::move(device)), scenes_(std::move(scenes)) {
        fmt::print("{:<34}{:>12}{:>12}{:>12}{:>12} |{:>10}{:>10}\n", device_->name() + " against the CPU", "float",
                   "cloud", "double", "cloud", "ms float", "CPU's");
    }

    void add(const ExtremeCase& extreme) {
        const SceneProgram scene = read_case(extreme, scenes_);
        std::string row = fmt::format("{:<34}", extreme.name), times;
        for (const Precision precision : {Precision::float32, Precision::float64}) {
            FrameSettings settings;
            settings.width = extreme.width;
            settings.height = extreme.height;
            settings.precision = precision;
            settings.aovs = {.depth = true, .normal = true, .id = true, .steps = false};
            cpu_->set_scene(scene, precision);
            device_->set_scene(scene, precision);
            const Drawn should = draw(*cpu_, settings);
            for (const Accelerator accelerator : {Accelerator::automatic, Accelerator::cloud}) {
                settings.accelerator = accelerator;
                const Drawn is = draw(*device_, settings);
                const Difference found = difference(is.image, should.image);
                row += fmt::format("{:>12}", found.text());
                ++compared_;
                failed_ += !found.passes();
                same_ += found.same_bits;
                if (precision == Precision::float32 && accelerator == Accelerator::automatic)
                    times = fmt::format("{:>10.1f}{:>10.1f}", is.milliseconds, should.milliseconds);
            }
        }
        fmt::print("{} |{}\n", row, times);
        std::fflush(stdout);
    }

    bool passes() const { return compared_ > 0 && failed_ == 0; }
    std::string summary() const {
        return fmt::format("{}: {} pictures; {} differ in a hit or by more than 1/65535; {} have the same bits",
                           passes() ? "PASS" : "FAIL", compared_, failed_, same_);
    }

private:
    static Drawn draw(FrameRenderer& renderer, const FrameSettings& settings) {
        Drawn drawn;
        const Stopwatch stopwatch;
        renderer.render(settings, drawn.image);
        drawn.milliseconds = stopwatch.milliseconds();
        return drawn;
    }

    std::unique_ptr<FrameRenderer> cpu_ = make_cpu_renderer(0), device_;
    std::filesystem::path scenes_;
    uint64_t compared_ = 0, failed_ = 0, same_ = 0;
};

/// "cpu" is for a try without a GPU: then clouds are compared with grids.
std::unique_ptr<FrameRenderer> make_device(const std::string& name) {
    if (name == "cpu")
        return make_cpu_renderer(0);
    int ordinal = 0;
    const char* const end = name.data() + name.size();
    if (!name.starts_with("cuda:") || std::from_chars(name.data() + 5, end, ordinal).ptr != end || name.size() == 5)
        throw std::runtime_error("a device is cpu or cuda:N, not '" + name + "'");
    return make_cuda_renderer(ordinal);
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::string> words;
    std::filesystem::path scenes = PROXIMA_EXTREMES;
    bool slow = false;
    for (int i = 1; i < argc; ++i)
        if (const std::string word = argv[i]; word == "--slow")
            slow = true;
        else if (word == "--scenes" && i + 1 < argc)
            scenes = argv[++i];
        else
            words.push_back(word);
    if (words.empty() || words.size() > 2) {
        std::fputs("usage: extremes_on_device DEVICE [--scenes FOLDER] [--slow] [TEXT]\n", stderr);
        return 2;
    }
    std::string at = "start";
    try {
        Comparison comparison(make_device(words[0]), scenes);
        for (const ExtremeCase& extreme : extreme_cases(slow ? Slowness::all : Slowness::usual))
            if (words.size() < 2 || extreme.name.find(words[1]) != std::string::npos) {
                at = extreme.name;
                comparison.add(extreme);
            }
        fmt::print("{}\n", comparison.summary());
        return comparison.passes() ? 0 : 4;
    } catch (const std::exception& error) {
        fmt::print("FAIL: {}: {}; what comes after it was not tried\n", at, error.what());
        return 4;
    }
}
