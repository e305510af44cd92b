// SPDX-License-Identifier: Apache-2.0
#include "renderer/child_process.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
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

/// What a child has in place of the standard streams.
struct ChildStreams {
    int input, output, error;
};

pid_t start(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const ChildStreams& streams) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("fork failed");
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL); // whoever ends this program ends what it started
        dup2(streams.input, STDIN_FILENO);
        dup2(streams.output, STDOUT_FILENO);
        dup2(streams.error, STDERR_FILENO);
        if (chdir(folder.c_str()) == 0)
            execvp(argv[0], argv.data());
        _exit(127);
    }
    return child;
}

int exit_code_of(int status) {
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                          double timeout_seconds) {
    using Clock = std::chrono::steady_clock;
    CapturedStream output, error;
    const auto started = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - started).count(); };
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    const pid_t child = start(arguments, folder, {nothing, fileno(output.file), fileno(error.file)});
    close(nothing);

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
        .exit_code = exit_code_of(status),
        .standard_output = output.text(),
        .standard_error = error.text(),
        .wall_seconds = elapsed(),
        .cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime),
        .peak_bytes = uint64_t(usage.ru_maxrss) * 1024,
    };
}

struct FedProcess::Implementation {
    CapturedStream messages; ///< both streams
    int input = -1;
    pid_t child = 0;
};

FedProcess::FedProcess(const std::vector<std::string>& arguments)
    : implementation_(std::make_unique<Implementation>()) {
    // A socket, not a pipe: writing to a program that has ended is an error then, not a signal.
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::runtime_error("no socket");
    const int messages = fileno(implementation_->messages.file);
    implementation_->input = ends[0];
    implementation_->child = start(arguments, ".", {ends[1], messages, messages});
    close(ends[1]);
}

FedProcess::~FedProcess() {
    close(implementation_->input);
    if (implementation_->child > 0) {
        kill(implementation_->child, SIGKILL);
        waitpid(implementation_->child, nullptr, 0);
    }
}

bool FedProcess::write(std::span<const unsigned char> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = send(implementation_->input, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0)
            return false;
        bytes = bytes.subspan(size_t(sent));
    }
    return true;
}

int FedProcess::finish() {
    shutdown(implementation_->input, SHUT_WR);
    int status = 0;
    while (waitpid(implementation_->child, &status, 0) < 0 && errno == EINTR)
        continue;
    implementation_->child = 0;
    return exit_code_of(status);
}

std::string FedProcess::messages() const {
    return implementation_->messages.text();
}

} // namespace proxima
