"""Recipe of tests/truth/static_indentation.json: static forces of a rigid plate or sphere pressed into soft tissue.

Purpose: independent figures to hold the engine to. Two kinds are computed, by energies and Newton's method in
indentation_solver.py (formulation and sources stand there), without any code of the engine:

  continuum    the converged boundary value problem: quadratic elements on a quarter of the body (exact symmetry),
               law "small" (small-strain linear elasticity), and at finite strain "corotational" (what the engine's law
               tends to as its mesh is refined) and "neo-hookean" (to see how much the choice of law matters);
  same-law     linear tetrahedra with nodally averaged volume ratio on the engine's own kind of mesh, to equilibrium.

and, where a deep press would lose more of the whole volume than a tongue may, both once with and once without a bound:

  volume-held  the whole is to keep 99.3 % of its volume at least: one inequality with its multiplier, which is a
               uniform pressure. Tetrahedra have the engine's squash barrier (below det F = 0.3); how many met it is
               written: none, the least det F is 0.399 (block-11664 at 5 mm and nu 0.45).

Scenes
  block        40 x 40 x 20 mm, base fixed, E = 6000 Pa; tools centred on the top.
  tongue       ellipsoid, semi-axes 22.5 x 15 x 10 mm, E = 10000 Pa; tetrahedral meshes t5k and t20k (files .node .ele
               .fix, 0-based, metres). Their fixed nodes are all those below z = -10/3 mm, so the continuum is the part
               above that plane, fixed on it. Depth is measured from z = 10 mm, the top of the true ellipsoid.
  tools        plate: horizontal, 20 x 20 mm, a point of the surface belonging to it if its place at rest is under the
               footprint; sphere: radius 5 mm, signed distance at the displaced place. No friction, unilateral.
               Continuum: a stiff penalty at quadrature points (its share is below 0.05 %). Same law: exact, at the
               surface's vertices (lattice-1), or also at the points of a lattice of order 3 on each triangle.
  depths       0.5, 1.0, 1.5, 2.0 mm; volume-held 1 to 5 mm, continuum to 3 mm. A slope is the secant from the depth
               before (the first: from zero).

Run (Python 3.11 or later; pip install numpy scipy scikit-fem gmsh pypardiso; pypardiso is optional, scikit-fem serves
one check):

    OMP_NUM_THREADS=1 python static_indentation.py --lab <folder of t5k.node ...> --out static_indentation.json

`--only TEXT` runs the cases whose name holds TEXT and leaves the others in the file as they are; `--list` names them.
Run time: about 32 minutes on one core, with pypardiso; no case takes more than two and a half.
"""
import argparse
import importlib.metadata
import json
import pathlib
import platform
import time

import numpy as np
import scipy.sparse as sp

import indentation_solver as fe

DEPTHS = (0.0005, 0.001, 0.0015, 0.002)
POISSON = (0.30, 0.45, 0.49)
PLATE_HALF, SPHERE_RADIUS = 0.010, 0.005
BLOCK_SIZE, BLOCK_YOUNG = np.array([0.04, 0.04, 0.02]), 6000.0
TONGUE_AXES, TONGUE_BASE, TONGUE_YOUNG = np.array([0.0225, 0.015, 0.010]), -0.01 / 3, 10000.0
HELD_DEPTHS = (0.001, 0.002, 0.003, 0.004, 0.005)
LEAST_VOLUME, BARRIER = 0.993, (0.3, 60.0)
PENALTY = 2e10  # Pa/m, of quadrature points: a pressure of 4 kPa sinks in 0.2 micrometres


def tool_at(name, z):
    if name == "plate":
        return fe.Plate(PLATE_HALF, z)
    return fe.Sphere(SPHERE_RADIUS, z)


# --- Continuum: meshes of a quarter of the body ----------------------------------------------------------------------

def graded(start, end, first, last):
    """Cell boundaries from start to end whose sizes go about geometrically from `first` to `last`."""
    length = end - start
    if np.isclose(first, last):
        return np.linspace(start, end, max(1, round(length / first)) + 1)
    count = max(1, round(np.log(last / first) * length / (last - first)))
    sizes = first * (last / first) ** ((np.arange(count) + 0.5) / count)
    return start + length * np.concatenate([[0], np.cumsum(sizes)]) / sizes.sum()


