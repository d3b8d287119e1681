// expat tells where tags begin and end; text is never copied.
// Tested by tests/unit/io/text/xml_tree_test.cpp.
#include "io/text/xml_tree.hpp"

#include <expat.h>

#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <new>
#include <optional>

#include <fmt/core.h>

#include "base/words/characters.hpp"
#include "io/text/limits.hpp"

namespace cover {
namespace {

/// What expat is given at once: its lengths are ints.
constexpr std::size_t kChunk = std::size_t{1} << 24U;

/// Takes expat's calls. Exceptions must not pass through its C code: they are kept and thrown
/// again behind it.
class Builder {
 public:
  Builder(std::string_view text, const std::string& source, std::string_view stop_at)
      : text_(text), source_(source), stop_at_(stop_at), parser_(XML_ParserCreate(nullptr)) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), &started, &ended);
    XML_SetCommentHandler(parser_.get(), [](void* self, const XML_Char*) { of(self).comment(); });
    XML_SetEntityDeclHandler(
        parser_.get(), [](void* self, const XML_Char*, int, const XML_Char*, int, const XML_Char*,
                          const XML_Char*, const XML_Char*, const XML_Char*) {
          of(self).refuse("documents that declare entities are not read");
        });
  }

  Result<XmlTree> build() {
    for (std::size_t at = 0; !stopped_;) {
      const std::size_t size = std::min(kChunk, text_.size() - at);
      const bool last = at + size == text_.size();
      const XML_Status status = XML_Parse(parser_.get(), text_.data() + at, static_cast<int>(size),
                                          static_cast<int>(last));
      if (thrown_) std::rethrow_exception(thrown_);
      if (refusal_) return std::move(*refusal_);
      if (stopped_) break;
      if (status != XML_STATUS_OK) return syntax_error();
      if (last) break;
      at += size;
    }
    // Where the parser was stopped, the elements around have no end.
    while (open_.size() > 1) close();
    tree_.root = std::move(open_.front().element);
    return std::move(tree_);
  }

 private:
  /// An element whose end has not come.
  struct Open {
    XmlElement element;
    std::size_t text_begin = 0;
  };

  static Builder& of(void* self) { return *static_cast<Builder*>(self); }

  static void started(void* self, const XML_Char* name, const XML_Char** attributes) {
    of(self).guarded([&] { of(self).start(name, attributes); });
  }
  static void ended(void* self, const XML_Char*) {
    of(self).guarded([&] { of(self).end(); });
  }

  template <class Call>
  void guarded(Call call) {
    if (stopped_ || refusal_ || thrown_) return;  // expat may call once more after it was stopped
    try {
      call();
    } catch (...) {
      thrown_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  void refuse(std::string_view why) {
    guarded([&] {
      refusal_ =
          Error{ErrorCode::unsupported_format,
                fmt::format("{}:{}: {}", source_, XML_GetCurrentLineNumber(parser_.get()), why),
                {},
                {}};
      XML_StopParser(parser_.get(), XML_FALSE);
    });
  }

  void start(const XML_Char* name, const XML_Char** attributes) {
    if (open_.size() == kXmlDepth)
      return refuse(fmt::format("more than {} elements, one in the other", kXmlDepth));
    if (++elements_ > kXmlElements)
      return refuse(fmt::format("more than {} elements", kXmlElements));
    if (!open_.empty()) take_text();
    Open open;
    open.element.name = name;
    for (; *attributes != nullptr; attributes += 2)
      open.element.attributes.emplace_back(attributes[0], attributes[1]);
    open.text_begin = token_end();
    open_.push_back(std::move(open));
    if (stop_at_.empty() || stop_at_ != name) return;
    tree_.rest = text_.substr(token_end());
    stopped_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void end() {
    take_text();
    if (open_.size() == 1) return;  // the root stays
    close();
    open_.back().text_begin = token_end();
  }

  void comment() {
    guarded([&] {
      if (open_.empty()) return;
      take_text();
      open_.back().text_begin = token_end();
    });
  }

  void close() {
    XmlElement element = std::move(open_.back().element);
    open_.pop_back();
    open_.back().element.children.push_back(std::move(element));
  }

  /// Takes the text up to the current tag if the element has none yet.
  void take_text() {
    Open& open = open_.back();
    const std::size_t end = token_begin();
    // The end of <empty/> is where it begins.
    if (!open.element.text.empty() || end <= open.text_begin) return;
    open.element.text = trimmed(text_.substr(open.text_begin, end - open.text_begin));
  }

  [[nodiscard]] std::size_t token_begin() const {
    const XML_Index at = XML_GetCurrentByteIndex(parser_.get());
    return at < 0 ? text_.size() : std::min(static_cast<std::size_t>(at), text_.size());
  }
  [[nodiscard]] std::size_t token_end() const {
    const int count = XML_GetCurrentByteCount(parser_.get());
    return std::min(token_begin() + static_cast<std::size_t>(std::max(count, 0)), text_.size());
  }

  [[nodiscard]] Error syntax_error() const {
    const XML_Error code = XML_GetErrorCode(parser_.get());
    if (code == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    const bool cut_off = code == XML_ERROR_NO_ELEMENTS || code == XML_ERROR_UNCLOSED_TOKEN ||
                         code == XML_ERROR_PARTIAL_CHAR || code == XML_ERROR_UNCLOSED_CDATA_SECTION;
    const auto line = XML_GetCurrentLineNumber(parser_.get());
    return cut_off
               ? Error{ErrorCode::truncated,
                       fmt::format("{}:{}: the file ends before its XML does: it was cut off",
                                   source_, line),
                       {},
                       {}}
               : Error{ErrorCode::syntax,
                       fmt::format("{}:{}: no valid XML: {}", source_, line, XML_ErrorString(code)),
                       {},
                       {}};
  }

  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  std::string_view text_;
  const std::string& source_;
  std::string_view stop_at_;
  std::unique_ptr<XML_ParserStruct, Free> parser_;
  XmlTree tree_;
  std::vector<Open> open_;  ///< from the root inwards
  std::size_t elements_ = 0;
  bool stopped_ = false;
  std::optional<Error> refusal_;
  std::exception_ptr thrown_;
};

}  // namespace

const std::string* XmlElement::attribute(std::string_view attribute_name) const {
  for (const auto& [name_of, value] : attributes)
    if (name_of == attribute_name) return &value;
  return nullptr;
}

std::string_view XmlElement::value(std::string_view attribute_name) const {
  const std::string* found = attribute(attribute_name);
  return found == nullptr ? std::string_view() : *found;
}

const XmlElement* XmlElement::child(std::string_view child_name) const {
  for (const XmlElement& element : children)
    if (element.name == child_name) return &element;
  return nullptr;
}

const XmlElement* XmlElement::child(std::string_view child_name, std::string_view named) const {
  for (const XmlElement& element : children) {
    if (element.name != child_name) continue;
    const std::string* found = element.attribute("Name");
    if (found != nullptr && *found == named) return &element;
  }
  return nullptr;
}

Result<XmlTree> parse_xml(std::string_view text, const std::string& source,
                          std::string_view stop_at) {
  return Builder(text, source, stop_at).build();
}

std::string without_references(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kReferences{
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string out;
  while (!text.empty()) {
    const auto* const reference =
        std::find_if(kReferences.begin(), kReferences.end(),
                     [&](const auto& entry) { return text.starts_with(entry.first); });
    const bool found = reference != kReferences.end();
    out += found ? reference->second : text.front();
    text.remove_prefix(found ? reference->first.size() : 1);
  }
  return out;
}

}  // namespace cover
