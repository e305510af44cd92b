// SPDX-License-Identifier: Apache-2.0
// Motion blur, which POV-Ray does not have, against the mean of its frames.
#include "tests/povray/programs.h"

#include "tests/process.h"

#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

constexpr int width = 160, height = 120;

void must_succeed(const std::vector<std::string>& command) {
    const ProcessResult run = run_process(command, ".", 300);
    if (run.exit_code != 0)
        throw std::runtime_error(fmt::format("{} ended with {}:\n{}", command[0], run.exit_code, run.standard_error));
}

} // namespace

TEST_CASE("povray: a blurred frame is the mean of POV-Ray's frames at its moments") {
    const fs::path scene = fs::absolute("blur.scn");
    const std::string text = "#version 3.7;\n"
                             "global_settings { assumed_gamma 1 }\n"
                             "camera { location <2*clock, 1, -5> look_at 0 angle 40 }\n"
                             "light_source { <-5, 8-clock, -5>, rgb 1 }\n"
                             "plane { y, -1 pigment { checker rgb 0.8 rgb <0.2, clock, 0.3> } }\n"
                             "#for (I, 1, 9) sphere { <sin(I+3*clock), cos(I), sin(I*clock)>, 0.3\n"
                             "  pigment { rgb <I/9, 0.4, clock> } finish { reflection 0.2 } } #end\n";
    constexpr int samples = 5, frame = 2, frames = 4;
    for (const char* control : {"", "#if (clock < 0.4) sphere { <0, 1.2, 0>, 0.2 } #end\n"}) {
        CAPTURE(std::string(control));
        std::ofstream(scene) << text << control;
        must_succeed({PROXIMA_PROGRAM,
                      "render",
                      scene.string(),
                      "-o",
                      "blur.##.png",
                      "--frames",
                      "1-4",
                      "--subset",
                      std::to_string(frame),
                      "--shutter",
                      "-0.25:0.5",
                      "--shutter-samples",
                      std::to_string(samples),
                      "--size",
                      "160x120",
                      "--tolerances",
                      "povray",
                      "--precision",
                      "double",
                      "--bits",
                      "16",
                      "--view",
                      "Raw",
                      "--device",
                      "cpu"});
        std::vector<double> sum;
        Picture16 mean;
        for (int i = 0; i < samples; ++i) {
            const double steps = -0.25 + 0.75 * (i + 0.5) / samples;
            const float clock = float((frame - 1 + steps) / (frames - 1));
            Shot shot{.scene = scene, .width = width, .height = height};
            shot.povray_options = {fmt::format("+K{:.9g}", clock)};
            mean = povray_picture(shot, "blur.povray.png");
            sum.resize(mean.rgb.size());
            for (size_t k = 0; k < sum.size(); ++k)
                sum[k] += mean.rgb[k];
        }
        for (size_t k = 0; k < sum.size(); ++k)
            mean.rgb[k] = uint16_t(std::lround(sum[k] / samples));
        const Difference difference = compare(mean, read_picture16("blur.02.png"), 2);
        CHECK_MESSAGE(difference.over.empty(), difference.over.size() << " pixels, by " << difference.largest);
    }
}
