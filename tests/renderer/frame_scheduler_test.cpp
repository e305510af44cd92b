// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_scheduler.h"
#include "tests/renderer/fake_renderer.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <map>
#include <set>

using namespace proxima;
using proxima::testing::FakeRenderer;

namespace {

using Behavior = FakeRenderer::Behavior;

/// A run of `frames` frames whose scenes are `scene_of(frame)`.
struct Run {
    size_t frames = 20;
    std::function<std::shared_ptr<const SceneProgram>(int64_t)> scene_of;
    std::function<FrameScenes(int64_t)> scenes_of = [this](int64_t frame) {
        return FrameScenes{{scene_of(frame)}, {}};
    };
    std::function<FrameScenes(int64_t)> scenes_by_script = scenes_of;
    std::vector<FrameRecord> records;
    std::map<int64_t, float> pictures; ///< frame -> what its picture shows
    std::map<std::string, int> counts; ///< device -> frames
    std::vector<std::string> notes;
    uint32_t height = 1;
    std::vector<Rows> bands{Rows{}};
    std::function<void(FinishedFrame&)> write = [](FinishedFrame&) {};
    std::vector<std::string> names{}; ///< of the devices; "device 0" and so on without

    Run() {
        scene_of = [](int64_t frame) {
            SceneProgram scene;
            scene.background = glm::vec3(float(frame));
            return std::make_shared<const SceneProgram>(scene);
        };
    }

    void operator()(std::vector<Behavior> devices) {
        const StopSignal stop;
        std::mutex mutex;
        FrameWriter writer(
            frames,
            [&](FinishedFrame& frame) {
                const std::lock_guard lock(mutex);
                write(frame);
                const std::vector<float>& rgb = frame.image.rgb;
                const bool whole = std::all_of(rgb.begin(), rgb.end(), [&](float v) { return v == rgb.at(0); });
                CHECK(whole);
                CHECK(pictures.emplace(frame.record.frame, rgb.at(0)).second); // never twice
            },
            2);
        FrameQueue queue(frames, devices.size(), bands);
        std::thread source([&] {
            for (size_t i = 0; i < frames; ++i)
                if (!queue.push({i, int64_t(i), scenes_of(int64_t(i))}))
                    return;
            queue.end();
        });
        struct Join {
            FrameQueue& queue;
            std::thread& thread;
            ~Join() {
                queue.close();
                thread.join();
            }
        } const join{queue, source};
        std::vector<RenderWorker> workers;
        for (size_t i = 0; i < devices.size(); ++i)
            workers.push_back({names.empty() ? fmt::format("device {}", i) : names[i],
                               std::make_unique<FakeRenderer>(devices[i]),
                               {}});
        FrameSettings small;
        small.width = 2;
        small.height = height;
        FrameScheduler scheduler(queue, writer,
                                 {.settings = small,
                                  .describe =
                                      [](const FrameTask& task) {
                                          FrameRecord record;
                                          record.frame = task.frame;
                                          return record;
                                      },
                                  .note =
                                      [&](const std::string& text) {
                                          const std::lock_guard lock(mutex);
                                          notes.push_back(text);
                                      },
                                  .scenes_by_script = [&](int64_t frame) { return scenes_by_script(frame); }});
        struct Finish {
            Run& run;
            FrameWriter& writer;
            ~Finish() {
                try {
                    run.records = writer.finish();
                } catch (const DeviceError&) { // the run has thrown it, too
                }
                for (const FrameRecord& record : run.records)
                    ++run.counts[record.device];
            }
        } const finish{*this, writer};
        scheduler.run(std::move(workers), stop);
    }

    bool is_complete() const {
        if (records.size() != frames || pictures.size() != frames)
            return false;
        for (size_t i = 0; i < frames; ++i)
            if (records[i].frame != int64_t(i) || pictures.at(int64_t(i)) != float(i))
                return false;
        return true;
    }
};

void lose() {
    throw DeviceError(DeviceError::Kind::lost, "unplugged");
}

} // namespace

