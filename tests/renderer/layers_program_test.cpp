// SPDX-License-Identifier: Apache-2.0
// Layers as a user meets them: --aov, and what the file then holds.
#include "tests/renderer/workplace.h"

#include <fmt/format.h>

using namespace proxima::testing;

namespace {

template <class Number> std::vector<Number> channel(const Workplace& work, const std::string& file, const char* name) {
    const auto input = OIIO::ImageInput::open((work.folder / file).string());
    REQUIRE(input);
    const int index = input->spec().channelindex(name);
    REQUIRE_MESSAGE(index >= 0, name);
    std::vector<Number> numbers(size_t(input->spec().width) * size_t(input->spec().height));
    REQUIRE(input->read_image(0, 0, index, index + 1, OIIO::BaseTypeFromC<Number>::value, numbers.data()));
    return numbers;
}

void render(const Workplace& work, const std::vector<std::string>& arguments) {
    const ProcessResult run = work.render(arguments);
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
}

} // namespace

TEST_CASE("layers: an EXR has them beside a picture that is the same as without") {
    const Workplace work("layers_test");
    render(work, {"still.scn", "-o", "plain.exr"});
    render(work, {"still.scn", "-o", "a.exr", "--aov", "depth,normal,id,steps"});
    render(work, {"still.scn", "-o", "b.exr", "--aov", "steps,id,normal,depth", "--threads", "1"});
    CHECK(work.content("a.exr") == work.content("b.exr"));
    for (const char* color : {"R", "G", "B"})
        CHECK(channel<float>(work, "a.exr", color) == channel<float>(work, "plain.exr", color));
    const size_t middle = 12 * 32 + 16, corner = 0;
    const auto depth = channel<float>(work, "a.exr", "Z"), z = channel<float>(work, "a.exr", "N.Z");
    const auto id = channel<uint32_t>(work, "a.exr", "id");
    const auto steps = channel<float>(work, "a.exr", "steps");
    CHECK(depth[middle] == doctest::Approx(2.5).epsilon(0.01));
    CHECK(z[middle] == doctest::Approx(-1).epsilon(0.01));
    CHECK(id[middle] == 1);
    CHECK(depth[corner] == 1e10f);
    CHECK(id[corner] == 0);
    CHECK(steps[middle] == 0); // a single sphere has no grid
    CHECK(work.run({"compare", "a.exr", "plain.exr"}).exit_code == 0);
}

TEST_CASE("layers: what a file holds is known to --skip-existing and to verify") {
    const Workplace work("layers_test");
    const auto with = [](std::vector<std::string> more) {
        more.insert(more.begin(), {"moving.scn", "-o", "a.#.exr", "--frames", "1-3", "--skip-existing"});
        return more;
    };
    render(work, with({"--aov", "depth,steps"}));
    CHECK(says(work.render(with({"--aov", "steps,depth"})).standard_error, "3 of 3 frames are there"));
    CHECK(says(work.render(with({"--aov", "depth"})).standard_error, "0 of 3 frames are there"));
    CHECK(says(work.render(with({"--aov", "depth", "--accel", "grid"})).standard_error, "3 of 3 frames are there"));
    const auto verified = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"verify", "moving.scn", "a.#.exr", "--frames", "1-3", "--size", "32x24"});
        return work.run(more).standard_output;
    };
    CHECK(says(verified({"--aov", "depth"}), "3 of 3 frames are complete"));
    CHECK(says(verified({}), "0 of 3 frames are complete"));
}

TEST_CASE("layers: of a blurred frame they are those of the shutter's middle, by programs and by the script") {
    const Workplace work("layers_test");
    const std::string script = std::string(moving_scene) + "#if (clock < 2) sphere { 9, 0.1 } #end\n";
    work.write("script.scn", script);
    const std::vector<std::string> scenes{"moving.scn", "script.scn"};
    for (const std::string& scene : scenes) {
        CAPTURE(scene);
        const auto frame = [&](const std::string& name, const std::vector<std::string>& more) {
            std::vector<std::string> arguments{scene,      "-o", name + ".#.exr", "--frames", "1-5",
                                               "--subset", "3",  "--aov",         "depth,id"};
            arguments.insert(arguments.end(), more.begin(), more.end());
            render(work, arguments);
        };
        frame("sharp", {});
        frame("blurred", {"--shutter", "-0.5:0.5", "--shutter-samples", "3"});
        CHECK(channel<float>(work, "blurred.0003.exr", "R") != channel<float>(work, "sharp.0003.exr", "R"));
        CHECK(channel<float>(work, "blurred.0003.exr", "Z") == channel<float>(work, "sharp.0003.exr", "Z"));
        CHECK(channel<uint32_t>(work, "blurred.0003.exr", "id") == channel<uint32_t>(work, "sharp.0003.exr", "id"));
    }
}
