// After the "HDF5 File Format Specification Version 2.0" (The HDF Group), by whose sections
// structures are named. Everything that is looked at is paid for out of a budget in proportion to
// the file, so that structures that refer to one another, or overlap, cannot cost more.
// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtkhdf_test.cpp and tests/fuzz.
#include "io/hdf5/parse_hdf5.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <set>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
constexpr std::uint64_t kNowhere = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kRounds = 8;      // the budget: how often each byte may be looked at
constexpr std::size_t kGroupDepth = 8;  // groups, one in the other
constexpr int kTreeDepth = 16;

/// What goes wrong inside; becomes an Error at the border of the file.
struct Refusal {
  ErrorCode code = ErrorCode::syntax;
  std::string what;
};

[[noreturn]] void fail(std::string what, ErrorCode code = ErrorCode::syntax) {
  throw Refusal{code, std::move(what)};
}

/// Numbers out of a piece of the file, one after the other.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  std::string_view take(std::uint64_t size) {
    if (size > left()) fail("a structure ends before what it holds");
    const std::string_view out = bytes_.substr(at_, size);
    at_ += size;
    return out;
  }
  void skip(std::uint64_t size) { (void)take(size); }
  /// An unsigned number of so many bytes.
  std::uint64_t number(std::size_t size) {
    const std::string_view bytes = take(size);
    std::uint64_t out = 0;
    for (std::size_t k = 0; k < size; ++k)
      out |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << (8 * k);
    return out;
  }
  void pad_to(std::size_t unit) { skip(std::min(left(), (unit - at_ % unit) % unit)); }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// A type of data.
struct Type {
  Hdf5Value::Kind kind = Hdf5Value::Kind::other;
  NumberType number = NumberType::uint8;
  std::size_t size = 0;
  bool is_vlen = false;  ///< texts, each in the global heap
  std::string why;
};

struct Message {
  unsigned type = 0;
  unsigned flags = 0;
  std::string_view bytes;
};

enum MessageType : unsigned {
  kDataspace = 0x01,
  kLinkInfo = 0x02,
  kDatatype = 0x03,
  kLink = 0x06,
  kLayout = 0x08,
  kFilters = 0x0b,
  kAttribute = 0x0c,
  kContinuation = 0x10,
  kSymbolTable = 0x11,
};

Type other_type(std::string why) { return {Hdf5Value::Kind::other, {}, 0, false, std::move(why)}; }

std::optional<NumberType> whole_type(std::size_t size, bool is_signed) {
  switch (size) {
    case 1:
      return is_signed ? NumberType::int8 : NumberType::uint8;
    case 2:
      return is_signed ? NumberType::int16 : NumberType::uint16;
    case 4:
      return is_signed ? NumberType::int32 : NumberType::uint32;
    case 8:
      return is_signed ? NumberType::int64 : NumberType::uint64;
    default:
      return std::nullopt;
  }
}

/// Section IV.A.2.d.
Type parse_type(Reader in) {
  constexpr unsigned kWhole = 0, kFloat = 1, kText = 3, kVlen = 9;
  const auto head = static_cast<unsigned>(in.number(1));
  const auto bits = static_cast<unsigned>(in.number(3));
  const auto size = static_cast<std::size_t>(in.number(4));
  const unsigned kind = head & 15U;
  if (kind == kText) return {Hdf5Value::Kind::texts, {}, size, false, {}};
  if (kind == kVlen && (bits & 15U) == 1) return {Hdf5Value::Kind::texts, {}, size, true, {}};
  if (kind != kWhole && kind != kFloat) return other_type("neither numbers nor texts");
  if ((bits & 1U) != (std::endian::native == std::endian::big ? 1U : 0U))
    return other_type("numbers in the other order of bytes");
  const std::uint64_t offset = in.number(2), precision = in.number(2);
  if (offset != 0 || precision != 8 * size) return other_type("numbers with padding");
  if (kind == kWhole) {
    const auto type = whole_type(size, (bits & 8U) != 0);
    return type ? Type{Hdf5Value::Kind::numbers, *type, size, false, {}}
                : other_type("whole numbers of an odd size");
  }
  const std::uint64_t exponent_at = in.number(1), exponent = in.number(1);
  const std::uint64_t mantissa_at = in.number(1), mantissa = in.number(1), bias = in.number(4);
  const bool is_double = size == 8 && exponent_at == 52 && exponent == 11 && mantissa == 52 &&
                         bias == 1023 && mantissa_at == 0;
  const bool is_float = size == 4 && exponent_at == 23 && exponent == 8 && mantissa == 23 &&
                        bias == 127 && mantissa_at == 0;
  if (!is_double && !is_float) return other_type("floating-point numbers of an odd kind");
  return {Hdf5Value::Kind::numbers,
          is_double ? NumberType::float64 : NumberType::float32,
          size,
          false,
          {}};
}