def join(*parts):
    return np.concatenate([parts[0]] + [p[1:] for p in parts[1:]])


def block_hexahedra(tool, h, edge=80):
    """Hexahedra of 27 nodes, finest at the plate's edge (h / edge, else h) or under the sphere (h, else up to 8 h)."""
    mm = 1e-3
    if tool == "plate":
        axis = join(graded(0, 10 * mm, h, h / edge), graded(10 * mm, 20 * mm, h / edge, h))
        depth = graded(0, 20 * mm, 1.5 * h, 2 * h / edge)
    else:
        near = 4 * mm
        axis = join(graded(0, near, h, h), graded(near, 20 * mm, h, 8 * h))
        depth = join(graded(0, 20 * mm - near, 8 * h, h), graded(20 * mm - near, 20 * mm, h, h))
    fine = lambda cells: np.interp(np.arange(2 * len(cells) - 1) / 2, np.arange(len(cells)), cells)
    x, z = fine(axis), fine(depth)
    nx, nz = len(x), len(z)
    grid = np.arange(nx * nx * nz).reshape(nz, nx, nx)
    nodes = np.stack([a.ravel() for a in np.meshgrid(z, x, x, indexing="ij")][::-1], -1)
    cells = np.stack([grid[k:nz - 2 + k:2, j:nx - 2 + j:2, i:nx - 2 + i:2].ravel()
                      for k in range(3) for j in range(3) for i in range(3)], -1)
    faces = np.stack([grid[-1, j:nx - 2 + j:2, i:nx - 2 + i:2].ravel() for j in range(3) for i in range(3)], -1)
    return {"nodes": nodes, "cells": cells, "held": held_in_quarter(nodes, 0), "reference": fe.hex27(),
            "element": "hexahedron, 27 nodes", "contact": surface_points(nodes, faces, fe.quad9(), tool)}


def quarter_tetrahedra(scene, tool, h):
    """Tetrahedra of 10 nodes, curved at the ellipsoid; h: size under the tool."""
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    mm, occ = 1e-3, gmsh.model.occ
    # In millimetres: Gmsh's tolerances are made for numbers near one.
    if scene == "block":
        occ.addBox(0, 0, 0, *(BLOCK_SIZE / mm * [0.5, 0.5, 1]))
        base, top = 0.0, BLOCK_SIZE[2]
    else:
        ball = occ.addSphere(0, 0, 0, 1)
        occ.dilate([(3, ball)], 0, 0, 0, *(TONGUE_AXES / mm))
        occ.intersect([(3, ball)], [(3, occ.addBox(0, 0, TONGUE_BASE / mm, 50, 50, 50))])
        base, top = TONGUE_BASE, TONGUE_AXES[2]
    occ.synchronize()
    field = gmsh.model.mesh.field
    ball = field.add("Ball")
    sphere = tool == "sphere"
    for key, value in (("XCenter", 0), ("YCenter", 0), ("ZCenter", top / mm), ("Radius", 4 if sphere else 10),
                       ("VIn", h / mm), ("VOut", (4 if sphere else 1.5) * h / mm), ("Thickness", 8)):
        field.setNumber(ball, key, value)
    field.setAsBackgroundMesh(ball)
    for key in ("Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints", "Mesh.MeshSizeFromCurvature"):
        gmsh.option.setNumber(key, 0)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(2)
    tags, at, _ = gmsh.model.mesh.getNodes()
    place = np.zeros(int(tags.max()) + 1, int)
    place[tags.astype(int)] = np.arange(len(tags))
    nodes = at.reshape(-1, 3) * mm
    cells = place[gmsh.model.mesh.getElementsByType(11)[1].astype(int)].reshape(-1, 10)
    faces = place[gmsh.model.mesh.getElementsByType(9)[1].astype(int)].reshape(-1, 6)
    gmsh.finalize()
    used = np.unique(cells)
    number = np.full(len(nodes), -1)
    number[used] = np.arange(len(used))
    nodes, cells, faces = nodes[used], number[cells], number[faces]
    if scene == "block":
        on_top = np.abs(nodes[:, 2] - top) < 1e-9
    else:
        on_top = np.abs(((nodes / TONGUE_AXES) ** 2).sum(1) - 1) < 1e-5
    faces = faces[on_top[faces].all(1) & (nodes[faces][:, :, 2].min(1) > 0)]
    return {"nodes": nodes, "cells": cells, "held": held_in_quarter(nodes, base), "reference": fe.tet10(),
            "element": "tetrahedron, 10 nodes", "contact": surface_points(nodes, faces, fe.tri6(), tool)}


