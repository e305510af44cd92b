// SPDX-License-Identifier: Apache-2.0
#include "parser/standard_includes.h"

#include "parser/standard/refused_patterns.h"
#include "parser/standard/refused_shapes.h"
#include "parser/standard/texts.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <unordered_map>

namespace proxima {
namespace {

using namespace standard;

const StandardFile files[] = {
    {"arrays.inc", "ARRAYS_INC_TEMP", arrays, arrays_refused},
    {"chars.inc", "Chars_Inc_Temp", nullptr, chars_refused},
    {"colors.inc", "Colors_Inc_Temp", colors, {}},
    {"consts.inc", "Consts_Inc_Temp", consts, {}},
    {"debug.inc", "DEBUG_MCR", debug, {}, false},
    {"finish.inc", "Finish_Inc_Temp", finish, {}},
    {"functions.inc", "Functions_Inc_Temp", nullptr, functions_refused},
    {"glass.inc", "Glass_Inc_Temp", glass, glass_refused},
    {"glass_old.inc", "Glass_Old_Inc_Temp", glass_old, {}},
    {"golds.inc", "Gold_Inc_Temp", golds, {}},
    {"ior.inc", "Ior_Inc_Temp", ior, {}},
    {"logo.inc", "Logo_Inc_Temp", logo, logo_refused},
    {"math.inc", "MATH_INC_TEMP", math, {}},
    {"metals.inc", "Metals_Inc_Temp", metals, {}},
    {"rand.inc", "RAND_INC_TEMP", rand, rand_refused},
    {"shapes.inc", "Shapes_Inc_Temp", shapes, shapes_refused},
    {"shapes2.inc", "Shapes2_Inc_Temp", shapes2, shapes2_refused},
    {"shapes3.inc", "Shapes3_Inc_Temp", shapes3, shapes3_refused},
    {"shapes_old.inc", "Shapes_Old_Inc_Temp", shapes_old, shapes_old_refused},
    {"shapesq.inc", "ShapesQ_Inc_Temp", shapesq, shapesq_refused},
    {"skies.inc", "Skies_Inc_Temp", skies, skies_refused},
    {"stage1.inc", "", stage1, {}, false},
    {"stars.inc", "Stars_Inc_Temp", nullptr, stars_refused},
    {"stdcam.inc", "", stdcam, {}, false},
    {"stdinc.inc", "STDINC_INC_TEMP", stdinc, {}},
    {"stoneold.inc", "Stoneold_Inc_Temp", stoneold, stoneold_refused},
    {"stones.inc", "Stones_Inc_Temp", stones, {}},
    {"stones1.inc", "Stones1_Inc_Temp", stones1, stones1_refused},
    {"stones2.inc", "Stones2_Inc_Temp", stones2, stones2_refused},
    {"strings.inc", "STRINGS_INC_TEMP", strings, strings_refused},
    {"textures.inc", "Textures_Inc_Temp", textures, textures_refused},
    {"transforms.inc", "TRANSFORMS_INC_TEMP", transforms, transforms_refused},
    {"woodmaps.inc", "Woodmaps_Inc_Temp", woodmaps, {}},
    {"woods.inc", "Woods_Inc_Temp", woods, woods_refused},
};

bool part_of_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// The file of each name that one declares, known or refused: the first one's.
std::unordered_map<std::string, const StandardFile*> files_of_names() {
    std::unordered_map<std::string, const StandardFile*> owners;
    for (const StandardFile& file : files) {
        const std::string text = file.text ? file.text() : "";
        for (const std::string_view directive : {"#declare ", "#macro "})
            for (size_t at = text.find(directive); at != std::string::npos; at = text.find(directive, at)) {
                at += directive.size();
                const auto begin = text.begin() + ptrdiff_t(at);
                owners.emplace(std::string(begin, std::find_if_not(begin, text.end(), part_of_name)), &file);
            }
        for (const RefusedNames& refused : file.refused)
            for_each_name(refused, [&](std::string_view name) { owners.emplace(name, &file); });
    }
    return owners;
}

} // namespace

const StandardFile* find_standard_file(std::string_view name) {
    const auto found = std::ranges::find(files, name, &StandardFile::name);
    return found == std::end(files) ? nullptr : &*found;
}

std::string standard_text(const StandardFile& file) {
    const std::string text = file.text ? file.text() : "";
    // From its last line on, a scene that had no version has one.
    return file.sets_version ? fmt::format("#version 3.5;\n{}#version {};\n", text, file.guard) : text;
}

const StandardFile* standard_file_of(std::string_view identifier) {
    // Made when the first mistake asks: a scene may have hundreds.
    static const std::unordered_map<std::string, const StandardFile*> owners = files_of_names();
    const auto found = owners.find(std::string(identifier));
    return found == owners.end() ? nullptr : found->second;
}

} // namespace proxima
