// SPDX-License-Identifier: Apache-2.0
// One choice between grid and cloud for all renderers of a device, as long as there is one.
#pragma once
#include "renderer/method_choice.h"

#include <memory>
#include <mutex>

namespace proxima {

/// Gives the renderers of a device that live at the same time the same choice.
class SharedMethodChoice {
public:
    explicit SharedMethodChoice(const DeviceCosts& costs) : costs_(costs) {}

    std::shared_ptr<MethodChoice> take() {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<MethodChoice> choice = held_.lock();
        if (!choice)
            held_ = choice = std::make_shared<MethodChoice>(costs_);
        return choice;
    }

private:
    DeviceCosts costs_;
    std::mutex mutex_;
    std::weak_ptr<MethodChoice> held_;
};

} // namespace proxima