def held_in_quarter(nodes, base):
    """Base fixed; no normal displacement on the planes x = 0 and y = 0 of symmetry."""
    held = np.zeros(nodes.shape, bool)
    held[nodes[:, 2] < base + 1e-9] = True
    held[nodes[:, 0] < 1e-9, 0] = held[nodes[:, 1] < 1e-9, 1] = True
    return held


def surface_points(nodes, faces, reference, tool):
    """Quadrature points of the faces a tool may reach: (matrix from the nodes, area of each)."""
    values, gradients, weights = reference
    middle = nodes[faces].mean(1)
    if tool == "sphere":
        faces = faces[np.hypot(middle[:, 0], middle[:, 1]) < 0.0042]
    else:
        faces = faces[(middle[:, :2] < PLATE_HALF + 0.001).all(1)]
    tangent = np.einsum("fai,qad->fqid", nodes[faces], gradients)
    area = np.linalg.norm(np.cross(tangent[..., 0], tangent[..., 1]), axis=-1) * weights
    nq, na = values.shape
    count = len(faces) * nq
    columns = np.repeat(faces[:, None, :], nq, 1).reshape(-1)
    points = sp.csr_matrix((np.tile(values, (len(faces), 1)).ravel(), (np.repeat(np.arange(count), na), columns)),
                           shape=(count, len(nodes)))
    return points, area.ravel()


def slope_by_scikit_fem(poisson, h):
    """Slope (N/m) of the plate on the block by another program on the mesh of block_hexahedra: all of the footprint
    held down, which is the contact problem's solution as long as it only pushes."""
    from skfem import Basis, ElementHex2, ElementVector, MeshHex, asm, condense, solve
    from skfem.models.elasticity import lame_parameters, linear_elasticity
    nodes = block_hexahedra("plate", h)["nodes"]
    x, z = (np.unique(nodes[:, i].round(12))[::2] for i in (0, 2))
    basis = Basis(MeshHex.init_tensor(x, x, z), ElementVector(ElementHex2()))
    matrix = asm(linear_elasticity(*lame_parameters(BLOCK_YOUNG, poisson)), basis)
    top = BLOCK_SIZE[2]
    at = basis.doflocs
    # A freedom's component is found from the basis itself: doflocs holds three at every place.
    part = {c: np.concatenate([basis.nodal_dofs[i], basis.edge_dofs[i], basis.facet_dofs[i], basis.interior_dofs[i]])
            for i, c in enumerate("xyz")}
    on = lambda c, test: part[c][test(at[:, part[c]])]
    pressed = on("z", lambda p: (p[2] > top - 1e-9) & (p[0] < PLATE_HALF + 1e-9) & (p[1] < PLATE_HALF + 1e-9))
    held = np.unique(np.concatenate([pressed, on("x", lambda p: p[0] < 1e-9), on("y", lambda p: p[1] < 1e-9)]
                                    + [on(c, lambda p: p[2] < 1e-9) for c in "xyz"]))
    u = basis.zeros()
    u[pressed] = -1.0
    u = solve(*condense(matrix, x=u, D=held))
    result = {"inputs": {"young_pa": BLOCK_YOUNG, "poisson": poisson}, "h_mm": h * 1e3,
              "unknowns": int(basis.N - len(held)), "slope_n_per_m": [float(f"{-4 * (matrix @ u)[pressed].sum():.7g}")]}
    print("   ", result, flush=True)
    return result


