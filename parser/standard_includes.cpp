// SPDX-License-Identifier: Apache-2.0
#include "parser/standard_includes.h"

#include "parser/standard/refused_patterns.h"
#include "parser/standard/refused_shapes.h"
#include "parser/standard/texts.h"

#include <algorithm>
#include <cctype>
#include <iterator>

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

/// Whether `text` has `#declare identifier` or `#macro identifier`.
bool declares(std::string_view text, std::string_view identifier) {
    for (size_t at = text.find(identifier); at != std::string_view::npos; at = text.find(identifier, at + 1)) {
        const std::string_view before = text.substr(0, at);
        const size_t after = at + identifier.size();
        if ((before.ends_with("#declare ") || before.ends_with("#macro ")) &&
            (after == text.size() || !part_of_name(text[after])))
            return true;
    }
    return false;
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
    for (const StandardFile& file : files) {
        bool found = file.text && declares(file.text(), identifier);
        for (const RefusedNames& refused : file.refused)
            for_each_name(refused, [&](std::string_view name) { found = found || name == identifier; });
        if (found)
            return &file;
    }
    return nullptr;
}

} // namespace proxima
