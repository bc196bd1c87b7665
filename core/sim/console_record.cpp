// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/console_record.h"

#include "core/base/numbers.h"
#include "core/base/overloaded.h"

#include <bit>
#include <cmath>

namespace boresight::sim {
namespace {

enum TypeNumber : std::uint8_t
{
    kBool = 2,
    kFixedSigned = 3,
    kFixedUnsigned = 4,
    kVaruint = 6,
    kFloat32 = 7,
    kObject = 16,
    kEnum = 17,
    kFixedArray = 19,
};

void appendByte(std::string& out, std::uint8_t byte)
{
    out.push_back(static_cast<char>(byte));
}

void appendVaruint(std::string& out, std::uint64_t value)
{
    for (; value >= 0x80; value >>= 7) {
        appendByte(out, static_cast<std::uint8_t>(value | 0x80));
    }
    appendByte(out, static_cast<std::uint8_t>(value));
}

void appendText(std::string& out, std::string_view text)
{
    appendVaruint(out, text.size());
    out += text;
}

void appendLittleEndian(std::string& out, std::uint64_t bits, std::uint8_t width)
{
    for (std::uint8_t i = 0; i < width; ++i, bits >>= 8) {
        appendByte(out, static_cast<std::uint8_t>(bits));
    }
}

void appendType(std::string& out, const ArchiveValue& value)
{
    const auto fixed = [&](TypeNumber type, std::uint8_t width) {
        appendByte(out, type);
        appendByte(out, width);
    };
    std::visit(Overloaded{[&](bool) { appendByte(out, kBool); },
                          [&](const ArchiveUnsigned& item) { fixed(kFixedUnsigned, item.width); },
                          [&](const ArchiveSigned& item) { fixed(kFixedSigned, item.width); },
                          [&](float) { appendByte(out, kFloat32); },
                          [&](const ArchiveEnum& item) {
                              appendByte(out, kEnum);
                              appendByte(out, kVaruint);
                              appendVaruint(out, item.names.size());
                              for (std::size_t i = 0; i < item.names.size(); ++i) {
                                  appendVaruint(out, i);
                                  appendText(out, item.names[i]);
                              }
                          },
                          [&](const ArchiveArray& item) {
                              appendByte(out, kFixedArray);
                              appendVaruint(out, item.values.size());
                              fixed(kFixedUnsigned, item.width);
                          }},
               value);
}

void appendFieldHead(std::string& out, std::string_view name)
{
    appendVaruint(out, 0);  // flags
    appendText(out, name);
    appendVaruint(out, 0);  // aliases
}

// An object: its flags, its fields, and as the end a field without name and type.
void appendObject(std::string& out, std::span<const ArchiveField> fields, std::size_t prefix)
{
    appendByte(out, kObject);
    appendVaruint(out, 0);
    for (std::size_t i = 0; i < fields.size();) {
        const std::string_view name = std::string_view(fields[i].name).substr(prefix);
        const std::size_t dot = name.find('.');
        appendFieldHead(out, name.substr(0, dot));
        std::size_t end = i + 1;
        if (dot == std::string_view::npos) {
            appendType(out, fields[i].value);
        } else {
            const std::string_view group = std::string_view(fields[i].name).substr(0, prefix + dot + 1);
            while (end < fields.size() && fields[end].name.starts_with(group)) {
                ++end;
            }
            appendObject(out, fields.subspan(i, end - i), group.size());
        }
        appendByte(out, 0);  // the field has no default
        i = end;
    }
    appendFieldHead(out, "");
    appendByte(out, 0);
    appendByte(out, 0);
}

std::string floatText(float value)
{
    return std::isfinite(value) ? formatFixed(static_cast<double>(value), 6) : std::isnan(value) ? "nan" : "inf";
}

std::string line(std::string_view name, std::string_view key, const std::string& value)
{
    return std::string(name) + "." + std::string(key) + " " + value + "\r\n";
}

}  // namespace

std::string binarySchema(std::span<const ArchiveField> fields)
{
    std::string out;
    appendObject(out, fields, 0);
    return out;
}

std::string binaryData(std::span<const ArchiveField> fields)
{
    std::string out;
    for (const ArchiveField& field : fields) {
        std::visit(Overloaded{[&](bool value) { appendByte(out, value ? 1 : 0); },
                              [&](const ArchiveUnsigned& item) { appendLittleEndian(out, item.value, item.width); },
                              [&](const ArchiveSigned& item) {
                                  appendLittleEndian(out, static_cast<std::uint64_t>(item.value), item.width);
                              },
                              [&](float value) { appendLittleEndian(out, std::bit_cast<std::uint32_t>(value), 4); },
                              [&](const ArchiveEnum& item) { appendVaruint(out, item.value); },
                              [&](const ArchiveArray& item) {
                                  for (const std::uint32_t value : item.values) {
                                      appendLittleEndian(out, value, item.width);
                                  }
                              }},
                   field.value);
    }
    return out;
}

std::string textLines(std::string_view name, std::span<const ArchiveField> fields)
{
    std::string out;
    for (const ArchiveField& field : fields) {
        std::visit(Overloaded{[&](bool value) { out += line(name, field.name, value ? "1" : "0"); },
                              [&](float value) { out += line(name, field.name, floatText(value)); },
                              [&](const ArchiveArray& item) {
                                  for (std::size_t i = 0; i < item.values.size(); ++i) {
                                      out += line(name, field.name + "." + std::to_string(i),
                                                  std::to_string(item.values[i]));
                                  }
                              },
                              [&](const auto& item) { out += line(name, field.name, std::to_string(item.value)); }},
                   field.value);
    }
    return out;
}

}  // namespace boresight::sim