def run_continuum(scene, tool, law, poisson, sizes, hexahedra=False, penalty=PENALTY):
    top, young = (BLOCK_SIZE[2], BLOCK_YOUNG) if scene == "block" else (TONGUE_AXES[2], TONGUE_YOUNG)
    meshes = []
    for h in sizes:
        start = time.time()
        mesh = block_hexahedra(tool, h) if hexahedra else quarter_tetrahedra(scene, tool, h)
        body = fe.Elastic(mesh["nodes"], mesh["cells"], mesh["reference"], law, young, poisson, mesh["held"])
        solid = fe.Condensed(body, mesh["contact"][0]) if law == "small" else body
        contact = fe.Contact(solid, *mesh["contact"], penalty)
        u, forces, worst, solves = np.zeros(solid.size), [], 0.0, 0
        for depth in DEPTHS:
            # A soft contact first finds what touches: the stiff one alone takes many more solves from far off.
            for contact.stiffness, within in ((penalty / 100, 1e-4), (penalty / 10, 1e-4), (penalty, 1e-7)):
                u, force, residual, _, n = fe.equilibrate(solid, contact, tool_at(tool, top - depth), u, within, False)
                solves += n
            if residual > 1e-6:
                raise ArithmeticError(f"no equilibrium at {depth} m: {residual} N left")
            forces.append(4 * force)
            worst = max(worst, residual)
        body.factor.release()
        meshes.append({"element": mesh["element"], "h_mm": h * 1e3, "elements": len(mesh["cells"]),
                       "unknowns": body.size, "contact_points": len(contact.rest), "residual_n": worst,
                       "newton_solves": solves, "seconds": round(time.time() - start, 1), **with_slopes(forces)})
        print("   ", meshes[-1], flush=True)
    result = {"inputs": {"young_pa": young, "poisson": poisson, "penalty_pa_per_m": penalty}, "meshes": meshes,
              "force_n": meshes[-1]["force_n"], "slope_n_per_m": meshes[-1]["slope_n_per_m"]}
    if len(meshes) > 1:
        change = lambda key: max(abs(b / a - 1) for a, b in zip(meshes[-2][key], meshes[-1][key]))
        result["change_between_two_finest"] = {"force": round(change("force_n"), 5),
                                               "slope": round(change("slope_n_per_m"), 5)}
    return result


# --- Same law: linear tetrahedra -------------------------------------------------------------------------------------

def block_tets(cells, quarter=False):
    """Each cell in six tetrahedra about its diagonal, the six paths along the axes from corner to corner."""
    size = BLOCK_SIZE * ([0.5, 0.5, 1] if quarter else [1, 1, 1])
    n = np.array(cells) + 1
    index = np.stack(np.meshgrid(*(np.arange(k) for k in n), indexing="ij"), -1).transpose(2, 1, 0, 3).reshape(-1, 3)
    nodes = index * size / cells - (np.zeros(3) if quarter else BLOCK_SIZE / 2 * [1, 1, 0])
    stride = np.array([1, n[0], n[0] * n[1]])
    corner = index[(index < n - 1).all(1)] @ stride
    tets = []
    for path in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)):
        tets.append(corner[:, None] + np.concatenate([[0], np.cumsum(stride[list(path)])]))
    return nodes, np.concatenate(tets), np.flatnonzero(index[:, 2] == 0)


def read_tets(stem):
    nodes = np.loadtxt(f"{stem}.node", skiprows=1)[:, 1:4]
    tets = np.loadtxt(f"{stem}.ele", skiprows=1, dtype=int)[:, 1:5]
    return nodes, tets, np.loadtxt(f"{stem}.fix", dtype=int)


def upright(nodes, tets):
    x = nodes[tets]
    turned = np.linalg.det(x[:, 1:] - x[:, :1]) < 0
    tets = tets.copy()
    tets[turned, 2], tets[turned, 3] = tets[turned, 3], tets[turned, 2].copy()
    return tets


def lattice(nodes, tets, order):
    """Surface vertices and, for order > 1, the points of a lattice of that order on every surface triangle."""
    faces = np.sort(np.concatenate([tets[:, f] for f in ([0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3])]), axis=1)
    faces, count = np.unique(faces, axis=0, return_counts=True)
    faces = faces[count == 1]
    faces = faces[nodes[faces][:, :, 2].mean(1) > 0]
    rows = {}
    for face in faces:
        for i in range(order + 1):
            for j in range(order + 1 - i):
                part = [(int(v), k) for v, k in zip(face, (order - i - j, i, j)) if k]
                rows[tuple(part)] = None
    entries = [(r, v, k / order) for r, part in enumerate(rows) for v, k in part]
    r, v, k = zip(*entries)
    return sp.csr_matrix((k, (r, v)), shape=(len(rows), len(nodes)))


