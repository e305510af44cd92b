// SPDX-License-Identifier: Apache-2.0
// The logic of the choice between grid and cloud, with frames that take what the test says.
#include "renderer/device_costs.h"
#include "renderer/shared_method_choice.h"

#include <doctest/doctest.h>
#include <string>
#include <thread>
#include <vector>

using namespace proxima;

namespace {

constexpr uint64_t many = 100'000;

/// Build and map take nothing, and a ray takes a nanosecond by grid.
DeviceCosts flat_costs(double cloud_ray) {
    DeviceCosts costs{.of = {}, .fewest = 1000};
    costs.of.grid.ray = 1;
    costs.of.cloud.ray = cloud_ray;
    return costs;
}

EmptySpace space() {
    return {many, 1000, 900, 3.0};
}

FrameSettings picture(uint32_t width = 640) {
    FrameSettings settings;
    settings.width = width;
    return settings;
}

/// A device whose frames take `ms`, and its workers.
struct Device {
    MethodChoice choice;
    OfMethods<double> ms;
    FrameSettings settings = picture();
    OfMethods<uint64_t> warm{};
    uint32_t looks = 0;

    Device(double predicted_ratio, OfMethods<double> times) : choice(flat_costs(predicted_ratio)), ms(times) {}

    MethodChoice::Frame begin() {
        MethodChoice::Frame frame = choice.begin(settings, many);
        if (frame.looks) {
            ++looks;
            choice.see(frame, space());
        }
        return frame;
    }
    void end(const MethodChoice::Frame& frame, OfMethods<uint64_t>& worker) {
        choice.end(frame, ms[frame.method], worker[frame.method] == frame.epoch && !frame.looks);
        worker[frame.method] = frame.epoch;
    }
    MethodChoice::Frame render() {
        const MethodChoice::Frame frame = begin();
        end(frame, warm);
        return frame;
    }
    /// A letter a frame: g and c, capitals in trials.
    std::string render(int frames) {
        std::string letters;
        for (int i = 0; i < frames; ++i) {
            const MethodChoice::Frame frame = render();
            const bool is_trial = frame.record.reason == MethodReason::trial;
            letters += frame.method == SearchMethod::grid ? (is_trial ? 'G' : 'g') : (is_trial ? 'C' : 'c');
        }
        return letters;
    }
};

std::string times(int count, char letter) {
    return std::string(size_t(count), letter);
}

} // namespace

TEST_CASE("method choice: a clear prior is taken, and nothing is tried") {
    CHECK(Device(2.1, {1, 0.1}).render(300) == times(300, 'g'));
    CHECK(Device(0.45, {1, 10}).render(300) == times(300, 'c'));
}

TEST_CASE("method choice: a prior that is not clear says the first frames, and a trial the others") {
    // The first frame by a method is not timed; then four are, and three of a trial.
    CHECK(Device(1.2, {1, 0.8}).render(40) == "gggggCCCC" + times(31, 'c'));
    CHECK(Device(1.2, {1, 1.3}).render(40) == "gggggCCCC" + times(31, 'g'));
    CHECK(Device(0.8, {1, 1.3}).render(40) == "cccccGGGG" + times(31, 'g'));
    SUBCASE("what is better or worse by far is timed once") {
        CHECK(Device(1.2, {1, 0.4}).render(40) == "gggggCC" + times(33, 'c'));
        CHECK(Device(1.2, {1, 2.2}).render(40) == "gggggCC" + times(33, 'g'));
    }
    SUBCASE("a still, and the first frame of an animation, go by the prior") {
        CHECK(Device(1.2, {1, 0.1}).render().record.reason == MethodReason::prior);
    }
}

TEST_CASE("method choice: a method takes over when it is better by more than the hysteresis") {
    CHECK(Device(1.2, {1, 0.96}).render(40).back() == 'g');
    CHECK(Device(1.2, {1, 0.94}).render(40).back() == 'c');
    CHECK(Device(0.8, {0.96, 1}).render(40).back() == 'c');
}

TEST_CASE("method choice: the least of the timed frames counts") {
    Device device(1.2, {1, 0.8});
    CHECK(device.render(6) == "gggggC");
    device.ms.cloud = 1.4; // something came in between
    CHECK(device.render(2) == "CC");
    device.ms.cloud = 0.8;
    CHECK(device.render(2) == "Cc");
    SUBCASE("of the method in use, too") {
        Device other(1.2, {1.9, 1.4});
        CHECK(other.render(4) == "gggg");
        other.ms.grid = 1; // by now nothing comes in between
        CHECK(other.render(36).back() == 'g');
    }
}

