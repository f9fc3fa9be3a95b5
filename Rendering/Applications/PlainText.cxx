// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlainText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
template <typename Number>
std::string Print(Number value)
{
  const Number magnitude = std::abs(value);
  const bool isPlain = magnitude == Number(0) ||
    (magnitude >= static_cast<Number>(1e-4) && magnitude < static_cast<Number>(1e15));
  std::array<char, 48> text;
  char* end = text.data() + text.size();
  const auto result = isPlain ? std::to_chars(text.data(), end, value, std::chars_format::fixed)
                              : std::to_chars(text.data(), end, value);
  return { text.data(), result.ptr };
}

//------------------------------------------------------------------------------
// Bytes of the character that begins with this one; 0 for none and for the control characters.
std::size_t GetLength(unsigned char lead)
{
  if (lead < 0x80)
  {
    return lead >= 0x20 && lead != 0x7f;
  }
  return lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
}

//------------------------------------------------------------------------------
// Bytes of the printable character that the text begins with, 0 if it begins with none.
std::size_t GetPrintableLength(std::string_view text)
{
  const auto byteAt = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = GetLength(byteAt(0));
  const auto isContinuation = [](char byte) { return (byte & 0xc0) == 0x80; };
  const bool isWhole = length <= text.size() &&
    std::all_of(text.begin() + 1, text.begin() + std::max<std::size_t>(1, length), isContinuation);
  const bool isControl = byteAt(0) == 0xc2 && isWhole && byteAt(1) < 0xa0; // C1 of ISO 6429
  return isWhole && !isControl ? length : 0;
}
}

//------------------------------------------------------------------------------
std::string ToText(double value)
{
  return Print(value);
}

//------------------------------------------------------------------------------
std::string ToText(float value)
{
  return Print(value);
}

//------------------------------------------------------------------------------
std::string MakePrintable(std::string_view text)
{
  std::string result;
  while (!text.empty())
  {
    const std::size_t length = GetPrintableLength(text);
    result += length > 0 ? text.substr(0, length) : "?";
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return result;
}
}
