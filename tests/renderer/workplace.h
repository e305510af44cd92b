// SPDX-License-Identifier: Apache-2.0
// The program as a user meets it: a folder with two scenes, where it is run.
#pragma once
#include "tests/process.h"

#include <OpenImageIO/imageio.h>
#include <array>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace proxima::testing {

namespace fs = std::filesystem;

inline constexpr const char* still_scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.18, 0.5, 0.05> }
camera { location <0, 0, -3> look_at 0 }
light_source { <-5, 5, -5>, rgb 1 }
sphere { 0, 0.5 pigment { rgb <1, 0.3, 0.2> } }
)";

inline constexpr const char* moving_scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
light_source { <-5, 5, -5>, rgb 1 }
sphere { <clock, 0, 0>, 0.5 pigment { rgb <1, 0.3, 0.2> } }
)";

/// A folder with two scenes in it, gone with the test.
struct Workplace {
    fs::path folder;

    explicit Workplace(const std::string& name = "program_test") : folder(fs::absolute(name)) {
        fs::remove_all(folder);
        fs::create_directories(folder);
        write("still.scn", still_scene);
        write("moving.scn", moving_scene);
    }
    ~Workplace() { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }

    ProcessResult run(std::vector<std::string> arguments, std::vector<std::string> wrapper = {}) const {
        wrapper.push_back(PROXIMA_PROGRAM);
        wrapper.insert(wrapper.end(), arguments.begin(), arguments.end());
        return run_process(wrapper, folder, 120);
    }

    /// Renders a small picture on the CPU.
    ProcessResult render(std::vector<std::string> arguments, std::vector<std::string> wrapper = {}) const {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"--size", "32x24", "--device", "cpu"});
        return run(std::move(arguments), std::move(wrapper));
    }

    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() != ".scn")
                names.insert(entry.path().filename().string());
        return names;
    }

    std::string content(const std::string& name) const {
        std::ifstream file(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::array<uint16_t, 3> corner(const std::string& name, OIIO::ImageSpec* spec = nullptr) const {
        const auto input = OIIO::ImageInput::open((folder / name).string());
        REQUIRE(input);
        std::vector<uint16_t> levels(size_t(input->spec().width) * size_t(input->spec().height) * 3);
        REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT16, levels.data()));
        if (spec)
            *spec = input->spec();
        return {levels[0], levels[1], levels[2]};
    }
};

inline bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace proxima::testing
