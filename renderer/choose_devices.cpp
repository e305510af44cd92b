// SPDX-License-Identifier: Apache-2.0
#include "renderer/choose_devices.h"
#include "renderer/device_costs.h"
#include "renderer/device_error.h"
#include "renderer/errors.h"
#include "renderer/shared_method_choice.h"

#include <algorithm>
#include <fmt/format.h>
#include <future>
#include <tbb/info.h>

namespace proxima {
namespace {

using Item = DeviceChoice::Item;

void add(std::vector<ChosenDevice>& devices, ChosenDevice device) {
    const auto same = std::count_if(devices.begin(), devices.end(), [&](const ChosenDevice& other) {
        return other.name.substr(0, other.name.find('#')) == device.name;
    });
    if (same > 0)
        device.name += fmt::format("#{}", same + 1);
    devices.push_back(std::move(device));
}

/// What each CPU of the list gets of the threads, so that several stand in for devices of their own.
unsigned share_of_threads(const DeviceChoice& choice, unsigned threads) {
    const auto cpus = unsigned(std::count(choice.items.begin(), choice.items.end(), Item{Item::Kind::cpu}));
    if (cpus <= 1)
        return threads;
    const unsigned all = threads ? threads : unsigned(tbb::info::default_concurrency());
    return std::max(1u, all / cpus);
}

void add_cpu(std::vector<ChosenDevice>& devices, unsigned threads) {
    const auto choice = std::make_shared<SharedMethodChoice>(cpu_costs);
    add(devices, {"cpu", false, [=] { return make_cpu_renderer(threads, choice->take()); }});
}

void add_cuda(std::vector<ChosenDevice>& devices, int ordinal) {
    const auto choice = std::make_shared<SharedMethodChoice>(cuda_costs);
    add(devices, {fmt::format("cuda:{}", ordinal), true, [=] { return make_cuda_renderer(ordinal, choice->take()); }});
}

[[noreturn]] void refuse(const std::string& device, const std::string& reason) {
    throw UsageError(fmt::format(
        "--device {}: {}; `proxima devices` lists what there is, and --device cpu always works", device, reason));
}

} // namespace

std::vector<ChosenDevice> choose_devices(const DeviceChoice& choice, unsigned threads) {
    std::vector<ChosenDevice> devices;
    const bool needs_cuda =
        choice.is_automatic() || std::any_of(choice.items.begin(), choice.items.end(),
                                             [](const Item& item) { return item.kind != Item::Kind::cpu; });
    std::string reason;
    const int count = needs_cuda ? int(list_cuda_devices(reason).size()) : 0;
    const auto add_every_cuda = [&] {
        for (int ordinal = 0; ordinal < count; ++ordinal)
            add_cuda(devices, ordinal);
    };
    if (choice.is_automatic()) {
        add_every_cuda();
        if (devices.empty())
            add_cpu(devices, threads);
    }
    for (const Item& item : choice.items) {
        if (item.kind == Item::Kind::cpu) {
            add_cpu(devices, share_of_threads(choice, threads));
        } else if (item.kind == Item::Kind::every_cuda) {
            if (count == 0)
                refuse("cuda", "there is no CUDA device (" + reason + ")");
            add_every_cuda();
        } else {
            const std::string name = fmt::format("cuda:{}", item.ordinal);
            if (item.ordinal >= count)
                refuse(name,
                       fmt::format("there is no device {}{}", name,
                                   count == 0 ? " (" + reason + ")" : fmt::format("; the last is cuda:{}", count - 1)));
            add_cuda(devices, item.ordinal);
        }
    }
    return devices;
}

StartedDevices start_devices(const DeviceChoice& choice, unsigned threads) {
    const std::vector<ChosenDevice> chosen = choose_devices(choice, threads);
    std::vector<std::future<std::unique_ptr<FrameRenderer>>> starting;
    for (const ChosenDevice& device : chosen)
        starting.push_back(std::async(std::launch::async, device.make));
    StartedDevices started;
    std::exception_ptr last;
    for (size_t i = 0; i < chosen.size(); ++i) {
        try {
            started.devices.push_back({chosen[i], starting[i].get()});
        } catch (const DeviceError& error) {
            if (error.kind == DeviceError::Kind::unavailable && !choice.is_automatic())
                refuse(chosen[i].name, error.what());
            started.failures.push_back(fmt::format("{} cannot be used: {}", chosen[i].name, error.what()));
            last = std::current_exception();
        }
    }
    if (!started.devices.empty())
        return started;
    if (!choice.is_automatic())
        std::rethrow_exception(last);
    std::vector<ChosenDevice> cpu;
    add_cpu(cpu, threads);
    started.devices.push_back({cpu[0], cpu[0].make()});
    return started;
}

std::unique_ptr<FrameRenderer> choose_renderer(const DeviceChoice& choice, unsigned threads) {
    if (choice.items.size() > 1)
        throw UsageError("--device: this command renders on one device; name one");
    DeviceChoice one = choice;
    if (one.is_automatic() || one.items[0].kind == Item::Kind::every_cuda) {
        const bool may_be_cpu = one.is_automatic();
        std::string reason;
        const bool has_cuda = !list_cuda_devices(reason).empty();
        if (has_cuda || !may_be_cpu)
            one.items = {{Item::Kind::cuda, 0}};
        else
            one.items = {{Item::Kind::cpu}};
    }
    return std::move(start_devices(one, threads).devices.front().renderer);
}

} // namespace proxima