def run_tets(nodes, tets, fixed, top, young, poisson, tool, order, quarter=False):
    start = time.time()
    held = np.zeros(nodes.shape, bool)
    held[fixed] = True
    if quarter:
        held |= held_in_quarter(nodes, 0)
    body = fe.Elastic(nodes, upright(nodes, tets), fe.tet4(), "averaged", young, poisson, held)
    points = lattice(nodes, tets, order)
    rest = points @ nodes
    reach = 0.0065 if tool == "sphere" else PLATE_HALF + 0.003
    near = (np.abs(rest[:, :2]) <= reach).all(1) & (rest[:, 2] > top - 0.006)
    contact = fe.Contact(body, points[near], np.ones(near.sum()), 5e3)
    u, out = np.zeros(body.size), {"force_n": [], "residual_n": [], "penetration_m": [], "touching": []}
    for depth in DEPTHS:
        u, force, residual, penetration, solves = fe.equilibrate(body, contact, tool_at(tool, top - depth), u)
        out["force_n"].append(4 * force if quarter else force)
        out["residual_n"].append(residual)
        out["penetration_m"].append(penetration)
        out["touching"].append(int((contact.multiplier > 0).sum()))
    body.factor.release()
    result = {"inputs": {"young_pa": young, "poisson": poisson, "lattice_order": order},
              "mesh": {"element": "tetrahedron, 4 nodes", "elements": len(tets), "nodes": len(nodes),
                       "fixed_nodes": len(fixed), "constraint_points": int(near.sum())},
              **with_slopes(out["force_n"]), "residual_n": max(out["residual_n"]),
              "penetration_m": max(out["penetration_m"]), "touching": out["touching"],
              "seconds": round(time.time() - start, 1)}
    print("   ", result, flush=True)
    return result


# --- Volume held -----------------------------------------------------------------------------------------------------

def press_held(body, contact, depths, factor, **how):
    """Figures of the plate on the block at each depth in turn; `factor`: whole body over the part that is meshed.

    squashed: tetrahedra (continuum: quadrature points, where it has no meaning) below the barrier's det F.
    """
    u, out = np.zeros(body.size), []
    stiffness = contact.stiffness
    for depth in depths:
        # As in run_continuum a soft penalty first; multipliers at points need none.
        for share in (1,) if how.get("exact", True) else (0.01, 0.1, 1):
            contact.stiffness = stiffness * share
            u, force, residual, _, _ = fe.equilibrate(body, contact, tool_at("plate", BLOCK_SIZE[2] - depth), u, **how)
        if residual > 1e-6:
            raise ArithmeticError(f"no equilibrium at {depth} m: {residual} N left")
        j = body.determinants(u)
        out.append({"depth_m": depth, "force_n": float(f"{factor * force:.7g}"),
                    "holding_pressure_pa": float(f"{body.holding:.6g}"), "volume_ratio": round(body.volume_ratio(u), 8),
                    "least_det_f": round(float(j.min()), 4), "squashed": int((j < BARRIER[0]).sum()),
                    "residual_n": residual})
        print("   ", out[-1], flush=True)
    body.factor.release()
    return out


def with_ratios(held, free):
    return {"held": held, "free": free,
            "held_over_free": [round(a["force_n"] / b["force_n"], 5) for a, b in zip(held, free)]}


def run_held_tets(cells, poisson):
    start, results = time.time(), []
    nodes, tets, fixed = block_tets(cells)
    bonded = np.zeros(nodes.shape, bool)
    bonded[fixed] = True
    points = lattice(nodes, tets, 1)
    rest = points @ nodes
    points = points[(np.abs(rest[:, :2]) <= PLATE_HALF + 0.003).all(1) & (rest[:, 2] > BLOCK_SIZE[2] - 1e-9)]
    for least in (LEAST_VOLUME, None):
        body = fe.Elastic(nodes, upright(nodes, tets), fe.tet4(), "averaged", BLOCK_YOUNG, poisson, bonded, least,
                          BARRIER)
        contact = fe.Contact(body, points, np.ones(points.shape[0]), 5e3)
        results.append(press_held(body, contact, HELD_DEPTHS, 1, residual=1e-10))
    return {"inputs": {"young_pa": BLOCK_YOUNG, "poisson": poisson, "lattice_order": 1, "least_volume": LEAST_VOLUME,
                       "barrier": BARRIER},
            "mesh": {"element": "tetrahedron, 4 nodes", "elements": len(tets), "nodes": len(nodes)},
            **with_ratios(*results), "seconds": round(time.time() - start, 1)}


