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

TEST_CASE("output: --skip-existing keeps what is whole and right, and makes the rest anew") {
    const Workplace work("output_test");
    const auto arguments = [](const std::string& ending) {
        return std::vector<std::string>{"moving.scn", "-o", "a.#." + ending, "--frames", "1-4"};
    };
    for (const char* ending : {"exr", "png", "tif", "jpg"}) {
        CAPTURE(ending);
        const auto name = [&](int frame) { return fmt::format("a.000{}.{}", frame, ending); };
        REQUIRE(work.render(arguments(ending)).exit_code == 0);
        std::vector<std::string> before;
        for (int frame = 1; frame <= 4; ++frame)
            before.push_back(work.content(name(frame)));

        auto again = arguments(ending);
        again.push_back("--skip-existing");
        CHECK(says(work.render(again).standard_error, "4 of 4 frames are there"));
        fs::remove(work.folder / name(1));
        work.write(name(2), before[1].substr(0, before[1].size() / 2));
        work.write(name(3), before[3]); // whole, but another frame
        const ProcessResult run = work.render(again);
        CHECK(run.exit_code == 0);
        CHECK(says(run.standard_error, "1 of 4 frames are there"));
        CHECK(says(run.standard_error, "(3 of 3, "));
        for (int frame = 1; frame <= 4; ++frame)
            CHECK(work.content(name(frame)) == before[size_t(frame - 1)]);

        again.insert(again.end(), {"--samples", "4"});
        CHECK(says(work.render(again).standard_error, "0 of 4 frames are there"));
        CHECK(work.content(name(1)) != before[0]);
        for (int frame = 1; frame <= 4; ++frame)
            fs::remove(work.folder / name(frame));
    }
}

TEST_CASE("output: --skip-existing notices another scene, not another text") {
    const Workplace work("output_test");
    const std::vector<std::string> again{"moving.scn", "-o", "a.#.exr", "--frames", "1-3", "--skip-existing"};
    REQUIRE(work.render(again).exit_code == 0);
    work.write("moving.scn", std::string(moving_scene) + "// a remark\n");
    CHECK(says(work.render(again).standard_error, "3 of 3 frames are there"));
    std::string other = moving_scene;
    other.replace(other.find("0.3"), 3, "0.4");
    work.write("moving.scn", other);
    CHECK(says(work.render(again).standard_error, "0 of 3 frames are there"));
    work.write("data.inc", "#declare Radius = 0.5;");
    other.replace(other.find("0.5"), 3, "Radius");
    work.write("moving.scn", "#include \"data.inc\"\n" + other);
    CHECK(says(work.render(again).standard_error, "3 of 3 frames are there"));
    work.write("data.inc", "#declare Radius = 0.6;");
    CHECK(says(work.render(again).standard_error, "0 of 3 frames are there"));
}

TEST_CASE("output: verify lists what is missing, corrupt or foreign") {
    const Workplace work("output_test");
    const std::vector<std::string> verify{"verify", "moving.scn", "a.#.exr", "--frames", "1-5", "--size", "32x24"};
    REQUIRE(work.render({"moving.scn", "-o", "a.#.exr", "--frames", "1-5"}).exit_code == 0);
    const ProcessResult right = work.run(verify);
    CHECK(right.exit_code == 0);
    CHECK(right.standard_output == "5 of 5 frames are complete\n");

    fs::remove(work.folder / "a.0001.exr");
    work.write("a.0002.exr", work.content("a.0002.exr").substr(0, 700));
    fs::copy_file(work.folder / "a.0005.exr", work.folder / "a.0003.exr", fs::copy_options::overwrite_existing);
    REQUIRE(work.render({"still.scn", "-o", "a.0004.exr", "--samples", "2"}).exit_code == 0);
    const ProcessResult wrong = work.run(verify);
    CHECK(wrong.exit_code == 4);
    for (const char* line :
         {"missing frame 1, a.0001.exr: ", "corrupt frame 2, a.0002.exr: ", "foreign frame 3, a.0003.exr: ",
          "foreign frame 4, a.0004.exr: ", "1 of 5 frames are complete"})
        CHECK_MESSAGE(says(wrong.standard_output, line), wrong.standard_output);
    CHECK(says(wrong.standard_error, "4 of 5 frames are not what moving.scn makes"));

    auto by_cuda = verify;
    by_cuda.insert(by_cuda.end(), {"--device", "cuda"});
    CHECK(says(work.run(by_cuda).standard_output, "0 of 5 frames are complete"));
    CHECK(work.run({"verify", "moving.scn", "a.gif", "--frames", "1-5"}).exit_code == 2);
    CHECK(work.run({"verify", "moving.scn"}).exit_code == 2);
}

