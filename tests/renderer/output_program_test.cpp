// SPDX-License-Identifier: Apache-2.0
// Which files a run writes, as a user meets it.
#include "tests/renderer/workplace.h"

#include <fmt/format.h>

using namespace proxima::testing;

TEST_CASE("output: --dry-run prints frames and files, and renders nothing") {
    const Workplace work("output_test");
    const ProcessResult run =
        work.render({"moving.scn", "-o", "a.##.png", "--frames", "1-9", "--shard", "2/4", "--dry-run"});
    CHECK(run.exit_code == 0);
    CHECK(run.standard_output == "2 a.02.png\n6 a.06.png\n");
    CHECK(work.files().empty());
}

TEST_CASE("output: shards give the bytes of a whole run") {
    const Workplace work("output_test");
    REQUIRE(work.render({"moving.scn", "-o", "a.#.png", "--frames", "1-5"}).exit_code == 0);
    for (const char* shard : {"1/3", "2/3", "3/3"})
        REQUIRE(work.render({"moving.scn", "-o", "b.#.png", "--frames", "1-5", "--shard", shard}).exit_code == 0);
    for (int frame = 1; frame <= 5; ++frame)
        CHECK(work.content(fmt::format("a.000{}.png", frame)) == work.content(fmt::format("b.000{}.png", frame)));
    const ProcessResult none = work.render({"moving.scn", "-o", "c.#.png", "--frames", "1-2", "--shard", "3/3"});
    CHECK(none.exit_code == 0);
    CHECK(says(none.standard_error, "nothing to render"));
}

TEST_CASE("output: a GIF holds the whole animation, twice the same") {
    const Workplace work("output_test");
    for (const char* name : {"a.gif", "b.gif"})
        REQUIRE(work.render({"moving.scn", "-o", name, "--frames", "1-6", "--clock", "-0.5:0.5"}).exit_code == 0);
    CHECK(work.files() == std::set<std::string>{"a.gif", "b.gif"});
    CHECK(work.content("a.gif") == work.content("b.gif"));
    const auto input = OIIO::ImageInput::open((work.folder / "a.gif").string());
    REQUIRE(input);
    int count = 0;
    double last = -1; // the ball moves to the right
    for (; input->seek_subimage(count, 0); ++count) {
        const size_t channels = size_t(input->spec().nchannels);
        std::vector<uint8_t> levels(32 * 24 * channels);
        REQUIRE(input->read_image(count, 0, 0, -1, OIIO::TypeDesc::UINT8, levels.data()));
        double sum = 0, weighted = 0;
        for (size_t pixel = 0; pixel < 32 * 24; ++pixel) {
            sum += levels[pixel * channels];
            weighted += double(levels[pixel * channels]) * double(pixel % 32);
        }
        CHECK(weighted / sum > last);
        last = weighted / sum;
    }
    CHECK(count == 6);
}

TEST_CASE("output: a film holds the frames, twice the same") {
    if (run_process({"ffmpeg", "-version"}).exit_code != 0) {
        MESSAGE("skipped: there is no ffmpeg");
        return;
    }
    const Workplace work("output_test");
    for (const char* ending : {"mp4", "webm"}) {
        CAPTURE(ending);
        for (const char* pass : {"a", "b"}) {
            const ProcessResult run = work.render({"moving.scn", "-o", std::string(pass) + ".#.exr", "--frames", "1-6",
                                                   "--fps", "25", "--movie", fmt::format("{}.{}", pass, ending)});
            REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
        }
        CHECK(work.content(std::string("a.") + ending) == work.content(std::string("b.") + ending));
        const ProcessResult probe =
            run_process({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                         "stream=width,height,r_frame_rate,nb_read_frames", std::string("a.") + ending},
                        work.folder);
        for (const char* line : {"width=32", "height=24", "r_frame_rate=25/1", "nb_read_frames=6"})
            CHECK_MESSAGE(says(probe.standard_output, line), probe.standard_output);
    }
}

TEST_CASE("output: a film that cannot be made is refused before anything is rendered") {
    const Workplace work("output_test");
    const auto film = [&](const char* name) {
        return std::vector<std::string>{"moving.scn", "-o", "a.#.png", "--frames", "1-2", "--movie", name};
    };
    const ProcessResult missing = work.render(film("a.mp4"), {"env", "PATH=/nowhere"});
    CHECK(missing.exit_code == 2);
    CHECK(says(missing.standard_error, "--movie a.mp4: there is no ffmpeg; install it"));
    CHECK(work.render(film("a.avi")).exit_code == 2);
    CHECK(work.render(film("missing/a.mp4")).exit_code == (run_process({"ffmpeg", "-version"}).exit_code == 0 ? 3 : 2));
    CHECK(work.files().empty());
}