TEST_CASE("scheduler: every frame is rendered once, with its own scene, whatever the number of devices") {
    for (const size_t devices : {1, 2, 5}) {
        Run run;
        run.frames = 50;
        run(std::vector<Behavior>(devices));
        CHECK(run.is_complete());
    }
}

TEST_CASE("scheduler: a scene that many frames share is set once on each device") {
    const auto shared = std::make_shared<const SceneProgram>();
    std::atomic<int> scenes_set{0};
    Run run;
    run.scene_of = [&](int64_t) { return shared; };
    run(std::vector<Behavior>(3, Behavior{.milliseconds = 1, .scenes_set = &scenes_set}));
    CHECK(run.records.size() == 20);
    CHECK(scenes_set <= 3);
}

TEST_CASE("scheduler: a frame whose motion is undefined is rendered as the script says it") {
    Run run;
    const auto program = std::make_shared<const SceneProgram>(); // that nobody shall see in frame 3
    const auto by_script = run.scenes_by_script;
    run.scenes_of = [&](int64_t frame) { return frame == 3 ? FrameScenes{{program}, {}} : by_script(frame); };
    run({{.before_frame = [](int frame) {
        if (frame == 3)
            throw MotionUndefined("a sphere");
    }}});
    CHECK(run.is_complete());
    CHECK(run.notes.empty());
}

TEST_CASE("scheduler: a picture of several scenes is their mean, in bands or whole") {
    for (const std::vector<Rows>& bands : {std::vector<Rows>{Rows{}}, std::vector<Rows>{{0, 32}, {32, 8}}}) {
        Run run;
        run.height = 40;
        run.bands = bands;
        run.scenes_of = [&](int64_t frame) {
            FrameScenes scenes;
            for (const double offset : {-1, 0, 1})
                scenes.programs.push_back(run.scene_of(frame + int64_t(offset)));
            return scenes;
        };
        run(std::vector<Behavior>(2));
        CHECK(run.is_complete());
    }
}

TEST_CASE("scheduler: devices get work by what they finish") {
    Run run;
    run.frames = 60;
    run({{.milliseconds = 10}, {.milliseconds = 100}}); // long beside what a busy machine adds
    CHECK(run.is_complete());
    CHECK(run.counts["device 1"] >= 1);
    CHECK(run.counts["device 0"] > 4 * run.counts["device 1"]);
}

TEST_CASE("scheduler: a slow device does not hold up the end of a run") {
    Run run;
    run.frames = 12;
    run({{.milliseconds = 1}, {.milliseconds = 150}});
    CHECK(run.is_complete());
    CHECK(run.counts["device 1"] == 1);
}

TEST_CASE("scheduler: frames of a device that is lost are rendered by the others") {
    for (const int at : {0, 3}) {
        Run run;
        run({{.milliseconds = 1,
              .before_frame =
                  [at](int frame) {
                      if (frame == at)
                          lose();
                  }},
             {.milliseconds = 1}});
        CHECK(run.is_complete());
        CHECK(run.counts["device 0"] == at);
        REQUIRE(run.notes.size() == 1);
        CHECK(run.notes[0].find("device 0: unplugged") != std::string::npos);
    }
}

TEST_CASE("scheduler: a device without memory leaves its frame to the others") {
    Run run;
    run({{.before_frame = [](int) { throw std::bad_alloc(); }}, {}});
    CHECK(run.is_complete());
    REQUIRE(run.notes.size() == 1);
    CHECK(run.notes[0].find("out of memory; frame ") != std::string::npos);
}

TEST_CASE("scheduler: a slow first frame, which starts the device, is not held against it") {
    Run run;
    const Behavior quick{.milliseconds = 2};
    Behavior slow_to_start = quick;
    slow_to_start.before_frame = [](int frame) {
        if (frame == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(60));
    };
    run.frames = 200;
    run({slow_to_start, quick});
    CHECK(run.is_complete());
    CHECK(run.counts["device 0"] > 40);
}

