// XML as a tree of elements. expat does the parsing; what a file may hold is limited here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cover/result.hpp>

namespace cover {

/// An element with what stands in it.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;
  /// The first text right inside the element that is not blank, up to the next tag or comment. It
  /// is a piece of the source as it stands there, so references like &amp; stay in it;
  /// without_references() puts what they mean in their place.
  std::string_view text;

  /// The value of an attribute; nullptr where there is none.
  [[nodiscard]] const std::string* attribute(std::string_view attribute_name) const;
  /// The same; empty where there is none.
  [[nodiscard]] std::string_view value(std::string_view attribute_name) const;
  /// The first child of a name, and with a given attribute Name if `named` is there; or nullptr.
  [[nodiscard]] const XmlElement* child(std::string_view child_name) const;
  [[nodiscard]] const XmlElement* child(std::string_view child_name, std::string_view named) const;
};

/// A document's root, and what follows the start tag at which the parser stopped; or nothing.
struct XmlTree {
  XmlElement root;
  std::string_view rest;
};

/// Parses a whole document, or all of it up to the start tag of the first element called `stop_at`:
/// behind it may stand bytes that are no XML. The tree holds pieces of `text`.
///
/// Errors: syntax and truncated, with the line; unsupported_format for elements deeper or more than
///         limits.hpp allows, and for documents that declare entities.
/// Cost:   O(n)
Result<XmlTree> parse_xml(std::string_view text, const std::string& source,
                          std::string_view stop_at = {});

/// `text` of an element with the characters that &amp;, &lt;, &gt;, &quot; and &apos; stand for.
std::string without_references(std::string_view text);

}  // namespace cover
