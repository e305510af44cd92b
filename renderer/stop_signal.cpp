// SPDX-License-Identifier: Apache-2.0
#include "renderer/stop_signal.h"

#include <atomic>
#include <cstdint>
#include <ctime>

namespace proxima {
namespace {

std::atomic<int> caught_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler writes it");

void remember(int signal) {
    caught_signal = signal;
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
