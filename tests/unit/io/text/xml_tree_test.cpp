#include "io/text/xml_tree.hpp"

#include <gtest/gtest.h>

#include "io/text/limits.hpp"

namespace cover {
namespace {

const std::string kFile = "a.xml";

TEST(XmlTree, HoldsElementsAttributesAndText) {
  const std::string text =
      "<?xml version=\"1.0\"?><!-- c --><a x=\"1 &amp; &#xe9;\">\n <b Name=\"p\"> 1 2\n<c/>3</b>"
      "<b Name=\"q\"><c>no</c> 4 <!-- c --> 5</b><b/></a>\n";
  const Result<XmlTree> tree = parse_xml(text, kFile);
  ASSERT_TRUE(tree) << tree.error().message;
  EXPECT_EQ(tree->root.name, "a");
  ASSERT_NE(tree->root.attribute("x"), nullptr);
  EXPECT_EQ(*tree->root.attribute("x"), "1 & \xc3\xa9");
  EXPECT_EQ(tree->root.attribute("y"), nullptr);
  EXPECT_EQ(tree->root.text, "");
  ASSERT_EQ(tree->root.children.size(), 3U);
  EXPECT_EQ(tree->root.child("b", "p")->text, "1 2");
  EXPECT_EQ(tree->root.child("b", "q")->text, "4");
  EXPECT_EQ(tree->root.child("b", "r"), nullptr);
  EXPECT_EQ(tree->root.child("b")->child("c")->name, "c");
  EXPECT_EQ(tree->root.children[2].text, "");
}

TEST(XmlTree, StopsWhereBytesFollow) {
  const std::string text = std::string("<a><b/><data x=\"1\"> _") + '\0' + "\xff<";
  const Result<XmlTree> tree = parse_xml(text, kFile, "data");
  ASSERT_TRUE(tree) << tree.error().message;
  EXPECT_EQ(tree->root.children.size(), 2U);
  EXPECT_EQ(*tree->root.child("data")->attribute("x"), "1");
  EXPECT_EQ(tree->rest, std::string(" _") + '\0' + "\xff<");
}

ErrorCode code_of(const std::string& text) {
  const Result<XmlTree> tree = parse_xml(text, kFile);
  EXPECT_FALSE(tree);
  return tree ? ErrorCode::internal : tree.error().code;
}

TEST(XmlTree, TellsWhatIsCutOffFromWhatIsWrong) {
  const std::string whole = "<a><b x=\"1\">text</b></a>";
  ASSERT_TRUE(parse_xml(whole, kFile));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_EQ(code_of(whole.substr(0, size)), ErrorCode::truncated) << size;
  EXPECT_EQ(code_of("<a></b>"), ErrorCode::syntax);
  EXPECT_EQ(code_of("rubbish"), ErrorCode::syntax);
  EXPECT_EQ(code_of("<a/><b/>"), ErrorCode::syntax);
  EXPECT_EQ(parse_xml("<a>\n<b>\n</a>", kFile).error().message,
            "a.xml:3: no valid XML: mismatched tag");
}

TEST(XmlTree, RefusesDepthNumberAndEntities) {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t k = 0; k < depth; ++k) text += "<a>";
    for (std::size_t k = 0; k < depth; ++k) text += "</a>";
    return text;
  };
  EXPECT_TRUE(parse_xml(nested(kXmlDepth), kFile));
  EXPECT_EQ(code_of(nested(kXmlDepth + 1)), ErrorCode::unsupported_format);
  EXPECT_EQ(code_of(nested(1'000'000)), ErrorCode::unsupported_format);
  std::string many = "<a>";
  for (std::size_t k = 0; k < kXmlElements; ++k) many += "<b/>";
  EXPECT_EQ(code_of(many + "</a>"), ErrorCode::unsupported_format);
  EXPECT_EQ(code_of("<!DOCTYPE a [<!ENTITY e \"ee\">]><a>&e;</a>"), ErrorCode::unsupported_format);
  EXPECT_TRUE(parse_xml("<!DOCTYPE a SYSTEM \"a.dtd\" []><a/>", kFile));
}

TEST(XmlTree, WhatReferencesStandFor) {
  EXPECT_EQ(without_references("a&amp;b&lt;&gt;&quot;&apos;c"), "a&b<>\"'c");
  EXPECT_EQ(without_references("&amp;lt; &other; &"), "&lt; &other; &");
}

}  // namespace
}  // namespace cover
