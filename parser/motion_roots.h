// SPDX-License-Identifier: Apache-2.0
// Which nodes of a graph the declared names still need.
#pragma once
#include "parser/scopes.h"

namespace proxima {

/// Marks the nodes of everything that has a name.
void mark_names(const Scopes& scopes, MotionGraph& graph);

} // namespace proxima