TEST_CASE("output: a film of a run that was finished in parts") {
    if (run_process({"ffmpeg", "-version"}).exit_code != 0) {
        MESSAGE("skipped: there is no ffmpeg");
        return;
    }
    const Workplace work("output_test");
    const std::vector<std::string> whole{"moving.scn", "-o",      "a.#.png", "--frames",
                                         "1-6",        "--movie", "a.mp4",   "--skip-existing"};
    auto part = whole;
    part.insert(part.end(), {"--shard", "1/2"});
    CHECK(says(work.render(part).standard_error, "run once more with --skip-existing --movie a.mp4"));
    REQUIRE(work.render({"moving.scn", "-o", "a.#.png", "--frames", "1-6", "--shard", "1/2"}).exit_code == 0);
    REQUIRE(work.render(whole).exit_code == 0);
    REQUIRE(work.render({"moving.scn", "-o", "b.#.png", "--frames", "1-6", "--movie", "b.mp4"}).exit_code == 0);
    CHECK(work.content("a.mp4") == work.content("b.mp4"));
}

TEST_CASE("output: the colours that can be chosen are listed without a scene") {
    const Workplace work("output_test");
    const ProcessResult run = work.run({"render", "--list-colorspaces"});
    CHECK(run.exit_code == 0);
    CHECK(says(run.standard_output, "sRGB: Un-tone-mapped"));
}

TEST_CASE("output: EXR is scene-linear unless a colour space is asked for") {
    const Workplace work("output_test");
    OIIO::ImageSpec spec;
    REQUIRE(work.render({"still.scn", "-o", "a.exr", "--colorspace", "ACEScg", "--bits", "float"}).exit_code == 0);
    work.corner("a.exr", &spec);
    CHECK(spec.get_string_attribute("colorInteropID") == "lin_ap1_scene");
    REQUIRE(work.render({"still.scn", "-o", "b.exr", "--working-space", "acescg"}).exit_code == 0);
    work.corner("b.exr", &spec);
    CHECK(spec.get_string_attribute("colorInteropID") == "lin_ap1_scene");
    CHECK(work.render({"still.scn", "-o", "c.exr", "--look", "x"}).exit_code == 2);
    CHECK(work.render({"still.scn", "-o", "c.exr", "--colorspace", "x"}).exit_code == 2);
    CHECK(work.render({"still.scn", "-o", "c.png", "--colorspace", "ACEScg", "--view", "Raw"}).exit_code == 2);
}

TEST_CASE("output: the report shows every frame, and needs no network") {
    const Workplace work("output_test");
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"moving.scn", "--frames", "1-5", "--report", "report"});
        return work.render(more);
    };
    REQUIRE(run({"-o", "a.#.exr"}).exit_code == 0);
    for (int frame = 1; frame <= 5; ++frame)
        CHECK(fs::exists(work.folder / fmt::format("report/pictures/{}.png", frame)));
    const std::string page = work.content("report/index.html");
    CHECK_FALSE(says(page, "src=\"http"));
    CHECK_FALSE(says(page, "/*RUN*/"));
    CHECK(says(page, "\"hash\""));

    const auto rendered = [&] { // what a browser makes of it
        return run_process({"chromium", "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=5000",
                            "--dump-dom", "file://" + (work.folder / "report/index.html").string()},
                           work.folder, 120);
    };
    if (run_process({"chromium", "--version"}).exit_code != 0) {
        MESSAGE("skipped: there is no chromium to open the page in");
        return;
    }
    const ProcessResult right = rendered();
    REQUIRE(right.exit_code == 0);
    CHECK(says(right.standard_output, "<h1>5 frames of moving.scn</h1>"));
    CHECK(says(right.standard_output, "src=\"pictures/5.png\""));
    CHECK(says(right.standard_output, "<td>cpu: 5</td>"));
    CHECK_FALSE(says(right.standard_output, "<h2>The run ended early</h2>"));

    // Frames that were there are shown too, from their files.
    const auto dots = [&](int frame) { return work.content(fmt::format("report/pictures/{}.png", frame)); };
    const std::string fifth = dots(5);
    fs::remove_all(work.folder / "report");
    fs::remove(work.folder / "a.0005.exr");
    REQUIRE(run({"-o", "a.#.exr", "--skip-existing"}).exit_code == 0);
    CHECK(dots(5) == fifth);
    CHECK_FALSE(dots(4).empty());
    const ProcessResult resumed = rendered();
    CHECK(says(resumed.standard_output, "<h1>5 frames of moving.scn</h1>"));
    CHECK(says(resumed.standard_output, "<b>1</b><span class=\"soft\">frames made</span>"));
    CHECK(says(resumed.standard_output, "<b>4</b><span class=\"soft\">were there</span>"));
    CHECK(says(resumed.standard_output, "4: was there"));
    for (int frame = 1; frame <= 5; ++frame)
        CHECK(says(resumed.standard_output, fmt::format("src=\"pictures/{}.png\"", frame)));
    REQUIRE(run({"-o", "a.#.exr", "--skip-existing"}).exit_code == 0); // nothing is left to do
    CHECK(says(rendered().standard_output, "<b>5</b><span class=\"soft\">were there</span>"));

    // A frame that cannot be written.
    fs::create_directory(work.folder / "a.0003.png");
    CHECK(run({"-o", "a.#.png"}).exit_code == 3);
    const ProcessResult wrong = rendered();
    CHECK(says(wrong.standard_output, "<h2>The run ended early</h2>"));
    CHECK(says(wrong.standard_output, "a.0003.png: cannot be written"));
}
