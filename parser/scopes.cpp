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
        return bindings.emplace_back();
    Binding* target = find(symbol);
    return target ? *target : bindings.back();
}

Binding& Scopes::declare_local(Symbol symbol) {
    const std::vector<Binding>& bindings = stack(symbol);
    // A parameter is a local name already: in POV-Ray, too, this changes what the caller passed.
    if (!bindings.empty() && bindings.back().scope == scope_)
        return declare(symbol);
    return bind_parameter(symbol);
}

Binding& Scopes::bind_parameter(Symbol symbol) {
    Binding& binding = stack(symbol).emplace_back();
    binding.scope = scope_;
    if (scope_ > 0)
        locals_.push_back(symbol);
    return binding;
}

BindingRef Scopes::reference_to(Symbol symbol) const {
    const std::vector<Binding>& bindings = bindings_[symbol];
    return bindings.back().reference.value_or(BindingRef{symbol, uint32_t(bindings.size() - 1), {}});
}

Binding* Scopes::find(const BindingRef& reference) {
    std::vector<Binding>& bindings = bindings_[reference.symbol];
    return reference.index < bindings.size() ? &bindings[reference.index] : nullptr;
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
