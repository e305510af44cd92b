// SPDX-License-Identifier: Apache-2.0
#include "parser/words.h"
#include "tests/parser/evaluate.h"

#include <fmt/format.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

/// Where words of the language stand.
constexpr const char* places[] = {
    "{} {{ }}",
    "#declare A = {} {{ }}",
    "sphere {{ 0, {} }}",
    "sphere {{ 0, 1 {} }}",
    "sphere {{ 0, 1 texture {{ {} }} }}",
    "sphere {{ 0, 1 pigment {{ {} }} }}",
    "sphere {{ 0, 1 finish {{ {} }} }}",
    "sphere {{ 0, 1 finish {{ reflection {{ 1 {} }} }} }}",
    "sphere {{ 0, 1 interior {{ {} }} }}",
    "camera {{ {} }}",
    "light_source {{ 9, 1 {} }}",
    "global_settings {{ {} }}",
};

} // namespace

TEST_CASE("unsupported words: each is refused by its name, wherever it stands") {
    const auto words = reserved_words();
    for (size_t i = size_t(Word::first_unsupported); i < words.size(); ++i) {
        CAPTURE(words[i]);
        for (const char* place : places)
            CHECK(error_of(fmt::format(fmt::runtime(place), words[i])) ==
                  fmt::format("Proxima does not support '{}'", words[i]));
    }
}

TEST_CASE("unsupported words: what stands for a thing in real scenes comes with advice") {
    const auto words = reserved_words();
    for (const char* word :
         {"box",        "cone",         "cylinder",   "torus",     "mesh",       "mesh2",        "blob",
          "text",       "height_field", "isosurface", "lathe",     "difference", "intersection", "merge",
          "clipped_by", "normal",       "media",      "radiosity", "photons",    "bozo",         "granite",
          "wood",       "marble",       "agate",      "image_map", "irid",       "dispersion",   "turbulence",
          "warp",       "light_group",  "fisheye"}) {
        CAPTURE(word);
        const bool unsupported =
            std::find(words.begin() + ptrdiff_t(Word::first_unsupported), words.end(), word) != words.end();
        CHECK((!unsupported || !word_advice(word).empty()));
    }
}