def run_held_continuum(law, poisson, sizes):
    """A coarser edge than elsewhere: at depth the finest elements there are squashed flat. What the hold adds is the
    figure; it changes less between meshes than the forces do."""
    meshes = []
    for h in sizes:
        start, results = time.time(), []
        mesh = block_hexahedra("plate", h, 4)
        for least in (LEAST_VOLUME, None):
            body = fe.Elastic(mesh["nodes"], mesh["cells"], mesh["reference"], law, BLOCK_YOUNG, poisson, mesh["held"],
                              least)
            contact = fe.Contact(body, *mesh["contact"], PENALTY / 100)
            results.append(press_held(body, contact, HELD_DEPTHS[:3], 4, residual=1e-8, exact=False))
        meshes.append({"element": mesh["element"], "h_mm": h * 1e3, "elements": len(mesh["cells"]),
                       "unknowns": body.size, **with_ratios(*results), "seconds": round(time.time() - start, 1)})
    return {"inputs": {"young_pa": BLOCK_YOUNG, "poisson": poisson, "penalty_pa_per_m": PENALTY / 100,
                       "least_volume": LEAST_VOLUME}, "meshes": meshes}


# --- Cases -----------------------------------------------------------------------------------------------------------

def with_slopes(forces):
    """Forces and secant slopes, rounded to seven figures."""
    figures = lambda values: [float(f"{v:.7g}") for v in values]
    return {"force_n": figures(forces),
            "slope_n_per_m": figures(np.diff(np.concatenate([[0], forces])) / np.diff(np.concatenate([[0], DEPTHS])))}


# Cell sizes h (m) of the small-strain meshes, coarse to fine; at finite strain the first two.
SIZES = {("block", "plate"): (0.012, 0.008, 0.0055), ("block", "sphere"): (0.001, 0.0007, 0.0005),
         ("tongue", "plate"): (0.002, 0.0014, 0.001), ("tongue", "sphere"): (0.0007, 0.0005, 0.00035)}


