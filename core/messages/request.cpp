// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/request.h"

namespace boresight {

Request::Request(const Request& other) = default;
Request::Request(Request&& other) noexcept = default;
Request& Request::operator=(const Request& other) = default;
Request& Request::operator=(Request&& other) noexcept = default;
Request::~Request() = default;

}  // namespace boresight
