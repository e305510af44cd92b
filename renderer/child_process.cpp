// SPDX-License-Identifier: Apache-2.0
#include "renderer/child_process.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace proxima {
namespace {

// The child writes into unnamed files, not pipes: nothing has to be drained while it runs.
struct CapturedStream {
    std::FILE* file = std::tmpfile();

    CapturedStream() {
        if (!file)
            throw std::runtime_error("no temporary file");
    }
    CapturedStream(const CapturedStream&) = delete;
    ~CapturedStream() { std::fclose(file); }

    std::string text() const {
        std::string result;
        std::rewind(file);
        char block[65536];
        for (size_t got; (got = std::fread(block, 1, sizeof block, file)) > 0;)
            result.append(block, got);
        return result;
    }
};

} // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                          double timeout_seconds) {
    using Clock = std::chrono::steady_clock;
    CapturedStream output, error;
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    const auto start = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("fork failed");
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL); // whoever ends this program ends what it started
        dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
        dup2(fileno(output.file), STDOUT_FILENO);
        dup2(fileno(error.file), STDERR_FILENO);
        if (chdir(folder.c_str()) == 0)
            execvp(argv[0], argv.data());
        _exit(127);
    }

    int status = 0;
    rusage usage{};
    for (pid_t done = 0; done != child;) {
        done = wait4(child, &status, WNOHANG, &usage);
        if (done == child)
            break;
        if (elapsed() > timeout_seconds)
            kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return {
        .exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
        .standard_output = output.text(),
        .standard_error = error.text(),
        .wall_seconds = elapsed(),
        .cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime),
        .peak_bytes = uint64_t(usage.ru_maxrss) * 1024,
    };
}

} // namespace proxima
