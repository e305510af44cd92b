// SPDX-License-Identifier: Apache-2.0
// What a comparison found, pair by pair, and the same as JSON (the --json file, and the data of the --report page).
#pragma once
#include "renderer/image_figures.h"

#include <optional>
#include <string>
#include <vector>

namespace proxima {

enum class Verdict {
    equal,          ///< within the tolerance
    different,      ///< not
    not_comparable, ///< different in size or kind
    missing,        ///< one side has no picture
    unreadable,     ///< a file cannot be read
};

const char* to_string(Verdict verdict);

struct PairRecord {
    std::string name, a, b;
    Verdict verdict = Verdict::equal;
    std::string reason{}; ///< why there are no figures
    uint32_t width = 0, height = 0, channels = 0;
    double white = 1;   ///< of the worst pixel's numbers
    std::string rule{}; ///< see ImagePair
    std::vector<std::string> ignored_channels{};
    std::optional<ImageFigures> figures{}; ///< of equal and different pairs
};

struct ComparisonRecord {
    std::string a, b;
    double tolerance = 0;     ///< white is 1
    double allowed_share = 0; ///< of the pixels that may be over it
    std::vector<PairRecord> pairs{};

    size_t count(Verdict verdict) const;
    size_t failures() const { return pairs.size() - count(Verdict::equal); }
};

/// The JSON text. Numbers that are not finite are texts: "nan", "inf", "-inf".
std::string to_json(const ComparisonRecord& comparison);

} // namespace proxima
