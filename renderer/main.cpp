// SPDX-License-Identifier: Apache-2.0
// The command line in, an exit code out: the only try/catch and the only exit codes of the program.
#include "parser/source_files.h"
#include "renderer/commands.h"
#include "renderer/device_error.h"
#include "renderer/errors.h"

#include <cstdio>
#include <cstdlib>
#include <new>
#include <string_view>
#include <unistd.h>

namespace {

using namespace proxima;

enum ExitCode {
    exit_done = 0,
    exit_scene = 1,
    exit_usage = 2,
    exit_file = 3,
    exit_difference = 4,
    exit_out_of_memory = 33,
    exit_try_elsewhere = 75,
    exit_signal = 128,
};

int fail(const char* message, int code) {
    const char* terminal = std::getenv("TERM");
    const char* no_color = std::getenv("NO_COLOR");
    const bool color =
        ::isatty(STDERR_FILENO) && !(no_color && *no_color) && terminal && std::string_view(terminal) != "dumb";
    std::fprintf(stderr, "proxima: %serror:%s %s\n", color ? "\033[1;31m" : "", color ? "\033[0m" : "", message);
    return code;
}

int exit_code(const DeviceError& error) {
    switch (error.kind) {
    case DeviceError::Kind::unavailable:
        return exit_usage;
    case DeviceError::Kind::out_of_memory:
        return exit_out_of_memory;
    case DeviceError::Kind::lost:
        return exit_try_elsewhere;
    case DeviceError::Kind::scene:
        break;
    }
    return exit_scene;
}

struct Run {
    void operator()(const RenderOptions& options) const {
        try {
            render_command(options);
        } catch (const std::exception& error) { // Open Job Description wants the reason in words of its own
            const std::string_view reason = error.what();
            if (options.progress == ProgressStyle::openjd)
                std::fprintf(stderr, "openjd_fail: %.*s\n", int(reason.substr(0, reason.find('\n')).size()),
                             reason.data());
            throw;
        }
    }
    void operator()(const VerifyOptions& options) const { verify_command(options); }
    void operator()(const ColorChoicesOptions& options) const {
        std::fputs(list_color_choices(options.color).c_str(), stdout);
    }
    void operator()(const CheckOptions& options) const { check_command(options); }
    void operator()(const PlanOptions& options) const { plan_command(options); }
    void operator()(const CompareOptions& options) const { compare_command(options); }
    void operator()(const TradeoffOptions& options) const { tradeoff_command(options); }
    void operator()(const DevicesOptions& options) const { devices_command(options); }
    void operator()(const BenchOptions& options) const { bench_command(options); }
    void operator()(const Information& information) const { std::fputs(information.text.c_str(), stdout); }
};

} // namespace

int main(int argc, char** argv) {
    try {
        std::visit(Run{}, parse_command_line(argc, argv));
        if (std::fflush(stdout) != 0)
            return fail("standard output: cannot be written", exit_file);
        return exit_done;
    } catch (const UsageError& error) {
        return fail(error.what(), exit_usage);
    } catch (const SceneRejected& error) {
        std::fputs(error.report.c_str(), stderr);
        return fail(error.what(), exit_scene);
    } catch (const FileError& error) {
        return fail(error.what(), exit_file);
    } catch (const PicturesDiffer& error) {
        std::fflush(stdout); // the figures come before the verdict
        return fail(error.what(), exit_difference);
    } catch (const FramesIncomplete& error) {
        std::fflush(stdout);
        return fail(error.what(), exit_difference);
    } catch (const DeviceError& error) {
        return fail(error.what(), exit_code(error));
    } catch (const Interrupted& error) {
        return fail(error.what(), exit_signal + error.signal);
    } catch (const std::bad_alloc&) {
        return fail("out of memory; choose a smaller --size or render elsewhere", exit_out_of_memory);
    } catch (const std::exception& error) {
        return fail(error.what(), exit_file);
    }
}
