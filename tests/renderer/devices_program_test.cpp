// SPDX-License-Identifier: Apache-2.0
// The program on several devices: CPU workers stand in for them. The same bytes come out as from one.
#include "tests/process.h"

#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

constexpr const char* scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
light_source { <-5, 5, -5>, rgb 1 }
#for (I, -4, 4)
  sphere { <I / 4, sin(I + 6 * clock) / 2, 0>, 0.15 pigment { rgb <1, 0.3, 0.2> } finish { reflection 0.2 } }
#end
)";

class Workplace {
public:
    Workplace() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "scene.scn") << scene;
    }
    ~Workplace() { fs::remove_all(folder_); }

    /// Renders 12 small frames into folder `name`.
    ProcessResult render(const std::string& name, std::vector<std::string> arguments) const {
        fs::create_directories(folder_ / name);
        arguments.insert(arguments.begin(), {PROXIMA_PROGRAM, "render", "scene.scn", "--frames", "1-12", "--size",
                                             "40x30", "-o", name + "/f.##.png"});
        return run_process(arguments, folder_, 120);
    }
    /// Name -> bytes.
    std::map<std::string, std::string> frames(const std::string& name) const {
        std::map<std::string, std::string> bytes;
        for (const auto& entry : fs::directory_iterator(folder_ / name)) {
            std::ifstream file(entry.path(), std::ios::binary);
            bytes[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
        }
        return bytes;
    }
    nlohmann::json json(const std::string& name) const {
        std::ifstream file(folder_ / name);
        return nlohmann::json::parse(file);
    }

private:
    fs::path folder_ = fs::absolute("devices_program_test");
};

} // namespace

TEST_CASE("devices: several give the same bytes as one") {
    const Workplace work;
    REQUIRE(work.render("one", {"--device", "cpu"}).exit_code == 0);
    REQUIRE(work.render("three", {"--device", "cpu,cpu,cpu", "--stats-json", "three.json"}).exit_code == 0);
    CHECK(work.frames("one").size() == 12);
    CHECK(work.frames("one") == work.frames("three"));
    std::set<std::string> devices;
    int64_t frame = 0;
    for (const auto& record : work.json("three.json").at("frames")) {
        CHECK(record.at("frame") == ++frame); // in order, whoever rendered them
        devices.insert(record.at("device"));
    }
    for (const std::string& device : devices) // which of them take part is a matter of time
        CHECK((device == "cpu" || device == "cpu#2" || device == "cpu#3"));
}

TEST_CASE("devices: one that is asked for by name and missing is exit code 2") {
    const Workplace work;
    const ProcessResult run = work.render("none", {"--device", "cpu,cuda:99"});
    CHECK(run.exit_code == 2);
    CHECK(run.standard_error.find("--device cuda:99: there is no device cuda:99") != std::string::npos);
    CHECK(work.frames("none").empty());
}
