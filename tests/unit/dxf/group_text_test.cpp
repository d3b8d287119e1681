#include "dxf/group_text.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(GroupText, IsReadInTheCodePageOfTheDrawing) {
  EXPECT_EQ(group_text_in_utf8("L\xe4ufer 1", "ANSI_1252"), "L\xc3\xa4ufer 1");
  EXPECT_EQ(group_text_in_utf8("L\xe4ufer 1", ""), "L\xc3\xa4ufer 1");
  EXPECT_EQ(group_text_in_utf8("\xf1", "ANSI_1251"), "\xd1\x81");  // a Cyrillic es
  EXPECT_EQ(group_text_in_utf8("\x84", "dos850"), "\xc3\xa4");
  EXPECT_EQ(group_text_in_utf8("\xb0\xa1", "ksc5601"), "\xea\xb0\x80");
  EXPECT_EQ(group_text_in_utf8("T\xf4"
                               "a",
                               "ANSI_1258"),
            "T\xc3\xb4"
            "a");
}

TEST(GroupText, UnicodeStaysAsItIs) {
  EXPECT_EQ(group_text_in_utf8("L\xc3\xa4ufer", "ANSI_1252"), "L\xc3\xa4ufer");
  EXPECT_EQ(group_text_in_utf8("", "ANSI_1252"), "");
}

TEST(GroupText, CharactersByTheirNumbers) {
  EXPECT_EQ(group_text_in_utf8("L\\U+00E4ufer \\U+2126", ""), "L\xc3\xa4ufer \xe2\x84\xa6");
  EXPECT_EQ(group_text_in_utf8("L\\U+00e4", ""), "L\xc3\xa4");
  for (const char* const no_character : {"\\U+", "\\U+12", "\\U+00GG", "\\U+D800", "\\U+0007"})
    EXPECT_EQ(group_text_in_utf8(no_character, ""), no_character);
}

TEST(GroupText, SymbolsOfAutoCad) {
  EXPECT_EQ(with_symbols("%%c20 T%%D %%P0.1"),
            "\xe2\x8c\x80"
            "20 T\xc2\xb0 \xc2\xb1"
            "0.1");
  EXPECT_EQ(with_symbols("%%uHolz%%U %%oa%%O %%kb"), "Holz a b");
  EXPECT_EQ(with_symbols("5%%% %%065%%228"), "5% A\xc3\xa4");
  for (const char* const none : {"", "5%", "%%", "%%x", "%%12", "%%007", "%%300", "%%1a2"})
    EXPECT_EQ(with_symbols(none), none);
}

TEST(GroupText, WhatIsNoTextStays) {
  EXPECT_EQ(group_text_in_utf8("\xe4", "no code page"), "\xe4");
  EXPECT_EQ(group_text_in_utf8("\x81", "ANSI_1252"), "\x81");  // which has none
  // In EBCDIC there is a line break in it.
  EXPECT_EQ(group_text_in_utf8("\xc1\x25\xf7", "ANSI_037"), "\xc1\x25\xf7");
}

}  // namespace
}  // namespace cover
