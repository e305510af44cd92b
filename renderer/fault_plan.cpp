// SPDX-License-Identifier: Apache-2.0
#include "renderer/fault_plan.h"
#include "renderer/errors.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace proxima {
namespace {

template <class Number> bool read_number(std::string_view text, Number& number) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    return !text.empty() && read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

/// Cuts off what stands before `mark`, and the mark; all when there is none.
std::string_view cut(std::string_view& text, char mark) {
    const size_t end = std::min(text.find(mark), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

std::optional<Fault> read_fault(std::string_view text) {
    Fault fault;
    if (const size_t star = text.rfind('*'); star != text.npos) {
        if (!read_number(text.substr(star + 1), fault.times) || fault.times == 0)
            return std::nullopt;
        text = text.substr(0, star);
    }
    const std::string_view kind = cut(text, '@'), frame = cut(text, ':'), step = cut(text, ':');
    fault.device = text;
    const auto named = std::find(frame_step_names.begin(), frame_step_names.end(), step);
    if ((kind != "gpu-lost" && kind != "out-of-memory") || !frame.starts_with("frame") ||
        !read_number(frame.substr(5), fault.frame) || named == frame_step_names.end())
        return std::nullopt;
    fault.kind = kind == "gpu-lost" ? DeviceError::Kind::lost : DeviceError::Kind::out_of_memory;
    fault.step = FrameStep(named - frame_step_names.begin());
    return fault;
}

} // namespace

std::vector<Fault> parse_faults(std::string_view text) {
    std::vector<Fault> faults;
    while (!text.empty()) {
        const std::string_view part = cut(text, ',');
        const auto fault = read_fault(part);
        if (!fault)
            throw UsageError(fmt::format("--inject {}: write KIND@frameN:STEP[:DEVICE][*TIMES], where KIND is gpu-lost "
                                         "or out-of-memory and STEP one of {}",
                                         part, fmt::join(frame_step_names, ", ")));
        faults.push_back(*fault);
    }
    return faults;
}

void FaultPlan::strike(const std::string& device, int64_t frame, FrameStep step) {
    const std::lock_guard lock(mutex_);
    const auto planned = std::find_if(faults_.begin(), faults_.end(), [&](const Fault& fault) {
        return fault.frame == frame && fault.step == step && fault.times > 0 &&
               (fault.device.empty() || fault.device == device);
    });
    if (planned == faults_.end())
        return;
    --planned->times;
    throw DeviceError(planned->kind,
                      fmt::format("{} (a fault for a test, at the {} step)",
                                  planned->kind == DeviceError::Kind::lost ? "the device was lost" : "out of memory",
                                  name_of(step)));
}

} // namespace proxima
