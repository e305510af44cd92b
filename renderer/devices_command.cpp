// SPDX-License-Identifier: Apache-2.0
#include "renderer/commands.h"

#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proxima {
namespace {

std::string as_json(const std::vector<DeviceDescription>& devices) {
    auto list = nlohmann::ordered_json::array();
    for (const DeviceDescription& device : devices)
        list.push_back(
            {{"id", device.id}, {"name", device.name}, {"memory_bytes", device.memory}, {"note", device.note}});
    return list.dump(2) + '\n';
}

std::string as_table(const std::vector<DeviceDescription>& devices) {
    size_t name_width = 0;
    for (const DeviceDescription& device : devices)
        name_width = std::max(name_width, device.name.size());
    std::string table;
    for (const DeviceDescription& device : devices)
        table += fmt::format("{:<8}{:<{}}  {:>7.1f} GiB  {}\n", device.id, device.name, name_width,
                             double(device.memory) / double(1 << 30), device.note);
    return table;
}

} // namespace

void devices_command(const DevicesOptions& options) {
    std::vector<DeviceDescription> devices{describe_cpu(0)};
    std::string reason;
    for (DeviceDescription& device : list_cuda_devices(reason))
        devices.push_back(std::move(device));
    std::fputs((options.json ? as_json(devices) : as_table(devices)).c_str(), stdout);
    if (!options.json && !reason.empty())
        std::fputs(fmt::format("no CUDA device: {}\n", reason).c_str(), stderr);
}

} // namespace proxima
