// SPDX-License-Identifier: Apache-2.0
// A table of choice_bench for people.
#pragma once
#include "tests/bench/choice_table.h"

#include <string>
#include <vector>

namespace proxima::bench {

std::string line_of(const ChoiceRow& row);
/// All lines to standard output, and what is lost over each set.
void print_rows(const std::vector<ChoiceRow>& rows);
/// The coefficients that suit the table, and what choices lose by them and by those that there are.
void print_fit(const std::vector<ChoiceRow>& rows);

} // namespace proxima::bench
