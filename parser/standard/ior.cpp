// SPDX-License-Identifier: Apache-2.0
// ior.inc: indices of refraction of glasses and gems, and their dispersions as POV-Ray's `dispersion` takes them.
#include "parser/standard/texts.h"

namespace proxima::standard {
namespace {

struct Measured {
    const char* name;
    const char* ior;
    const char* spread; ///< of the index over the spectrum
};
using Named = std::pair<const char*, const char*>;

// clang-format off
constexpr Measured measured[] = {
    {"CrownGlassBaK1", "1.57241", "1.58941 - 1.56949"}, {"CrownGlassBK7", "1.51673", "1.53024 - 1.51432"},
    {"FlintGlassF2", "1.61989", "1.65064 - 1.61503"}, {"FlintGlassLaSFN9", "1.85002", "1.89844 - 1.84256"},
    {"FlintGlassSF11", "1.78446", "1.84208 - 1.77599"},
    {"AlmandineGarnet", "1.79", "0.024"}, {"Andalusite", "1.64", "0.016"}, {"AndraditeGarnet", "1.888", "0.057"},
    {"Apatite", "1.63", "0.013"}, {"Beryl", "1.58", "0.014"}, {"ChromeDiopside", "1.69", "0.019"},
    {"Chrysoberyl", "1.746", "0.015"}, {"CubicZirconia", "2.16", "0.06"}, {"Corundum", "1.766", "0.018"},
    {"DemantoidGarnet", "1.885", "0.057"}, {"Diamond", "2.417", "0.044"}, {"Fluorite", "1.434", "0.007"},
    {"GrossulariteGarnet", "1.74", "0.028"}, {"Iolite", "1.55", "0.017"}, {"Kyanite", "1.73", "0.02"},
    {"Peridot", "1.654", "0.02"}, {"PyropeGarnet", "1.74", "0.022"}, {"Quartz", "1.544", "0.013"},
    {"RhodoliteGarnet", "1.76", "0.026"}, {"SpessartiteGarnet", "1.81", "0.027"}, {"Sphene", "1.7", "0.051"},
    {"Spinel", "1.712", "0.02"}, {"Topaz", "1.62", "0.014"}, {"Tourmaline", "1.624", "0.017"},
    {"TsavoriteGarnet", "1.74", "0.028"}, {"Spodumene", "1.67", "0.017"}, {"Zircon", "1.95", "0.039"},
    {"Zoisite", "1.7", "0.03"},
};

constexpr Named without_spread[] = {
    {"AdulariaMoonstone", "1.52"}, {"Amazonite", "1.53"}, {"Amber", "1.54"}, {"Andesine", "1.53"},
    {"Coral", "1.486"}, {"Ivory", "1.54"}, {"Jadeite", "1.67"}, {"Jasper", "1.54"}, {"Labradorite", "1.56"},
    {"LapisLazuli", "1.5"}, {"Malachite", "1.655"}, {"Moissanite", "2.67"}, {"NephriteJade", "1.62"},
    {"Opal", "1.45"}, {"Orthoclase", "1.52"}, {"Pearl", "1.53"}, {"Prehnite", "1.64"}, {"Turquoise", "1.61"},
};

/// Other names: of the index and the dispersion, and of an index that has none.
constexpr Named aliases[] = {
    {"CrownGlass", "CrownGlassBK7"}, {"FlintGlass", "FlintGlassSF11"}, {"WindowGlass", "CrownGlassBK7"},
    {"Glass", "WindowGlass"}, {"Agate", "Quartz"}, {"Alexandrite", "Chrysoberyl"}, {"Amethyst", "Quartz"},
    {"Ametrine", "Quartz"}, {"Aquamarine", "Beryl"}, {"Aventurine", "Quartz"}, {"Chalcedony", "Quartz"},
    {"Citrine", "Quartz"}, {"Emerald", "Beryl"}, {"Hiddenite", "Spodumene"}, {"Kunzite", "Spodumene"},
    {"Morganite", "Beryl"}, {"Onyx", "Quartz"}, {"Padparadscha", "Corundum"}, {"RoseQuartz", "Quartz"},
    {"Ruby", "Corundum"}, {"Sapphire", "Corundum"}, {"SmokyQuartz", "Quartz"}, {"Tanzanite", "Zoisite"},
    {"TigersEye", "Quartz"}, {"Cyanite", "Kyanite"}, {"CZ", "CubicZirconia"}, {"Disthene", "Kyanite"},
    {"GarnetAlmandine", "AlmandineGarnet"}, {"GarnetAndradite", "AndraditeGarnet"},
    {"GarnetDemantoid", "DemantoidGarnet"}, {"GarnetGrossularite", "GrossulariteGarnet"},
    {"GarnetPyrope", "PyropeGarnet"}, {"GarnetRhodolite", "RhodoliteGarnet"},
    {"GarnetSpessartite", "SpessartiteGarnet"}, {"GarnetTsavorite", "TsavoriteGarnet"}, {"Munkrudite", "Kyanite"},
    {"Zirconia", "CubicZirconia"},
};
constexpr Named index_aliases[] = {
    {"JadeNephrite", "NephriteJade"}, {"FireOpal", "Opal"}, {"MoonstoneAdularia", "AdulariaMoonstone"},
    {"MossOpal", "Opal"},
};
// clang-format on

} // namespace

std::string ior() {
    std::string text = "#declare FnPovDispersion = function(x, y) { 1 + y/(x - y/2) }\n";
    for (const auto& [name, ior, spread] : measured)
        text +=
            fmt::format("#declare ior{0} = {1};\n#declare disp{0} = 1 + ({2})/({1} - ({2})/2);\n", name, ior, spread);
    for (const auto& [name, ior] : without_spread)
        text += fmt::format("#declare ior{} = {};\n", name, ior);
    for (const auto& [name, other] : aliases)
        text += fmt::format("#declare ior{0} = ior{1};\n#declare disp{0} = disp{1};\n", name, other);
    for (const auto& [name, other] : index_aliases)
        text += fmt::format("#declare ior{} = ior{};\n", name, other);
    return text;
}

} // namespace proxima::standard
