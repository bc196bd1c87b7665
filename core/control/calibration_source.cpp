// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/calibration_source.h"

#include <limits>

namespace boresight {

const Source& calibrationSource()
{
    // Client ids count up from 1, and the operator's hand has no id. So the largest number is free.
    static const Source kSource{.kind = SourceKind::Operator,
                                .clientId = std::numeric_limits<std::uint64_t>::max(),
                                .name = QStringLiteral("operator")};
    return kSource;
}

const Source& tuningSource()
{
    static const Source kSource{.kind = SourceKind::Operator,
                                .clientId = std::numeric_limits<std::uint64_t>::max() - 1,
                                .name = QStringLiteral("operator")};
    return kSource;
}

}  // namespace boresight
