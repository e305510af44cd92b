// SPDX-License-Identifier: Apache-2.0
#include "renderer/stop_signal.h"

#include <atomic>
#include <cstdint>
#include <ctime>
#include <unistd.h>

namespace proxima {
namespace {

std::atomic<int> caught_signal{0};
std::atomic<int64_t> caught_at{0}; // milliseconds
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<int64_t>::is_always_lock_free,
              "a signal handler writes them");

constexpr int64_t patience = 1000; // milliseconds
constexpr timespec deadline{1, 900'000'000};

timer_t end_timer;

int64_t now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time); // one of the few functions that a handler may call
    return int64_t(time.tv_sec) * 1000 + time.tv_nsec / 1'000'000;
}

void remember(int signal) {
    if (caught_signal == 0) {
        caught_at = now();
        caught_signal = signal;
        const itimerspec once{{}, deadline};
        timer_settime(end_timer, 0, &once, nullptr);
    } else if (now() - caught_at >= patience) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

/// The deadline: whatever is still going on cannot be waited for.
void end_process(int) {
    constexpr char message[] = "proxima: error: stopped by a signal; what was not finished in time is dropped\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message, sizeof(message) - 1);
    ::_exit(128 + caught_signal);
}

} // namespace

StopSignal::StopSignal() {
    caught_signal = 0;
    struct sigaction action {};
    action.sa_flags = SA_RESTART;
    action.sa_handler = end_process;
    sigaction(SIGALRM, &action, &old_alarm_);
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    timer_create(CLOCK_MONOTONIC, &event, &end_timer);
    action.sa_handler = remember;
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
    timer_delete(end_timer);
    sigaction(SIGALRM, &old_alarm_, nullptr);
}

int StopSignal::caught() const {
    return caught_signal;
}

} // namespace proxima
