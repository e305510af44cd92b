// SPDX-License-Identifier: Apache-2.0
// What `proxima plan` says: sections of named values and sentences, as text or as JSON.
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace proxima {

/// A part of the plan: what one part of the program would do.
struct PlanSection {
    using Value = std::variant<uint64_t, double, std::string>;

    std::string name;
    std::string decision; ///< in a sentence, with its reason
    std::vector<std::pair<std::string, Value>> values;
};

std::string plan_text(const std::vector<PlanSection>& sections);
/// One object with an object for each section; its decision is `decision`.
std::string plan_json(const std::vector<PlanSection>& sections);

} // namespace proxima
