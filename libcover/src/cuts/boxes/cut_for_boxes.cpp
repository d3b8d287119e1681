// See cut_for_boxes.hpp.
#include "cuts/boxes/cut_for_boxes.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "cuts/boxes/cut_encroached.hpp"

namespace cover {
namespace {

constexpr std::size_t kStuckTold = 8;

void warn_of_stuck(const std::vector<Point>& stuck, std::vector<Note>& notes) {
  if (stuck.empty()) return;
  std::vector<Point> where = stuck;
  where.resize(std::min(where.size(), kStuckTold));
  notes.push_back({Note::Kind::warning, kVoid,
                   fmt::format("{} would have to be cut too short to be without a negative "
                               "coupling, the first near {}",
                               counted(stuck.size(), "segment"), describe(where[0])),
                   std::move(where)});
}

}  // namespace

void tell_box_cuts(Report& report) {
  std::erase_if(report.notes, [](const Note& note) { return note.kind == Note::Kind::box_cut; });
  if (report.box_cuts.empty()) return;
  std::map<BoxCut::Reason, std::size_t> by;
  std::vector<Point> where;
  for (const BoxCut& cut : report.box_cuts) {
    ++by[cut.reason];
    where.push_back(cut.at);
  }
  report.notes.push_back(
      {Note::Kind::box_cut, kVoid,
       fmt::format("{} added on segments ({} where points of the input encroach them, {} where "
                   "such cuts do, {} where angles need it) for --box-method",
                   counted(where.size(), "point"), by[BoxCut::Reason::encroached],
                   by[BoxCut::Reason::encroached_by_cut], by[BoxCut::Reason::given_up]),
       std::move(where)});
}

void cut_for_boxes(Prepared& prepared, const Options& options) {
  if (!options.box_method) return;
  const VertexId first_cut{prepared.pslg.points.size()};
  warn_of_stuck(cut_encroached(prepared, first_cut), prepared.report.notes);
  tell_box_cuts(prepared.report);
}

}  // namespace cover
