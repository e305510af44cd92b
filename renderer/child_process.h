// SPDX-License-Identifier: Apache-2.0
// Runs another program as a user would: arguments in; exit code, output, time and peak memory out. Or feeds it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
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

/// A program that reads what it works on from its standard input. It is killed unless it is finished.
class FedProcess {
public:
    /// Starts `arguments[0]` (looked up in PATH). Throws std::runtime_error when no process can be made.
    explicit FedProcess(const std::vector<std::string>& arguments);
    ~FedProcess();

    /// False when it takes no more.
    bool write(std::span<const unsigned char> bytes);
    /// Ends its input and waits. Returns its exit code.
    int finish();
    /// What it printed up to now.
    std::string messages() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace proxima
