// SPDX-License-Identifier: Apache-2.0
#include "renderer/choose_devices.h"
#include "renderer/errors.h"

#include <doctest/doctest.h>

using namespace proxima;

namespace {

using Item = DeviceChoice::Item;
using Kind = Item::Kind;

} // namespace

TEST_CASE("device choice: a list names devices in its order") {
    CHECK(parse_device("auto").is_automatic());
    CHECK(parse_device("cpu").items == std::vector<Item>{{Kind::cpu}});
    CHECK(parse_device("cuda").items == std::vector<Item>{{Kind::every_cuda}});
    CHECK(parse_device("cuda:0,2").items == std::vector<Item>{{Kind::cuda, 0}, {Kind::cuda, 2}});
    CHECK(parse_device("cuda:3,cuda:1,cpu").items == std::vector<Item>{{Kind::cuda, 3}, {Kind::cuda, 1}, {Kind::cpu}});
    CHECK(parse_device("cuda,cpu").items == std::vector<Item>{{Kind::every_cuda}, {Kind::cpu}});
}

TEST_CASE("device choice: what is no device is refused") {
    for (const char* text :
         {"", "gpu", "0", "cpu,0", "cuda:", "cuda:x", "cuda:-1", "cuda:0,,1", "cuda,", "auto,cpu", "cuda:99999999999"})
        CHECK_THROWS_AS(parse_device(text), UsageError);
}

TEST_CASE("device choice: one that is named twice stands in for two") {
    const auto devices = choose_devices(parse_device("cpu,cpu,cpu"), 1);
    REQUIRE(devices.size() == 3);
    CHECK(devices[0].name == "cpu");
    CHECK(devices[2].name == "cpu#3");
    CHECK(devices[2].make()->name() == "cpu");
}

TEST_CASE("device choice: a device that is named and not there is a mistake on the command line") {
    CHECK_THROWS_AS(choose_devices(parse_device("cpu,cuda:1000"), 1), UsageError);
    CHECK_THROWS_AS(choose_renderer(parse_device("cpu,cpu"), 1), UsageError);
}
