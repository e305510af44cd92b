// SPDX-License-Identifier: Apache-2.0
// Runs another program as a user would: the renderer's own way, by the tests' names.
#pragma once
#include "renderer/child_process.h"

namespace proxima::testing {

using proxima::ProcessResult;
using proxima::run_process;

} // namespace proxima::testing