TEST_CASE("method choice: trials are repeated ever more rarely while they have the same outcome") {
    Device device(1.2, {1, 1.3});
    const std::string letters = device.render(6000);
    std::vector<size_t> starts;
    for (size_t i = 1; i < letters.size(); ++i)
        if (letters[i] == 'C' && letters[i - 1] == 'g')
            starts.push_back(i);
    REQUIRE(starts.size() >= 7);
    const size_t intervals[] = {64, 128, 256, 512, 1024, 1024};
    for (size_t i = 0; i < 6; ++i)
        CHECK(starts[i + 1] - starts[i] - (i == 0 ? 4 : 3) == intervals[i]); // from its end on; first with a cold frame
    SUBCASE("another outcome starts the intervals anew") {
        device.ms.cloud = 0.8;
        std::string more = device.render(1200);
        const size_t changed = more.find('c');
        REQUIRE(changed != std::string::npos);
        more = more.substr(changed);
        CHECK(more.find('G') <= 64);
        CHECK(more.back() == 'c');
    }
    SUBCASE("what was in vain by far is repeated later") {
        Device slow(1.2, {1, 2.2});
        CHECK(slow.render(250).find('C', 10) == std::string::npos);
        CHECK(slow.render(20).find('C') != std::string::npos);
    }
}

TEST_CASE("method choice: it looks at the first frame and every 64 frames, and when a scene may have changed") {
    Device device(3, {1, 3});
    device.render(64);
    CHECK(device.looks == 1);
    device.render(64);
    CHECK(device.looks == 2);
    device.choice.expect_change();
    device.render(1);
    CHECK(device.looks == 3);
}