/// Section IV.A.2.b.
std::vector<std::uint64_t> parse_space(Reader in) {
  constexpr std::uint64_t kMostDimensions = 32;
  const std::uint64_t version = in.number(1), rank = in.number(1);
  in.skip(1);
  const bool is_null = version == 2 && in.number(1) == 2;
  if (version == 1) in.skip(5);
  if ((version != 1 && version != 2) || rank > kMostDimensions)
    fail("a data space of an unknown version");
  std::vector<std::uint64_t> shape;
  std::uint64_t all = 1;
  for (std::uint64_t k = 0; k < rank; ++k) {
    shape.push_back(in.number(8));
    if (shape.back() != 0 && all > kNowhere / shape.back()) fail("a data space too large");
    all *= shape.back();
  }
  return is_null ? std::vector<std::uint64_t>{0} : shape;
}

/// One file.
class Hdf5Parser {
 public:
  explicit Hdf5Parser(std::string_view text)
      : text_(text), budget_(kRounds * text.size()), data_left_(text.size()) {}

  Hdf5Tree parse() {
    const std::uint64_t address = root();
    seen_.insert(address);
    object("/", address, 0);
    return std::move(tree_);
  }

 private:
  /// So many bytes at an address, paid for.
  Reader at(std::uint64_t address, std::uint64_t size) {
    if (address > text_.size() || size > text_.size() - address)
      fail(fmt::format("{} bytes at {} are beyond its end", size, address), ErrorCode::truncated);
    pay(size);
    return Reader(text_.substr(address, size));
  }
  void pay(std::uint64_t bytes) {
    if (bytes > budget_) fail("its structures refer to one another in circles");
    budget_ -= bytes;
  }
  void expect(Reader& in, std::string_view signature) {
    if (in.take(signature.size()) != signature)
      fail(fmt::format("no {} where one should be", signature));
  }

  /// The address of the root group. Section II.
  std::uint64_t root() {
    if (!text_.starts_with(kSignature)) fail("not a file in HDF5");
    Reader in = at(kSignature.size(), 1);
    const std::uint64_t version = in.number(1);
    constexpr std::size_t kOldSizes = 13, kNewSizes = 9;
    if (version > 3) fail("a version of HDF5 that is not known", ErrorCode::unsupported_format);
    Reader sizes = at(version < 2 ? kOldSizes : kNewSizes, 2);
    if (sizes.number(1) != 8 || sizes.number(1) != 8)
      fail("addresses of other than 8 bytes", ErrorCode::unsupported_format);
    if (version < 2) {
      constexpr std::size_t kBase = 24, kVersion1 = 4;
      Reader rest = at(kBase + kVersion1 * version, 48);
      if (rest.number(8) != 0) fail("a base address", ErrorCode::unsupported_format);
      rest.skip(32);
      return rest.number(8);
    }
    Reader rest = at(12, 32);
    if (rest.number(8) != 0) fail("a base address", ErrorCode::unsupported_format);
    rest.skip(16);
    return rest.number(8);
  }