def cases(lab):
    """name -> function that computes it."""
    out = {}
    for scene in ("block", "tongue"):
        young, top = (BLOCK_YOUNG, BLOCK_SIZE[2]) if scene == "block" else (TONGUE_YOUNG, TONGUE_AXES[2])
        for tool in ("plate", "sphere"):
            sizes, hexahedra = SIZES[scene, tool], (scene, tool) == ("block", "plate")
            for nu in POISSON if scene == "block" else (0.45,):
                out[f"continuum/{scene}/{tool}/small/{nu}"] = lambda a=(scene, tool, "small", nu, sizes, hexahedra): (
                    run_continuum(*a))
                laws = ("corotational", "neo-hookean") if nu == 0.45 else ("corotational",)
                if hexahedra:  # long runs, and the sharp edge leaves them without a limit at depth
                    laws = laws[:1] if nu == 0.45 else ()
                for law in laws:
                    out[f"continuum/{scene}/{tool}/{law}/{nu}"] = (
                        lambda a=(scene, tool, law, nu, sizes[:2], hexahedra): run_continuum(*a))
        if scene == "block":
            meshes = {"12000": lambda: block_tets((20, 20, 5)), "11664": lambda: block_tets((18, 18, 6))}
        else:
            meshes = {"t5k": lambda: read_tets(lab / "t5k"), "t20k": lambda: read_tets(lab / "t20k")}
        for mesh, load in meshes.items():
            for tool in ("plate", "sphere"):
                for nu in POISSON if mesh == "12000" else (0.45,):
                    for order in (1,) if mesh == "t20k" else (1, 3):
                        out[f"same-law/{scene}-{mesh}/{tool}/{nu}/lattice-{order}"] = (
                            lambda load=load, a=(top, young, nu, tool, order): run_tets(*load(), *a))
    for cells in ((20, 20, 5), (18, 18, 6)):
        for nu in (0.45, 0.49):
            out[f"volume-held/block-{6 * np.prod(cells)}/plate/{nu}/lattice-1"] = (
                lambda a=(cells, nu): run_held_tets(*a))
    for law in ("corotational", "neo-hookean"):
        out[f"volume-held/continuum/block/plate/{law}/0.45"] = lambda law=law: (
            run_held_continuum(law, 0.45, (0.005, 0.0035)))
    # Checks: the other element; another program; a tenth of the penalty.
    out["check/block/sphere/small/0.45/hexahedra"] = lambda: (
        run_continuum("block", "sphere", "small", 0.45, (0.00133, 0.001), True))
    out["check/block/plate/small/0.45/scikit-fem"] = lambda: slope_by_scikit_fem(0.45, SIZES["block", "plate"][0])
    out["check/tongue/sphere/small/0.45/soft-penalty"] = lambda: (
        run_continuum("tongue", "sphere", "small", 0.45, (0.0005,), False, PENALTY / 10))
    # The tetrahedra refined, on a quarter (the splitting has no symmetry, so not quite the whole block's mesh).
    for tool in ("plate", "sphere"):
        for cells in ((10, 10, 5), (20, 20, 10)):
            out[f"check/same-law/quarter-block-{20 / cells[0]:.0f}mm/{tool}/0.45/lattice-1"] = (
                lambda cells=cells, a=(BLOCK_SIZE[2], BLOCK_YOUNG, 0.45, tool, 1, True): (
                    run_tets(*block_tets(cells, True), *a)))
    return out


def extrapolated(done):
    """Small-strain slopes of the plate on the block, linear in h to h = 0: the error comes from the plate's edge, where
    the pressure is singular, and falls about in proportion to the cells there."""
    out = {}
    for name, case in done.items():
        if name.startswith("continuum/block/plate/small"):
            coarse, fine = case["meshes"][-2:]
            rate = (coarse["slope_n_per_m"][0] - fine["slope_n_per_m"][0]) / (coarse["h_mm"] - fine["h_mm"])
            out[name] = round(fine["slope_n_per_m"][0] - rate * fine["h_mm"], 2)
    return out


def main():
    parser = argparse.ArgumentParser(description="Static forces of a plate or sphere pressed into soft tissue.")
    parser.add_argument("--lab", type=pathlib.Path, help="folder of t5k.node, t5k.ele, t5k.fix and t20k likewise")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("static_indentation.json"))
    parser.add_argument("--only", nargs="*", default=[""], help="cases whose name holds one of these texts")
    parser.add_argument("--list", action="store_true", help="name the cases and stop")
    options = parser.parse_args()
    # Without the laboratory meshes their cases are left out; the rest can be computed.
    chosen = {name: run for name, run in cases(options.lab).items()
              if any(text in name for text in options.only) and (options.lab or "-t" not in name)}
    if options.list:
        print("\n".join(chosen))
        return
    results = json.loads(options.out.read_text()) if options.out.exists() else {"cases": {}}
    results["about"] = "Written by static_indentation.py; its head explains every scene, tool, law and figure."
    results["inputs"] = {
        "depths_m": DEPTHS, "plate_half_side_m": PLATE_HALF, "sphere_radius_m": SPHERE_RADIUS,
        "block_size_m": BLOCK_SIZE.tolist(), "tongue_semi_axes_m": TONGUE_AXES.tolist(), "tongue_base_m": TONGUE_BASE}
    versions = {"python": platform.python_version()}
    for package in ("numpy", "scipy", "scikit-fem", "gmsh", "pypardiso", "mkl"):
        try:
            versions[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            versions[package] = None
    results["versions"] = versions
    for name, run in chosen.items():
        print(name, flush=True)
        results["cases"][name] = run()
        results["cases"] = dict(sorted(results["cases"].items()))
        results["plate_slope_extrapolated_n_per_m"] = extrapolated(results["cases"])
        options.out.write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
