// SPDX-License-Identifier: Apache-2.0
#include "renderer/errors.h"
#include "renderer/fault_plan.h"

#include <doctest/doctest.h>

using namespace proxima;
using Kind = DeviceError::Kind;

TEST_CASE("faults: a list is read") {
    CHECK(parse_faults("").empty());
    CHECK(parse_faults("gpu-lost@frame7:trace") == std::vector<Fault>{{Kind::lost, 7, FrameStep::trace}});
    CHECK(parse_faults("out-of-memory@frame9:build:cuda:1*3,gpu-lost@frame-2:read-back*2") ==
          std::vector<Fault>{{Kind::out_of_memory, 9, FrameStep::build, "cuda:1", 3},
                             {Kind::lost, -2, FrameStep::read_back, "", 2}});
    for (const char* name : frame_step_names)
        CHECK_NOTHROW(parse_faults(std::string("gpu-lost@frame1:") + name));
}

TEST_CASE("faults: what is none is refused") {
    for (const char* text : {"gpu-lost", "gpu-lost@7:trace", "lost@frame7:trace", "gpu-lost@frame7:tracing",
                             "gpu-lost@frame:trace", "gpu-lost@frame7:trace*0", "gpu-lost@frame7:trace*", ","})
        CHECK_THROWS_AS(parse_faults(text), UsageError);
}

TEST_CASE("faults: each strikes at its step of its frame, on its device, as often as it says") {
    FaultPlan plan(parse_faults("gpu-lost@frame7:trace*2,out-of-memory@frame8:map:cpu#2"));
    CHECK_NOTHROW(plan.strike("cpu", 7, FrameStep::build));
    CHECK_NOTHROW(plan.strike("cpu", 6, FrameStep::trace));
    for (int i = 0; i < 2; ++i)
        CHECK_THROWS_AS(plan.strike("cpu", 7, FrameStep::trace), DeviceError);
    CHECK_NOTHROW(plan.strike("cpu", 7, FrameStep::trace));
    CHECK_NOTHROW(plan.strike("cpu", 8, FrameStep::map));
    CHECK_THROWS_AS(plan.strike("cpu#2", 8, FrameStep::map), DeviceError);
}
