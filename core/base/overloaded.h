// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Combines one lambda per alternative for std::visit: std::visit(Overloaded{[](const A&) {…}, [](const B&) {…}},
// variant).
namespace boresight {

template <class... Handlers>
struct Overloaded : Handlers...
{
    using Handlers::operator()...;
};

template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace boresight
