// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/interface_report.h"

#include "core/base/text.h"

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/rtnetlink.h>
#include <net/if.h>

#include <algorithm>
#include <cstring>

namespace boresight::socketcan {
namespace {

using Bytes = std::span<const std::uint8_t>;

// Reads a structure from the beginning of `bytes`. A newer kernel may append fields to it.
template <class Value>
std::optional<Value> take(Bytes bytes)
{
    if (bytes.size() < sizeof(Value)) {
        return std::nullopt;
    }
    Value value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

// Calls `visit(type, payload)` for each attribute. False if an attribute is cut, has a wrong length or is not
// understood.
template <class Visit>
bool forEachAttribute(Bytes bytes, const Visit& visit)
{
    while (bytes.size() >= sizeof(rtattr)) {
        const auto head = *take<rtattr>(bytes);
        if (head.rta_len < sizeof(rtattr) || head.rta_len > bytes.size() ||
            !visit(head.rta_type & NLA_TYPE_MASK, bytes.subspan(sizeof(rtattr), head.rta_len - sizeof(rtattr)))) {
            return false;
        }
        bytes = bytes.subspan(std::min<std::size_t>(RTA_ALIGN(head.rta_len), bytes.size()));
    }
    return bytes.empty();
}

std::string textOf(Bytes bytes)
{
    const auto end = std::ranges::find(bytes, std::uint8_t{0});
    return {bytes.begin(), end};
}

template <class Raw, class Value, class Convert>
bool store(std::optional<Value>& field, Bytes bytes, const Convert& convert)
{
    const std::optional<Raw> raw = take<Raw>(bytes);
    if (raw) {
        field = convert(*raw);
    }
    return raw.has_value();
}

PhaseTiming timingOf(const can_bittiming& raw)
{
    return {.bitRate = raw.bitrate, .samplePoint = raw.sample_point / 1000.0};
}

std::optional<ControllerState> stateOf(std::uint32_t raw)
{
    return raw < CAN_STATE_MAX ? std::optional(static_cast<ControllerState>(raw)) : std::nullopt;
}

bool readCan(Bytes bytes, InterfaceReport& report)
{
    return forEachAttribute(bytes, [&report](int type, Bytes value) {
        switch (type) {
            case IFLA_CAN_BITTIMING:
                return store<can_bittiming>(report.nominal, value, timingOf);
            case IFLA_CAN_DATA_BITTIMING:
                return store<can_bittiming>(report.data, value, timingOf);
            case IFLA_CAN_CTRLMODE:
                return store<can_ctrlmode>(report.flexibleData, value, [](const can_ctrlmode& mode) {
                    return (mode.flags & CAN_CTRLMODE_FD) != 0;
                });
            case IFLA_CAN_STATE:
                return store<std::uint32_t>(report.controller, value, stateOf);
            case IFLA_CAN_BERR_COUNTER:
                return store<can_berr_counter>(report.errors, value, [](const can_berr_counter& raw) {
                    return ErrorCounters{.transmit = raw.txerr, .receive = raw.rxerr};
                });
            default:
                return true;
        }
    });
}

bool readLinkInfo(Bytes bytes, InterfaceReport& report)
{
    Bytes data;
    const bool whole = forEachAttribute(bytes, [&](int type, Bytes value) {
        if (type == IFLA_INFO_KIND) {
            report.kind = textOf(value);
        } else if (type == IFLA_INFO_DATA) {
            data = value;
        }
        return true;
    });
    // The meaning of the data depends on the kind.
    return whole && (report.kind != "can" || readCan(data, report));
}

tl::unexpected<Error> unreadable()
{
    return failure(ErrorCode::Protocol, Text::tr("the kernel's description of the interface cannot be read"));
}

}  // namespace

std::vector<std::uint8_t> interfaceQuestion(int index, std::uint32_t sequence)
{
    struct Question
    {
        nlmsghdr head;
        ifinfomsg interface;
    };
    Question question{};
    question.head.nlmsg_len = sizeof question;
    question.head.nlmsg_type = RTM_GETLINK;
    question.head.nlmsg_flags = NLM_F_REQUEST;
    question.head.nlmsg_seq = sequence;
    question.interface.ifi_family = AF_UNSPEC;
    question.interface.ifi_index = index;
    std::vector<std::uint8_t> bytes(sizeof question);
    std::memcpy(bytes.data(), &question, sizeof question);
    return bytes;
}

Result<InterfaceReport> readInterfaceAnswer(std::span<const std::uint8_t> message)
{
    const auto head = take<nlmsghdr>(message);
    if (!head || head->nlmsg_type != RTM_NEWLINK || head->nlmsg_len > message.size() ||
        head->nlmsg_len < sizeof(nlmsghdr) + sizeof(ifinfomsg)) {
        return unreadable();
    }
    const Bytes body = message.first(head->nlmsg_len).subspan(sizeof(nlmsghdr));
    const auto interface = *take<ifinfomsg>(body);
    InterfaceReport report{.index = interface.ifi_index, .up = (interface.ifi_flags & IFF_UP) != 0};
    const bool whole = forEachAttribute(body.subspan(sizeof(ifinfomsg)), [&report](int type, Bytes value) {
        if (type == IFLA_IFNAME) {
            report.name = textOf(value);
        }
        return type != IFLA_LINKINFO || readLinkInfo(value, report);
    });
    if (!whole) {
        return unreadable();
    }
    return report;
}

}  // namespace boresight::socketcan
