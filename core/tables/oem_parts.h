// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/oem_meta.h"
#include "core/tables/oem_reader.h"

#include <cstddef>
#include <string_view>

// Takes the lines of an OEM in KVN form one after the other and passes each to the part of the file it is in. An OEM in
// XML becomes the same lines. Pure.
namespace boresight::tables {

class OemParts
{
public:
    // `line` is not empty, is not a comment, and has no blanks at both ends. After a refusal nothing more may be
    // passed.
    Result<> take(std::string_view line);
    Result<> end();
    [[nodiscard]] Oem& oem() { return m_oem; }

private:
    enum class Part
    {
        Start,
        Header,
        Meta,
        Rows,
        Covariance,
        AfterCovariance
    };

    Result<> takeStart(std::string_view line);
    Result<> takeHeader(std::string_view line);
    Result<> takeMeta(std::string_view line);
    Result<> takeRow(std::string_view line);
    Result<> begin();
    Result<> endRows();
    [[nodiscard]] Result<> isSameObject() const;

    Oem m_oem;
    OemMeta m_meta;
    OrbitSegment m_segment;
    std::size_t m_rows = 0;  // in all segments
    Part m_part = Part::Start;
};

}  // namespace boresight::tables
