// See remarks_json.hpp. Tested by tests/unit/io/report/write_report_json_test.cpp.
#include "io/report/remarks_json.hpp"

namespace cover {
namespace {

const char* name_of(Note::Kind kind) {
  switch (kind) {
    case Note::Kind::fallback:
      return "fallback";
    case Note::Kind::repair:
      return "repair";
    case Note::Kind::below_resolution:
      return "below_resolution";
    case Note::Kind::target_missed:
      return "target_missed";
    case Note::Kind::bound_missed:
      return "bound_missed";
    case Note::Kind::warning:
      return "warning";
    case Note::Kind::change:
      return "change";
    case Note::Kind::cut:
      return "cut";
    case Note::Kind::box_cut:
      return "box_cut";
  }
  return "";
}

const char* name_of(Change::Kind kind) {
  switch (kind) {
    case Change::Kind::split:
      return "split";
    case Change::Kind::welded:
      return "welded";
    case Change::Kind::dropped:
      return "dropped";
    case Change::Kind::merged:
      break;
  }
  return "merged";
}

const char* name_of(InputKind kind) {
  switch (kind) {
    case InputKind::point:
      return "point";
    case InputKind::segment:
      return "segment";
    case InputKind::polygon:
      return "polygon";
    case InputKind::hole:
      return "hole";
    case InputKind::region_seed:
      return "region_seed";
    case InputKind::line:
      break;
  }
  return "line";
}

}  // namespace

nlohmann::ordered_json notes_json(const std::vector<Note>& notes) {
  auto list = nlohmann::ordered_json::array();
  for (const Note& note : notes) {
    auto where = nlohmann::ordered_json::array();
    for (const Point& p : note.where) where.push_back({p.x, p.y});
    list.push_back({{"kind", name_of(note.kind)}, {"message", note.message}, {"where", where}});
  }
  return list;
}

nlohmann::ordered_json change_json(const Change& change) {
  auto where = nlohmann::ordered_json::array(), inputs = nlohmann::ordered_json::array();
  for (const Point& p : change.where) where.push_back({p.x, p.y});
  for (const InputRef& ref : change.inputs)
    inputs.push_back({{"kind", name_of(ref.kind)}, {"id", ref.id}});
  return {{"kind", name_of(change.kind)},
          {"message", change.message},
          {"where", where},
          {"inputs", inputs}};
}

}  // namespace cover
