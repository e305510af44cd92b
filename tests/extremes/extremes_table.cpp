// SPDX-License-Identifier: Apache-2.0
// Usage: extremes_table [--slow] [TEXT]: every extreme, or those with TEXT in their names, in double, in float, in
// float with its automatic help, and by POV-Ray where that is installed. Prints a table, and writes it to extremes.txt
// and the pictures to extremes.png. --slow adds 50 million spheres in
// one voxel.
#include "renderer/float_fit.h"
#include "renderer/povray_run.h"
#include "renderer/timing.h"
#include "tests/extremes/cases.h"
#include "tests/extremes/contact_sheet.h"
#include "tests/extremes/figures.h"

#include <cstdio>
#include <fmt/format.h>
#include <fstream>

using namespace proxima;
using namespace proxima::testing;

namespace {

struct Drawn {
    Image image;
    HitFigures hits;
    double milliseconds = 0;
};

Drawn draw(const SceneProgram& scene, FrameSettings settings, Precision precision, const Reference& reference) {
    settings.precision = precision;
    Drawn drawn;
    const Stopwatch stopwatch;
    drawn.image = render_scene(scene, settings);
    drawn.milliseconds = stopwatch.milliseconds();
    drawn.hits = compare_hits(reference, probe(scene, settings), scene);
    return drawn;
}

/// None without POV-Ray, or where it refuses the scene.
std::optional<Image> draw_by_povray(const ExtremeCase& extreme) {
    SceneOptions options;
    options.scene = std::filesystem::path(PROXIMA_EXTREMES) / extreme.scene;
    options.declares = extreme.declares;
    options.width = extreme.width;
    options.height = extreme.height;
    try {
        const StoredImage stored = render_with_povray(options, {}, 0, 300);
        Image image;
        image.fit(extreme.width, extreme.height);
        for (size_t i = 0; i < image.rgb.size(); ++i)
            image.rgb[i] = stored.samples[i] / 65535;
        return image;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", extreme.name.c_str(), error.what());
        return std::nullopt;
    }
}

std::string percent(double share) {
    return fmt::format("{:.2f}", 100 * share);
}

class Study {
public:
    Study() {
        line(fmt::format("{:<32}{:>9} | {:^61} | {:^32} | {:^8}", "", "double", "float, by name", "automatic",
                         "POV-Ray"));
        line(fmt::format("{:<32}{:>9} | {:>6}{:>6}{:>9}{:>9}{:>8}{:>8}{:>15} | {:<7}{:>6}{:>9}{:>10} | {:>8}", "", "ms",
                         "other", "wrong", "rms/r", "pixels", "equal %", "levels %", "ms", "", "wrong", "pixels",
                         "levels %", "levels %"));
    }

    void add(const ExtremeCase& extreme) {
        const SceneProgram scene = read_case(extreme);
        FrameSettings settings;
        settings.width = extreme.width;
        settings.height = extreme.height;
        const Reference reference = reference_hits(scene, settings);
        const FloatFit fit = float_fit(scene, extreme.width);
        const Precision chosen = chosen_precision(Precision::automatic, fit.holds());
        const Drawn exact = draw(scene, settings, Precision::float64, reference);
        const Drawn single = draw(scene, settings, Precision::float32, reference);
        const Drawn& helped = chosen == Precision::float64 ? exact : single;
        const bool fits_povray = scene.spheres.size() < 10'000'000; // in memory
        const std::optional<Image> other = fits_povray ? draw_by_povray(extreme) : std::nullopt;
        const LevelFigures levels = compare_levels(exact.image, helped.image);
        const uint64_t not_finite = levels.not_finite + compare_levels(single.image, single.image).not_finite;
        const std::string by_povray = other ? percent(compare_levels(exact.image, *other).within_one) : "-";
        const LevelFigures by_name = compare_levels(exact.image, single.image);
        line(fmt::format(
            "{:<32}{:>9.1f} | {:>6}{:>6}{:>9.1e}{:>9.1e}{:>8}{:>8}{:>15.1f} | {:<7}{:>6}{:>9.1e}{:>10} | {:>8}{}",
            extreme.name, exact.milliseconds, single.hits.other, single.hits.wrong, single.hits.rms_over_radius,
            single.hits.most_pixels, percent(by_name.equal), percent(by_name.within_one), single.milliseconds,
            chosen == Precision::float64 ? "double" : "float", helped.hits.wrong, helped.hits.most_pixels,
            percent(levels.within_one), by_povray,
            not_finite ? fmt::format("  {} samples are not finite", not_finite) : ""));
        if (extreme.width > 1000)
            return;
        rows_.push_back({extreme.name,
                         {{exact.image, ""},
                          {single.image, fmt::format("{} wrong", single.hits.wrong)},
                          {helped.image, chosen == Precision::float64 ? "double" : "float"},
                          {other, other ? by_povray + " % of levels" : "none"}}});
    }

    void write() const {
        std::ofstream("extremes.txt") << text_;
        write_contact_sheet("extremes.png", {"double", "float by name", "automatic", "POV-Ray"}, rows_, 128);
    }

private:
    void line(const std::string& text) {
        std::printf("%s\n", text.c_str());
        std::fflush(stdout);
        text_ += text + '\n';
    }

    std::string text_;
    std::vector<SheetRow> rows_;
};

} // namespace

int main(int argc, char** argv) {
    std::string wanted;
    bool slow = false;
    for (int i = 1; i < argc; ++i)
        if (std::string(argv[i]) == "--slow")
            slow = true;
        else
            wanted = argv[i];
    Study study;
    for (const ExtremeCase& extreme : extreme_cases(slow ? Slowness::all : Slowness::usual))
        if (extreme.name.find(wanted) != std::string::npos)
            study.add(extreme);
    study.write();
}