  void object(const std::string& path, std::uint64_t address, std::size_t depth) {
    if (depth > kGroupDepth) fail("too many groups, one in the other");
    const std::vector<Message> messages = header(address);
    Hdf5Object found;
    const auto has = [&](unsigned type) { return find(messages, type) != nullptr; };
    found.is_group = has(kSymbolTable) || has(kLinkInfo) || has(kLink) || !has(kLayout);
    for (const Message& message : messages)
      if (message.type == kAttribute) attribute(message, found);
    if (!found.is_group) found.value = data_set(messages);
    const bool is_group = found.is_group;
    tree_.emplace(path, std::move(found));
    if (is_group) members(path, messages, depth + 1);
  }

  static const Message* find(const std::vector<Message>& messages, unsigned type) {
    for (const Message& message : messages)
      if (message.type == type) return &message;
    return nullptr;
  }

  // Object headers. Section IV.A.1.

  std::vector<Message> header(std::uint64_t address) {
    Reader first = at(address, 4);
    return first.take(4) == "OHDR" ? new_header(address) : old_header(address);
  }

  std::vector<Message> old_header(std::uint64_t address) {
    Reader in = at(address, 16);
    if (in.number(1) != 1) fail("no object where one should be");
    in.skip(7);
    const std::uint64_t size = in.number(4);
    std::vector<Message> messages;
    std::vector<Reader> blocks{at(address + 16, size)};
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      Reader block = blocks[b];
      while (block.left() >= 8) {
        Message message;
        message.type = static_cast<unsigned>(block.number(2));
        const std::uint64_t bytes = block.number(2);
        message.flags = static_cast<unsigned>(block.number(1));
        block.skip(3);
        message.bytes = block.take(bytes);
        if (message.type == kContinuation) {
          Reader to(message.bytes);
          const std::uint64_t where = to.number(8), length = to.number(8);
          blocks.push_back(at(where, length));
        }
        messages.push_back(message);
      }
    }
    return messages;
  }

  std::vector<Message> new_header(std::uint64_t address) {
    Reader in = at(address, 6);
    expect(in, "OHDR");
    if (in.number(1) != 2) fail("an object header of an unknown version");
    const auto flags = static_cast<unsigned>(in.number(1));
    const std::uint64_t more = ((flags & 0x20U) != 0 ? 16U : 0U) + ((flags & 0x10U) != 0 ? 4U : 0U);
    const std::size_t width = std::size_t{1} << (flags & 3U);
    Reader sized = at(address + 6 + more, width);
    const std::uint64_t size = sized.number(width);
    std::vector<Message> messages;
    std::vector<Reader> blocks{at(address + 6 + more + width, size)};
    const std::size_t head = (flags & 4U) != 0 ? 6 : 4;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      Reader block = blocks[b];
      while (block.left() >= head) {
        Message message;
        message.type = static_cast<unsigned>(block.number(1));
        const std::uint64_t bytes = block.number(2);
        message.flags = static_cast<unsigned>(block.number(1));
        block.skip(head - 4);
        message.bytes = block.take(bytes);
        if (message.type == kContinuation) {
          Reader to(message.bytes);
          const std::uint64_t where = to.number(8), length = to.number(8);
          if (length < 8) fail("a continuation too short");
          Reader chunk = at(where, length - 4);
          expect(chunk, "OCHK");
          blocks.push_back(chunk);
        }
        messages.push_back(message);
      }
    }
    return messages;
  }

  // Groups.

  void members(const std::string& path, const std::vector<Message>& messages, std::size_t depth) {
    const std::string stem = path == "/" ? path : path + "/";
    for (const Message& message : messages) {
      if (message.type == kLink) link(stem, Reader(message.bytes), depth);
      if (message.type == kLinkInfo) check_link_info(Reader(message.bytes));
      if (message.type != kSymbolTable) continue;
      Reader table(message.bytes);
      const std::uint64_t tree = table.number(8), heap = table.number(8);
      Reader in = at(heap, 32);
      expect(in, "HEAP");
      in.skip(4);
      const std::uint64_t size = in.number(8);
      in.skip(8);
      const std::uint64_t data = in.number(8);
      if (data > text_.size() || size > text_.size() - data) fail("a heap of names beyond its end");
      symbols(stem, tree, text_.substr(data, size), depth, kTreeDepth);
    }
  }

  /// Section III.A.1: a tree of tables of names.
  void symbols(const std::string& stem, std::uint64_t address, std::string_view names,
               std::size_t depth, int levels) {
    if (levels == 0) fail("a tree of names too deep");
    Reader head = at(address, 4);
    const std::string_view signature = head.take(4);
    if (signature == "SNOD") return symbol_node(stem, address, names, depth);
    if (signature != "TREE") fail("no tree of names where one should be");
    Reader in = at(address + 4, 20);
    if (in.number(1) != 0) fail("a tree of something else than names");
    in.skip(1);
    const std::uint64_t count = in.number(2);
    Reader children = at(address + 24, 16 * count + 8);
    for (std::uint64_t k = 0; k < count; ++k) {
      children.skip(8);
      symbols(stem, children.number(8), names, depth, levels - 1);
    }
  }

  void symbol_node(const std::string& stem, std::uint64_t address, std::string_view names,
                   std::size_t depth) {
    Reader head = at(address + 6, 2);
    const std::uint64_t count = head.number(2);
    Reader in = at(address + 8, 40 * count);
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t name = in.number(8), to = in.number(8), kind = in.number(4);
      in.skip(20);
      if (kind == 2 || to == kNowhere) continue;  // a symbolic link
      if (name >= names.size()) fail("a name beyond its heap");
      const std::string_view rest = names.substr(name);
      member(stem, rest.substr(0, rest.find('\0')), to, depth);
    }
  }

  /// Section IV.A.2.g.
  void link(const std::string& stem, Reader in, std::size_t depth) {
    if (in.number(1) != 1) fail("a link of an unknown version");
    const auto flags = static_cast<unsigned>(in.number(1));
    const std::uint64_t kind = (flags & 8U) != 0 ? in.number(1) : 0;
    if ((flags & 4U) != 0) in.skip(8);
    if ((flags & 16U) != 0) in.skip(1);
    const std::string_view name = in.take(in.number(std::size_t{1} << (flags & 3U)));
    if (kind == 0) member(stem, name, in.number(8), depth);
  }

  static void check_link_info(Reader in) {
    in.skip(1);
    if ((in.number(1) & 1U) != 0) in.skip(8);
    if (in.number(8) != kNowhere)
      fail("a group with a heap of links", ErrorCode::unsupported_format);
  }

  void member(const std::string& stem, std::string_view name, std::uint64_t to, std::size_t depth) {
    constexpr std::size_t kLongest = 1000;
    if (name.empty() || name.size() > kLongest) fail("a name that is empty or too long");
    if (!seen_.insert(to).second) return;  // hard links: the first name counts
    pay(stem.size() + name.size());
    object(stem + std::string(name), to, depth);
  }

  // Values.

  Hdf5Value data_set(const std::vector<Message>& messages) {
    const Message* space = find(messages, kDataspace);
    const Message* type = find(messages, kDatatype);
    if (space == nullptr || type == nullptr) fail("a data set without a type or a shape");
    const auto unread = [](std::string why) {
      Hdf5Value value;
      value.why = std::move(why);
      return value;
    };
    if ((type->flags & 2U) != 0) return unread("a type that is shared");
    if (find(messages, kFilters) != nullptr) return unread("compressed");
    Reader in(find(messages, kLayout)->bytes);
    const std::uint64_t version = in.number(1);
    if (version != 3 && version != 4) return unread("a layout of an unknown version");
    const std::uint64_t kind = in.number(1);
    if (kind > 1) return unread("in chunks");
    std::string_view bytes;
    if (kind == 0) {
      bytes = in.take(in.number(2));
    } else if (const std::uint64_t where = in.number(8); where != kNowhere) {
      const std::uint64_t size = in.number(8);
      if (where > text_.size() || size > text_.size() - where)
        fail(fmt::format("a data set of {} bytes goes beyond its end", size), ErrorCode::truncated);
      bytes = text_.substr(where, size);
    }
    if (bytes.size() > data_left_) fail("data sets share their bytes");
    data_left_ -= bytes.size();
    return value(parse_type(Reader(type->bytes)), parse_space(Reader(space->bytes)), bytes);
  }

  /// Section IV.A.2.m.
  void attribute(const Message& message, Hdf5Object& object) {
    Reader in(message.bytes);
    const std::uint64_t version = in.number(1), flags = in.number(1);
    if (version < 1 || version > 3) return;
    if (version > 1 && flags != 0) return;  // with a type or a shape that is shared
    const std::uint64_t name_size = in.number(2), type_size = in.number(2),
                        space_size = in.number(2);
    if (version == 3) in.skip(1);
    const auto part = [&](std::uint64_t size) {
      const std::string_view out = in.take(size);
      if (version == 1) in.skip(std::min<std::uint64_t>(in.left(), (8 - size % 8) % 8));
      return out;
    };
    std::string_view name = part(name_size);
    name = name.substr(0, name.find('\0'));
    const std::string_view type = part(type_size), space = part(space_size);
    Hdf5Value read =
        value(parse_type(Reader(type)), parse_space(Reader(space)), in.take(in.left()));
    object.attributes.emplace(std::string(name), std::move(read));
  }

  Hdf5Value value(const Type& type, std::vector<std::uint64_t> shape, std::string_view bytes) {
    Hdf5Value out;
    out.kind = type.kind;
    out.type = type.number;
    out.shape = std::move(shape);
    out.why = type.why;
    if (type.kind == Hdf5Value::Kind::other) return out;
    const std::uint64_t count = out.size();
    if (type.size == 0 || count > bytes.size() / type.size)
      fail("a data set with fewer bytes than its shape needs", ErrorCode::truncated);
    out.bytes = bytes.substr(0, count * type.size);
    if (type.kind == Hdf5Value::Kind::numbers) return out;
    Reader in(out.bytes);
    for (std::uint64_t k = 0; k < count; ++k)
      out.texts.emplace_back(type.is_vlen ? heap_text(in) : in.take(type.size));
    for (std::string& text : out.texts) text.resize(std::min(text.size(), text.find('\0')));
    return out;
  }

  // The global heap. Section III.E.

  std::string_view heap_text(Reader& in) {
    const std::uint64_t length = in.number(4), address = in.number(8), index = in.number(4);
    if (length == 0) return {};
    const auto& objects = collection(address);
    const auto found = objects.find(index);
    if (found == objects.end() || found->second.size() < length) fail("a text beyond its heap");
    pay(length);
    return found->second.substr(0, length);
  }

  using Collection = std::map<std::uint64_t, std::string_view>;

  const Collection& collection(std::uint64_t address) {
    const auto [known, is_new] = collections_.try_emplace(address);
    if (!is_new) return known->second;
    Reader head = at(address, 16);
    expect(head, "GCOL");
    head.skip(4);
    const std::uint64_t size = head.number(8);
    if (size < 16) fail("a heap too small for itself");
    Reader in = at(address + 16, size - 16);
    while (in.left() >= 16) {
      const std::uint64_t index = in.number(2);
      in.skip(6);
      const std::uint64_t bytes = in.number(8);
      if (index == 0) break;  // what is free
      known->second.emplace(index, in.take(bytes));
      in.pad_to(8);
    }
    return known->second;
  }

  std::string_view text_;
  std::uint64_t budget_;     ///< bytes of structures that may still be looked at
  std::uint64_t data_left_;  ///< bytes of data sets
  std::set<std::uint64_t> seen_;
  std::map<std::uint64_t, Collection> collections_;
  Hdf5Tree tree_;
};

}  // namespace

Result<Hdf5Tree> parse_hdf5(std::string_view text, const std::string& source) {
  try {
    return Hdf5Parser(text).parse();
  } catch (const Refusal& refusal) {
    return Error{refusal.code, fmt::format("{}: {}", source, refusal.what), {}, {}};
  }
}

}  // namespace cover
