// SPDX-License-Identifier: Apache-2.0
#include "renderer/stop_signal.h"

#include <atomic>
#include <cstdint>
#include <ctime>

namespace proxima {
namespace {

std::atomic<int> caught_signal{0};
std::atomic<int64_t> caught_at{0}; // milliseconds
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<int64_t>::is_always_lock_free,
              "a signal handler writes them");

constexpr int64_t patience = 1000; // milliseconds

int64_t now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time); // one of the few functions that a handler may call
    return int64_t(time.tv_sec) * 1000 + time.tv_nsec / 1'000'000;
}

void remember(int signal) {
    if (caught_signal == 0) {
        caught_at = now();
        caught_signal = signal;
    } else if (now() - caught_at >= patience) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

} // namespace

StopSignal::StopSignal() {
    caught_signal = 0;
    struct sigaction action {};
    action.sa_handler = remember;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, &old_interrupt_);
    sigaction(SIGTERM, &action, &old_terminate_);
    action.sa_handler = SIG_IGN;
    action.sa_flags = 0;
    sigaction(SIGXFSZ, &action, &old_file_size_);
}

StopSignal::~StopSignal() {
    sigaction(SIGINT, &old_interrupt_, nullptr);
    sigaction(SIGTERM, &old_terminate_, nullptr);
    sigaction(SIGXFSZ, &old_file_size_, nullptr);
}

int StopSignal::caught() const {
    return caught_signal;
}

} // namespace proxima
