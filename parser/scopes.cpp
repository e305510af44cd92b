// SPDX-License-Identifier: Apache-2.0
#include "parser/scopes.h"

#include <algorithm>

namespace proxima {

std::vector<Binding>& Scopes::stack(Symbol symbol) {
    if (symbol >= bindings_.size())
        bindings_.resize(symbol + 1 + symbol / 2);
    return bindings_[symbol];
}

void Scopes::leave() {
    while (!locals_.empty()) {
        std::vector<Binding>& bindings = stack(locals_.back());
        if (!bindings.empty() && bindings.back().scope < scope_)
            break;
        if (!bindings.empty())
            bindings.pop_back();
        locals_.pop_back();
    }
    --scope_;
}

Binding& Scopes::declare(Symbol symbol) {
    std::vector<Binding>& bindings = stack(symbol);
    if (bindings.empty())
        bindings.emplace_back();
    return bindings.back();
}

Binding& Scopes::declare_local(Symbol symbol) {
    std::vector<Binding>& bindings = stack(symbol);
    if (bindings.empty() || bindings.back().scope != scope_) {
        bindings.emplace_back().scope = scope_;
        if (scope_ > 0)
            locals_.push_back(symbol);
    }
    return bindings.back();
}

void Scopes::undefine(Symbol symbol) {
    std::vector<Binding>& bindings = stack(symbol);
    if (bindings.empty())
        return;
    if (bindings.back().scope > 0)
        locals_.erase(std::find(locals_.rbegin(), locals_.rend(), symbol).base() - 1);
    bindings.pop_back();
}

} // namespace proxima
