// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/body_stream.h"

namespace boresight::sources {

Result<> BodyStream::ask(const request::Follow& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return helm().streamTo(wanted.direction, by, wanted.what, wanted.anew); });
}

}  // namespace boresight::sources
