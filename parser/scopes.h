// SPDX-License-Identifier: Apache-2.0
// Which value a name has. As in POV-Ray, scopes are dynamic: a file or macro sees the names of whoever called it.
#pragma once
#include "parser/diagnostics.h"
#include "parser/symbols.h"
#include "parser/value.h"

#include <optional>
#include <vector>

namespace proxima {

/// Names one binding: the index counts the bindings of a symbol from the outermost. Or an element of the array that is
/// bound: where it stands in Array::elements, and where in that element's elements if it is an array, and so on.
struct BindingRef {
    Symbol symbol = 0;
    uint32_t index = 0;
    std::vector<uint32_t> element;
};

struct Binding {
    Value value;
    std::optional<BindingRef> reference; ///< stands for another binding: a macro's parameter for the caller's name
    SourceSpan declared;
    uint32_t scope = 0;
    bool used = false;
    bool predeclared = false;
};

class Scopes {
public:
    void enter() { ++scope_; }
    void leave();
    uint32_t depth() const { return scope_; }

    /// The innermost binding of a name, or nullptr. Valid until the next declaration.
    Binding* find(Symbol symbol) {
        if (symbol >= bindings_.size() || bindings_[symbol].empty())
            return nullptr;
        Binding& binding = bindings_[symbol].back();
        return binding.reference ? find(*binding.reference) : &binding;
    }
    /// What find() finds, or the element of it that a parameter stands for. The name has a binding.
    BindingRef reference_to(Symbol symbol) const;
    /// The element that a parameter stands for, or nullptr when the name stands for a whole binding.
    const std::vector<uint32_t>* element_of(Symbol symbol) const {
        const std::optional<BindingRef>& reference = bindings_[symbol].back().reference;
        return reference && !reference->element.empty() ? &reference->element : nullptr;
    }
    /// Whether #local would change what the name stands for, instead of making another binding.
    bool is_local(Symbol symbol) const { return bindings_[symbol].back().scope == scope_; }
    /// Binds a macro's parameter in the current scope.
    Binding& bind_parameter(Symbol symbol);
    /// #declare: changes the innermost binding, or makes a global one.
    Binding& declare(Symbol symbol);
    /// #local: changes the current scope's binding, or makes it.
    Binding& declare_local(Symbol symbol);
    void undefine(Symbol symbol);

    const std::vector<std::vector<Binding>>& bindings() const { return bindings_; }

private:
    Binding* find(const BindingRef& reference);
    std::vector<Binding>& stack(Symbol symbol);

    std::vector<std::vector<Binding>> bindings_; // by symbol; the innermost is the last
    std::vector<Symbol> locals_;                 // names with a binding in a scope above 0, in order
    uint32_t scope_ = 0;
};

} // namespace proxima
