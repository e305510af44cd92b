// SPDX-License-Identifier: Apache-2.0
// What an evaluation may cost: steps, memory and time. A scene that needs more is refused and not read further.
#include "parser/evaluator.h"
#include "parser/memory.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace proxima {
namespace {

constexpr uint64_t steps_between_checks = 1 << 18; // some milliseconds
constexpr uint64_t bytes_between_checks = 64 << 20;

std::string in_words(uint64_t steps) {
    return steps % 1'000'000 == 0 ? fmt::format("{} million", steps / 1'000'000) : std::to_string(steps);
}

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
        fail_budget(fmt::format("the scene takes more than {} steps to evaluate", in_words(budget.steps)), advice());
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (elapsed.count() > budget.seconds)
        fail_budget(fmt::format("the scene takes more than {} seconds to evaluate", budget.seconds),
                    "--max-seconds N allows more");
    const uint64_t resident = resident_bytes();
    const uint64_t held = resident > bytes_at_start_ ? resident - bytes_at_start_ : 0;
    // What was charged may be resident already: only a single large piece counts before it is.
    const uint64_t coming = charged_ > bytes_between_checks ? charged_ - bytes_between_checks : 0;
    if (held > byte_limit_ || coming > byte_limit_ - held)
        fail_budget(fmt::format("the scene takes more than {} MB of memory to evaluate", byte_limit_ >> 20),
                    "--max-memory MB allows more");
    charged_ = 0;
    next_check_ = std::min(steps_ + steps_between_checks, budget.steps);
}

/// The loop that the budget went to, as a rule: the innermost one if its end is not known, else the outermost.
const Evaluator::Loop* Evaluator::costly_loop() const {
    const auto is_while = [](const Loop& loop) { return loop.opener->directive == Directive::while_; };
    const auto innermost = std::find_if(loops_.rbegin(), loops_.rend(), is_while);
    return innermost != loops_.rend() ? &*innermost : loops_.empty() ? nullptr : &loops_.front();
}

/// How to go on past the limit of steps.
std::string Evaluator::advice() {
    const Loop* loop = costly_loop();
    if (!loop || loop->opener->directive == Directive::while_)
        return "--max-steps N allows N million";
    const Binding* variable = scopes_.find(loop->variable);
    const Terms* terms = variable ? std::get_if<Terms>(&variable->value) : nullptr;
    const double rounds = std::floor((loop->end - loop->start) / loop->step) + 1;
    const double done = terms ? (terms->value[0] - loop->start) / loop->step : 0;
    if (!(done >= 1 && done <= rounds))
        return "--max-steps N allows N million";
    // It goes on as it began, with a tenth for what comes behind it.
    const double millions = std::ceil(1.1 * double(steps_) * rounds / done / 1e6);
    const std::string progress = fmt::format("{:.0f} of its {:.0f} rounds are done", std::floor(done), rounds);
    return millions < 1e5 ? fmt::format("{}; --max-steps {:.0f} should do for all", progress, millions) : progress;
}

void Evaluator::fail_budget(std::string message, const std::string& advice) {
    exhausted_ = true;
    const Loop* loop = costly_loop();
    fail(loop ? *loop->opener : *cursor_, std::move(message), loop ? "does this loop end? " + advice : advice);
}

} // namespace proxima
