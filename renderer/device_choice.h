// SPDX-License-Identifier: Apache-2.0
// The text of --device in, the devices that were asked for out. Whether they exist is choose_devices's question.
#pragma once
#include <string_view>
#include <vector>

namespace proxima {

struct DeviceChoice {
    struct Item {
        enum class Kind { cpu, cuda, every_cuda } kind = Kind::cpu;
        int ordinal = 0; ///< of Kind::cuda

        friend bool operator==(const Item&, const Item&) = default;
    };
    /// Empty: every CUDA device that there is, or else the CPU. A device named twice is two workers on it, which stand
    /// in for two devices in tests.
    std::vector<Item> items;

    bool is_automatic() const { return items.empty(); }
    /// More than one device may be meant.
    bool is_several() const {
        return items.size() > 1 || (items.size() == 1 && items[0].kind == Item::Kind::every_cuda);
    }
};

/// "auto", or a list of "cpu", "cuda", "cuda:0" and, behind a cuda:N, bare numbers: "cuda:0,2", "cuda,cpu".
/// Throws UsageError.
DeviceChoice parse_device(std::string_view text);

} // namespace proxima
