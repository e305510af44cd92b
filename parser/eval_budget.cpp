// SPDX-License-Identifier: Apache-2.0
// What an evaluation may cost: steps, memory and time. A scene that needs more is refused and not read further.
#include "parser/evaluator.h"
#include "parser/memory.h"

#include <algorithm>
#include <fmt/format.h>

namespace proxima {
namespace {

constexpr uint64_t steps_between_checks = 1 << 18; // some milliseconds
constexpr uint64_t bytes_between_checks = 64 << 20;

} // namespace

/// Announces memory that is about to be taken, or was taken, by a value of any size.
void Evaluator::charge(uint64_t bytes) {
    charged_ += bytes;
    if (charged_ > bytes_between_checks)
        check_budget();
}

void Evaluator::check_budget() {
    const EvaluationBudget& budget = settings_.budget;
    if (steps_ > budget.steps)
        fail_budget(fmt::format("the scene takes more than {} steps to evaluate", budget.steps));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (elapsed.count() > budget.seconds)
        fail_budget(fmt::format("the scene takes more than {} seconds to evaluate", budget.seconds));
    const uint64_t resident = resident_bytes();
    const uint64_t held = resident > bytes_at_start_ ? resident - bytes_at_start_ : 0;
    // What was charged may be resident already: only a single large piece counts before it is.
    const uint64_t coming = charged_ > bytes_between_checks ? charged_ - bytes_between_checks : 0;
    if (held > byte_limit_ || coming > byte_limit_ - held)
        fail_budget(fmt::format("the scene takes more than {} MB of memory to evaluate", byte_limit_ >> 20));
    charged_ = 0;
    next_check_ = std::min(steps_ + steps_between_checks, budget.steps);
}

void Evaluator::fail_budget(std::string message) {
    exhausted_ = true;
    // The innermost loop is the one that does not end, as a rule.
    const Token& token = loops_.empty() ? *cursor_ : *loops_.back().opener;
    fail(token, std::move(message), loops_.empty() ? "" : "does this loop end?");
}

} // namespace proxima
