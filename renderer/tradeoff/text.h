// SPDX-License-Identifier: Apache-2.0
// The findings of `proxima tradeoff` as texts: for people, for spreadsheets, for programs.
#pragma once
#include "renderer/tradeoff/record.h"

namespace proxima {

/// What was measured and how noisy it was, the front, and what to take.
std::string tradeoff_text(const TradeoffRecord& record);
/// A line a setting, with a line of names in front.
std::string tradeoff_csv(const TradeoffRecord& record);
/// All of it.
std::string tradeoff_json(const TradeoffRecord& record);

} // namespace proxima
