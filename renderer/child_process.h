// SPDX-License-Identifier: Apache-2.0
// Runs another program as a user would: arguments in; exit code, output, time and peak memory out.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace proxima {

struct ProcessResult {
    int exit_code = 0; ///< 128 + n when signal n ended it
    std::string standard_output;
    std::string standard_error;
    double wall_seconds = 0;
    double cpu_seconds = 0;  ///< user and system
    uint64_t peak_bytes = 0; ///< largest resident set
};

/// Runs `arguments[0]` (looked up in PATH) in `folder` and waits for it. Standard input is empty.
/// It is killed after `timeout_seconds` (exit code 137), and when this process ends. The exit code is 127 when there is
/// no such program. Throws std::runtime_error when no process can be made.
ProcessResult run_process(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".",
                          double timeout_seconds = 600);

} // namespace proxima
