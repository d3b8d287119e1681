// Tested by tests/unit/options/write_option_table_test.cpp.
#include <cover/write_option_table.hpp>

#include <cstddef>
#include <string_view>

#include "options/option_kinds.hpp"

namespace cover {
namespace {

using option_kinds::flag;
using option_kinds::named;
using option_kinds::whole;

// clang-format off
constexpr WriteOptionEntry kWriteTable[] = {
    whole<&WriteOptions::order>({
        .name = "order", .placeholder = "1|2",
        .range = ranges::kOrder,
        .help = "2: triangles with six nodes",
        .more = "Those of edges on arcs lie on the arcs; of a mesh that is read, only its manifest "
                "(.json) knows the arcs.",
        .counts_with = ".vtu, .vtm, .vtkhdf, .vtk, .msh, .pvtu, .xdmf, .mesh, .inp, .ele, .json, "
                       ".svg, .png and reports in .html"}),
    named<&WriteOptions::msh>({
        .name = "msh", .placeholder = "VERSION",
        .word_list = {"2.2", "4.1"},
        .help = "Version of .msh: 2.2 or 4.1",
        .counts_with = ".msh"}),
    named<&WriteOptions::xdmf>({
        .name = "xdmf", .placeholder = "FORM",
        .word_list = {"text", "hdf5"},
        .help = "Numbers of .xdmf: text inside, or hdf5, in X.h5 beside X.xdmf, for large meshes",
        .counts_with = ".xdmf"}),
    whole<&WriteOptions::parts>({
        .name = "parts", .placeholder = "N",
        .range = ranges::kParts,
        .help = "Parts of a .pvtu, with ghosts, owners and global ids, for as many processes; or of "
                "a .msh 4.1, as X_1.msh, X_2.msh, ...; other files beside these are whole"}),
    flag<&WriteOptions::inner_lines, false>({
        .name = "no-inner-lines",
        .help = "Leave out lines between two triangles",
        .counts_with = ".msh, .xdmf, .mesh, .inp, .ele, and .vtk with --lines"}),
    flag<&WriteOptions::lines>({
        .name = "lines",
        .help = "Lines in .vtk too, as deal.II wants them",
        .counts_with = ".vtk"}),
    named<&WriteOptions::ids>({
        .name = "ids", .placeholder = "WHAT",
        .word_list = {"region", "material", "name"},
        .help = "Numbers of triangles for solvers: region, material or name; unless given, "
                "name in .msh and .inp, else material",
        .counts_with = ".vtkhdf, .vtk, .msh, .xdmf, .mesh, .inp, .ele, .json"}),
    named<&WriteOptions::inp_element>({
        .name = "inp-element", .placeholder = "KIND",
        .word_list = {"S", "CPS", "CPE", "CAX"},
        .help = "Elements of .inp: S, CPS, CPE or CAX",
        .counts_with = ".inp"}),
};
// clang-format on

}  // namespace

std::span<const WriteOptionEntry> write_option_table() { return kWriteTable; }

const WriteOptionEntry* find_write_option(std::string_view name) {
  return option_kinds::find_in<WriteOptions>(kWriteTable, name);
}

bool counts_with(const WriteOptionEntry& entry, std::string_view extension) {
  const std::string_view all = entry.counts_with;
  for (std::size_t at = 0; (at = all.find(extension, at)) != all.npos; at += extension.size()) {
    const std::string_view rest = all.substr(at + extension.size());
    if (rest.empty() || rest.front() == ',' || rest.front() == ' ') return true;
  }
  return all.empty();
}

std::string default_text(const WriteOptionEntry& entry) { return option_kinds::default_of(entry); }

Status check_write_options(const WriteOptions& options) {
  return option_kinds::check_all<WriteOptions>(kWriteTable, options);
}

}  // namespace cover
