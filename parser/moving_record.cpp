// SPDX-License-Identifier: Apache-2.0
#include "parser/moving_record.h"

#include <algorithm>

namespace proxima {

void FieldNodes::set(FieldNode field) {
    const auto place = std::ranges::lower_bound(fields_, field.offset, {}, &FieldNode::offset);
    const bool known = place != fields_.end() && place->offset == field.offset;
    if (field.node && known)
        *place = field;
    else if (field.node)
        fields_.insert(place, field);
    else if (known)
        fields_.erase(place);
}

NodeId FieldNodes::at(uint32_t offset) const {
    const auto place = std::ranges::lower_bound(fields_, offset, {}, &FieldNode::offset);
    return place != fields_.end() && place->offset == offset ? place->node : 0;
}

void FieldNodes::mark(MotionGraph& graph) const {
    for (const FieldNode& field : fields_)
        graph.mark(field.node);
}

} // namespace proxima
