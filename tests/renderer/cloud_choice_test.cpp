// SPDX-License-Identifier: Apache-2.0
#include "renderer/cloud_choice.h"

#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE("cloud choice: looks at the first frame and then now and then") {
    CloudChoice choice(10);
    CHECK(choice.is_due(100));
    choice.report(9);
    for (uint32_t frame = 0; frame < CloudChoice::interval; ++frame)
        CHECK_FALSE(choice.is_due(100));
    CHECK(choice.is_due(100));
    CHECK(choice.uses_cloud());
}

TEST_CASE("cloud choice: does not go to and fro between its two bounds") {
    CloudChoice choice(10);
    choice.report(3.5);
    CHECK_FALSE(choice.uses_cloud());
    choice.report(CloudChoice::worth);
    CHECK(choice.uses_cloud());
    choice.report(3.5);
    CHECK(choice.uses_cloud());
    choice.report(2.9);
    CHECK_FALSE(choice.uses_cloud());
}

TEST_CASE("cloud choice: a few primitives never get a cloud") {
    CloudChoice choice(10);
    CHECK(choice.is_due(10));
    choice.report(200);
    CHECK(choice.uses_cloud());
    CHECK_FALSE(choice.is_due(9));
    CHECK_FALSE(choice.uses_cloud());
    CHECK(choice.is_due(10));
}
