// SPDX-License-Identifier: Apache-2.0
#include "renderer/errors.h"
#include "renderer/shard.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>

using namespace proxima;

namespace {

/// What a job array tells its tasks, gone with the test.
struct Slurm {
    static constexpr const char* names[] = {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
                                            "SLURM_ARRAY_TASK_COUNT"};

    Slurm(const char* id, const char* first, const char* last, const char* count) {
        const char* values[] = {id, first, last, count};
        for (size_t i = 0; i < 4; ++i)
            setenv(names[i], values[i], 1);
    }
    ~Slurm() {
        for (const char* name : names)
            unsetenv(name);
    }
};

} // namespace

TEST_CASE("shard: the parts hold every frame once") {
    const std::vector<int64_t> frames{1, 3, 5, 7, 9, 11, 13};
    CHECK(parse_shard("1/1").of(frames) == frames);
    CHECK(parse_shard("2/3").of(frames) == std::vector<int64_t>{3, 9});
    CHECK(parse_shard("9/9").of(frames).empty());
    for (uint32_t count = 1; count <= 9; ++count) {
        std::vector<int64_t> all;
        for (uint32_t index = 0; index < count; ++index)
            for (const int64_t frame : Shard{index, count}.of(frames))
                all.push_back(frame);
        std::sort(all.begin(), all.end());
        CHECK(all == frames);
    }
}

TEST_CASE("shard: what is no part of a whole is refused") {
    for (const char* text : {"", "1", "1/", "/2", "0/2", "3/2", "-1/2", "1/0", "a/b", "1/2/3", "1.5/2"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_shard(text), UsageError);
    }
    CHECK_THROWS_WITH(parse_shard("3/2"), "--shard 3/2: write I/N with I from 1 to N, like 2/5, or slurm");
}

TEST_CASE("shard: a task of a Slurm array knows its part") {
    {
        const Slurm slurm("2", "0", "3", "4");
        CHECK(parse_shard("slurm").index == 2);
        CHECK(parse_shard("slurm").count == 4);
    }
    {
        const Slurm slurm("21", "1", "31", "4"); // --array=1-31:10
        CHECK(parse_shard("slurm").index == 2);
    }
    {
        const Slurm slurm("7", "7", "7", "1");
        CHECK(parse_shard("slurm").index == 0);
    }
    {
        const Slurm slurm("5", "0", "9", "3"); // --array=0,5,9
        CHECK_THROWS_AS(parse_shard("slurm"), UsageError);
    }
    CHECK_THROWS_WITH(parse_shard("slurm"), "--shard slurm: SLURM_ARRAY_TASK_ID is not set; start it from a job array "
                                            "(sbatch --array), or write --shard I/N");
}
