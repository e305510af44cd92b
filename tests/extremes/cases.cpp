// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/cases.h"

namespace proxima::testing {
namespace {

class Cases {
public:
    /// A case; what it is not like the others in may be set in what is returned.
    ExtremeCase& add(const std::string& name, const std::string& scene, const Declares& declares = {}) {
        cases_.push_back({name, scene + ".scn", declares});
        return cases_.back();
    }
    /// One for each value of a declared number.
    void add_each(const std::string& name, const std::string& scene, const std::string& declared,
                  const std::vector<std::string>& values, Declares others = {}) {
        for (const std::string& value : values) {
            Declares declares = others;
            declares.emplace_back(declared, value);
            add(name + " " + value, scene, declares);
        }
    }
    std::vector<ExtremeCase> take() { return std::move(cases_); }

private:
    std::vector<ExtremeCase> cases_;
};

void add_crowd(Cases& cases, const std::string& name, const std::string& count, bool is_quick) {
    ExtremeCase& extreme = cases.add(name, "crowd", {{"Count", count}});
    extreme.width = extreme.height = 16;
    extreme.is_quick = is_quick;
}

} // namespace

std::vector<ExtremeCase> extreme_cases(Slowness slowness) {
    Cases cases;
    cases.add("as it is", "spheres");
    cases.add("mirrors", "spheres", {{"Mirror", "1"}});
    cases.add_each("scaled by", "spheres", "Scale", {"1e-6", "1e-3", "1e3", "1e6", "1e-30", "1e-140", "1e30"});
    const std::vector<std::string> shifts{"1e3", "1e4", "1e5", "1e6", "1e7", "1e8"};
    cases.add_each("shifted by", "spheres", "Shift", shifts);
    cases.add_each("mirrors shifted by", "spheres", "Shift", shifts, {{"Mirror", "1"}});
    cases.add("radii from 1e-8 to 1e9", "radii");
    const std::vector<std::string> radii{"1e3", "123456.7", "1e6", "1e9"};
    cases.add_each("on a globe of", "ground", "Radius", radii);
    cases.add_each("mirrors on a globe of", "ground", "Radius", radii, {{"Mirror", "1"}});
    for (const char* off : {"0", "-1", "1", "1000", "1e9"}) {
        ExtremeCase& extreme = cases.add(std::string("outline past rays by ulps: ") + off, "grazing", {{"Off", off}});
        extreme.width = extreme.height = 16;
        extreme.by_a_hair = true;
    }
    cases.add("twice, concentric, touching", "coincident");
    const std::vector<std::string> places{"0", "0.5", "0.999999999999", "1", "1.000000000001", "1.001"};
    cases.add_each("eye in glass, radii:", "eye", "Place", places);
    cases.add_each("eye in a ball, radii:", "eye", "Place", places, {{"Glass", "0"}});
    cases.add_each("light in a ball, radii:", "eye", "LightPlace", places, {{"Glass", "0"}, {"Place", "-3"}});
    cases.add("glass in glass, 30 deep", "nested");
    cases.add("mirrors to level 256", "corridor");
    cases.add("lights at 1e7", "lights");
    cases.add("lights at 1e12", "lights", {{"Far", "1e12"}});
    cases.add_each("colours of", "lights", "Bright", {"1e6", "1e-8", "1e-40"}, {{"Far", "10"}});
    cases.add_each("angle of view", "spheres", "Angle", {"1e-4", "1e-2", "1", "179.9"});
    cases.add_each("from times as far away:", "spheres", "Back", {"1e1", "1e2", "1e3", "1e4", "1e5", "1e6"});
    cases.add_each("mirrors, angle of view", "spheres", "Angle", {"1e-4", "1", "179.9"}, {{"Mirror", "1"}});
    ExtremeCase& pixel = cases.add("one pixel", "spheres");
    pixel.width = pixel.height = 1;
    ExtremeCase& wide = cases.add("32768 x 64 pixels", "spheres");
    wide.width = 32768;
    wide.height = 64;
    wide.is_quick = false;
    add_crowd(cases, "100 thousand in a voxel", "100000", true);
    add_crowd(cases, "1 million in a voxel", "1000000", false);
    add_crowd(cases, "2 million in a voxel", "2000000", false);
    if (slowness == Slowness::all)
        add_crowd(cases, "50 million in a voxel", "50000000", false);
    cases.add("all on one plane", "flat");
    cases.add("all on one line", "flat", {{"Line", "1"}});
    cases.add("denormal numbers", "denormal");
    return cases.take();
}

SceneProgram read_case(const ExtremeCase& extreme, const std::filesystem::path& scenes) {
    return read_scene(scenes / extreme.scene, extreme.width, extreme.height, extreme.declares);
}

} // namespace proxima::testing