TEST_CASE("scheduler: with no device left the run ends, and what is finished is whole") {
    Run run;
    const Behavior dying{.before_frame = [](int frame) {
        if (frame == 4)
            lose();
    }};
    CHECK_THROWS_WITH_AS(run({dying, dying}), "unplugged", DeviceError);
    CHECK(run.records.size() == 8);
}

TEST_CASE("scheduler: a scene that cannot be rendered ends the run at once") {
    Run run;
    CHECK_THROWS_AS(run({{.before_frame = [](int) { throw DeviceError(DeviceError::Kind::scene, "too deep"); }}, {}}),
                    DeviceError);
}

TEST_CASE("scheduler: bands make whole frames, whoever renders them") {
    for (const size_t devices : {1, 2, 3}) {
        Run run;
        run.height = 200;
        run.bands = cut_into_bands(200, devices);
        run(std::vector<Behavior>(devices, Behavior{.milliseconds = 0.5}));
        CHECK(run.is_complete());
        for (const FrameRecord& record : run.records)
            CHECK(record.statistics.trace_ms == double(run.bands.size()));
    }
}

TEST_CASE("scheduler: a band of a device that is lost is rendered by the others, and what it finished counts") {
    for (const int at : {0, 1, 5}) {
        Run run;
        run.height = 200;
        run.bands = cut_into_bands(200, 2);
        const Behavior dying{.milliseconds = 1, .before_frame = [at](int frame) {
                                 if (frame == at)
                                     lose();
                             }};
        run({dying, {.milliseconds = 1}});
        CHECK(run.is_complete());
        REQUIRE(run.notes.size() == 1);
        CHECK(run.notes[0].find("device 0: unplugged") != std::string::npos);
    }
}

TEST_CASE("scheduler: a device out of memory goes on with as many rows as fit, and says so once") {
    for (const bool banded : {false, true}) {
        Run run;
        run.height = 1000;
        if (banded)
            run.bands = cut_into_bands(Rows{0, 1000}, 512);
        run({{.most_rows = 100}});
        CHECK(run.is_complete());
        REQUIRE(run.notes.size() == 1);
        CHECK(run.notes[0] == fmt::format("device 0: out of memory; goes on in tiles of {} rows", banded ? 32 : 64));
    }
}

TEST_CASE("scheduler: a grid that is coarser than it was to be is told of once") {
    Run run;
    run({{.milliseconds = 1}, {.milliseconds = 1, .coarse = true}});
    REQUIRE(run.notes.size() == 1);
    CHECK(run.notes[0] == "device 1: the grid has 20x10x5 voxels instead of 40x20x10: the memory that is free holds "
                          "lists of about 1000; frames may take longer");
}

TEST_CASE("scheduler: a picture that does not fit in the smallest tiles either goes to another device") {
    Run run;
    run.height = 300;
    run({{.most_rows = 31}, {.milliseconds = 1}});
    CHECK(run.is_complete());
    CHECK(run.counts["device 0"] == 0);
    Run none;
    none.height = 300;
    CHECK_THROWS_WITH_AS(none({{.most_rows = 31}}), "out of memory", DeviceError);
}

TEST_CASE("scheduler: with memory for one frame, a device has one in flight") {
    Run run;
    run.height = 300;
    run.names = {"gpu", "gpu"};
    run({{.milliseconds = 1, .most_rows = 100}, {.milliseconds = 1}});
    CHECK(run.is_complete());
    REQUIRE(run.notes.size() == 1);
    CHECK(run.notes[0].find("gpu: out of memory; frame ") != std::string::npos);
    Run both;
    both.height = 300;
    both.names = {"gpu", "gpu"};
    both({{.most_rows = 100}, {.most_rows = 100}}); // the last one tries tiles
    CHECK(both.is_complete());
    CHECK(both.notes.size() == 2);
}

TEST_CASE("scheduler: what cannot be written ends the run, and no device is blamed") {
    Run run;
    run.write = [](FinishedFrame&) { throw DeviceError(DeviceError::Kind::lost, "while encoding"); };
    CHECK_THROWS_WITH_AS(run({{}, {}}), "while encoding", DeviceError);
    CHECK(run.notes.empty());
}