TEST_CASE("method choice: a prior that moves by much is followed at once") {
    DeviceCosts costs = flat_costs(1);
    costs.of.cloud.brick = 100; // a thousand bricks take 0.1 ms, and the grid's rays 0.31
    MethodChoice choice(costs);
    OfMethods<uint64_t> warm;
    const auto reason_with = [&](uint64_t bricks) {
        EmptySpace seen = space();
        seen.bricks = bricks;
        choice.expect_change();
        MethodChoice::Frame frame = choice.begin(picture(), many);
        choice.see(frame, seen);
        return frame.record.reason;
    };
    for (int i = 0; i < 20; ++i) {
        MethodChoice::Frame frame = choice.begin(picture(), many);
        if (frame.looks)
            choice.see(frame, space());
        choice.end(frame, 1, warm[frame.method] == frame.epoch && !frame.looks);
        warm[frame.method] = frame.epoch;
    }
    CHECK(reason_with(1000) == MethodReason::measured);
    CHECK(reason_with(2000) == MethodReason::measured); // 1.3 to 1.65 times
    CHECK(reason_with(100) == MethodReason::measured);
    CHECK(reason_with(10'000) == MethodReason::prior); // 4.3 times: clear
    CHECK(reason_with(1000) == MethodReason::trial);   // close again
}

TEST_CASE("method choice: a prior that moves by much, and stays close, makes a trial come early") {
    DeviceCosts costs = flat_costs(0.6);
    costs.of.cloud.brick = 100;
    MethodChoice choice(costs);
    uint64_t bricks = 100;
    OfMethods<uint64_t> warm;
    const auto render = [&] {
        EmptySpace seen = space();
        seen.bricks = bricks;
        MethodChoice::Frame frame = choice.begin(picture(), many);
        if (frame.looks)
            choice.see(frame, seen);
        choice.end(frame, 1, warm[frame.method] == frame.epoch && !frame.looks);
        warm[frame.method] = frame.epoch;
        return frame.record.reason;
    };
    for (int i = 0; i < 20; ++i)
        render();
    CHECK(render() == MethodReason::measured);
    bricks = 3000; // 0.63 to 1.58 times
    choice.expect_change();
    CHECK(render() == MethodReason::trial);
}

TEST_CASE("method choice: other settings start anew") {
    Device device(1.2, {1, 0.8});
    CHECK(device.render(10).back() == 'c');
    const uint64_t before = device.render().epoch;
    FrameSettings next = picture();
    const auto starts_anew = [&] {
        device.settings = next;
        const MethodChoice::Frame frame = device.render();
        return frame.epoch != before && frame.record.reason == MethodReason::prior && frame.looks;
    };
    SUBCASE("size") {
        next.width = 320;
        CHECK(starts_anew());
    }
    SUBCASE("samples") {
        next.samples = 4;
        CHECK(starts_anew());
    }
    SUBCASE("antialiasing") {
        next.antialiasing.method = Antialiasing::Method::squares;
        CHECK(starts_anew());
    }
    SUBCASE("precision") {
        next.precision = Precision::float64;
        CHECK(starts_anew());
    }
    SUBCASE("but not layers, bands and halves, which change nothing of that") {
        next.aovs.depth = next.in_halves = true;
        next.rows = {32, 64};
        CHECK_FALSE(starts_anew());
    }
}

TEST_CASE("method choice: many more primitives start anew, and a few never get a cloud") {
    MethodChoice choice(flat_costs(0.1));
    CHECK(choice.begin(picture(), 1000).looks);
    MethodChoice::Frame frame = choice.begin(picture(), 1000);
    choice.see(frame, space());
    CHECK_FALSE(choice.begin(picture(), 1400).looks);
    CHECK(choice.begin(picture(), 1600).looks);
    const MethodChoice::Frame few = choice.begin(picture(), 999);
    CHECK_FALSE(few.looks);
    CHECK(few.method == SearchMethod::grid);
    CHECK(few.record.reason == MethodReason::few);
}

TEST_CASE("method choice: the frames in flight of two workers share what is known") {
    Device device(1.2, {1, 0.8});
    OfMethods<uint64_t> warm[2];
    std::string letters;
    MethodChoice::Frame flying[2] = {device.choice.begin(device.settings, many),
                                     device.choice.begin(device.settings, many)};
    for (MethodChoice::Frame& frame : flying) {
        CHECK(frame.looks); // neither knows anything yet
        device.choice.see(frame, space());
    }
    for (int i = 0; i < 40; ++i) {
        const int worker = i % 2;
        device.end(flying[worker], warm[worker]);
        flying[worker] = device.begin();
        letters += flying[worker].method == SearchMethod::grid ? 'g' : 'c';
    }
    CHECK(device.looks == 0);
    // Both workers' first frames by each method make room, and neither is timed.
    CHECK(letters.substr(0, 5) == "ggggg");
    CHECK(letters.substr(5) == times(35, 'c'));
    CHECK(flying[0].record.reason == MethodReason::measured);
    CHECK(flying[0].record.measured.grid == 1);
    CHECK(flying[0].record.measured.cloud == 0.8);
}

TEST_CASE("method choice: any threads may ask") {
    Device device(1.2, {1, 0.8});
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            OfMethods<uint64_t> warm;
            for (int k = 0; k < 2000; ++k) {
                MethodChoice::Frame frame = device.choice.begin(picture(), many);
                if (frame.looks)
                    device.choice.see(frame, space());
                device.end(frame, warm);
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    CHECK(device.begin().record.measured.cloud == 0.8);
}

TEST_CASE("method choice: what is decided alone does not depend on earlier frames") {
    Device device(1.2, {1, 0.5});
    CHECK(device.render(20).back() == 'c');
    MethodChoice::Frame frame;
    device.choice.decide_alone(frame, picture(), space());
    CHECK(frame.method == SearchMethod::grid);
    CHECK(frame.record.reason == MethodReason::prior);
    CHECK(frame.epoch == 0); // and is not told of to those behind
}

TEST_CASE("method choice: renderers of a device that live together share one") {
    SharedMethodChoice shared(cpu_costs);
    auto one = shared.take();
    CHECK(one == shared.take());
    const std::weak_ptr<MethodChoice> gone = one;
    one.reset();
    CHECK(gone.expired());
    CHECK(shared.take());
}

TEST_CASE("method choice: a look tells full scenes from empty ones") {
    const double rays = 1920 * 1080;
    const EmptySpace full{1'000'000, 500'000, 500, 1.0}, planes{500'000, 257'400, 249'000, 14.8};
    const auto ratio = [&](const DeviceCosts& costs, const EmptySpace& space) {
        const OfMethods<double> ms = predicted_ms(costs, space, rays);
        return ms.cloud / ms.grid;
    };
    CHECK(ratio(cuda_costs, full) > 1.5);
    CHECK(ratio(cuda_costs, planes) < 0.8);
    CHECK(ratio(cpu_costs, full) > 2);
    CHECK(ratio(cpu_costs, planes) < 1.5); // packets walk a grid faster than rays one by one
}
