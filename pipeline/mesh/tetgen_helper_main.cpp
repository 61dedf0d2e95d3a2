// vallecula-tetgen INPUT OUTPUT: one run of TetGen in a process of its own, because bad input kills the process it runs
// in.
#include <tetgen.h>

#include <cstdio>

#include "pipeline/mesh/tetgen_exchange.h"

namespace {

using vallecula::pipeline::TetgenInput;
using vallecula::pipeline::TetgenOutput;

/// tetgenio frees what it is given with delete[], so the arrays are handed over to it.
void fill(tetgenio& io, const TetgenInput& input) {
  io.firstnumber = 0;
  io.numberofpoints = static_cast<int>(input.points.size());
  io.pointlist = new REAL[input.points.size() * 3];
  for (std::size_t i = 0; i < input.points.size() * 3; ++i) io.pointlist[i] = input.points[i / 3][i % 3];
  io.numberoffacets = static_cast<int>(input.triangles.size());
  io.facetlist = new tetgenio::facet[input.triangles.size()];
  for (std::size_t i = 0; i < input.triangles.size(); ++i) {
    auto& facet = io.facetlist[i];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.polygonlist->numberofvertices = 3;
    facet.polygonlist->vertexlist = new int[3]{input.triangles[i][0], input.triangles[i][1], input.triangles[i][2]};
  }
}

void fill_inner(tetgenio& io, const TetgenInput& input) {
  io.firstnumber = 0;
  io.numberofpoints = static_cast<int>(input.inner_points.size());
  io.pointlist = new REAL[input.inner_points.size() * 3];
  for (std::size_t i = 0; i < input.inner_points.size() * 3; ++i) io.pointlist[i] = input.inner_points[i / 3][i % 3];
}

int run(const TetgenInput& input, const char* output_file) {
  using namespace vallecula::pipeline;
  for (const auto& t : input.triangles) {
    for (const int corner : t) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= input.points.size()) return kHelperUnreadable;
    }
  }
  {
    // "d" only looks for self-intersections; unlike meshing it has never died of one.
    tetgenio in;
    tetgenio found;
    fill(in, input);
    std::string check = "dQ";
    tetrahedralize(check.data(), &in, &found);
    if (found.numberoftrifaces > 0) return kHelperIntersects;
  }
  tetgenio in;
  tetgenio inner;
  tetgenio out;
  fill(in, input);
  fill_inner(inner, input);
  std::string switches = input.switches;
  tetrahedralize(switches.data(), &in, &out, input.inner_points.empty() ? nullptr : &inner);
  if (out.numberoftetrahedra <= 0 || out.numberofcorners != 4) return kHelperEmpty;

  TetgenOutput result;
  result.points.resize(static_cast<std::size_t>(out.numberofpoints));
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    result.points[i] = {out.pointlist[3 * i], out.pointlist[3 * i + 1], out.pointlist[3 * i + 2]};
  }
  result.tets.resize(static_cast<std::size_t>(out.numberoftetrahedra));
  for (std::size_t i = 0; i < result.tets.size(); ++i) {
    for (int k = 0; k < 4; ++k) result.tets[i][k] = out.tetrahedronlist[4 * i + k];
  }
  return exchange::write(result, output_file) ? kHelperDone : kHelperFailed;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace vallecula::pipeline;
  if (argc != 3) {
    std::fputs("usage: vallecula-tetgen INPUT OUTPUT (called by vallecula import)\n", stderr);
    return kHelperUsage;
  }
  TetgenInput input;
  if (!exchange::read(argv[1], input)) return kHelperUnreadable;
  try {
    return run(input, argv[2]);
  } catch (...) {  // TetGen throws plain integers
    return kHelperFailed;
  }
}
