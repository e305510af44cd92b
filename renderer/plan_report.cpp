// SPDX-License-Identifier: Apache-2.0
#include "renderer/plan_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proxima {

std::string plan_text(const std::vector<PlanSection>& sections) {
    std::string text;
    for (const PlanSection& section : sections) {
        text += fmt::format("{}: {}\n", section.name, section.decision);
        for (const auto& [name, value] : section.values)
            std::visit([&](const auto& v) { text += fmt::format("  {:<22}{:>12}\n", name, v); }, value);
    }
    return text;
}

std::string plan_json(const std::vector<PlanSection>& sections) {
    nlohmann::ordered_json result = nlohmann::ordered_json::object();
    for (const PlanSection& section : sections) {
        nlohmann::ordered_json& object = result[section.name];
        object["decision"] = section.decision;
        for (const auto& [name, value] : section.values)
            std::visit([&](const auto& v) { object[name] = v; }, value);
    }
    return result.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

} // namespace proxima
