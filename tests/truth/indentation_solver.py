"""Static equilibrium of an elastic body pressed by a frictionless rigid tool: the machinery of static_indentation.py.

It shares no code with the engine. Everything is written as an energy of the nodal positions, minimised by Newton's
method with a sparse direct solver; unilateral contact is a penalty or an augmented Lagrangian on points of the surface.

Sources
    Elements         isoparametric, textbook shape functions (Zienkiewicz and Taylor, The Finite Element Method).
    Corotational     W = mu |F - R|^2 + lambda/2 (J - 1)^2; dR/dF by its twist modes: Smith, De Goes, Kim, "Analytic
                     eigensystems for isotropic distortion energies", ACM TOG 38 (2019), section 4.
    Averaging of J   node-averaged volume ratio of linear tetrahedra: Bonet and Burton, Commun. Numer. Meth. Engng 14
                     (1998): E = sum_t V_t mu |F_t - R_t|^2 + sum_n lambda/2 V_n (Jbar_n - 1)^2,
                     Jbar_n = 1/V_n sum_{t at n} V_t/4 det F_t, V_n = sum_{t at n} V_t/4.
    Volume hold      total volume sum_t V_t det F_t >= least_volume V_0 with one multiplier >= 0, a uniform pressure;
                     augmented Lagrangian as for contact, to a violation below 1e-9 (Nocedal and Wright, Numerical
                     Optimization, 2nd ed., 17.4). Its rank-one Hessian enters by Sherman and Morrison, so that steps
                     are Newton's.
    Contact          augmented Lagrangian: Alart and Curnier, Comput. Meth. Appl. Mech. Engng 92 (1991), no friction.

Units: metres, newtons, pascals. Needs numpy and scipy; pypardiso, if present, makes the factorisations faster.
"""
import itertools

import numpy as np
import scipy.linalg
import scipy.sparse as sp
from scipy.sparse.linalg import splu

try:
    import pypardiso
except ImportError:
    pypardiso = None

LONGEST_STEP = 0.0005  # metres, of any component in one Newton step

LEVI_CIVITA = np.zeros((3, 3, 3))
for _i, _j, _k in itertools.permutations(range(3)):
    LEVI_CIVITA[_i, _j, _k] = (_j - _i) * (_k - _i) * (_k - _j) / 2
IDENTITY_4 = np.einsum("ik,jl->ijkl", np.eye(3), np.eye(3))
SYMMETRIC_4 = 0.5 * (IDENTITY_4 + np.einsum("il,jk->ijkl", np.eye(3), np.eye(3)))
TRACE_4 = np.einsum("ij,kl->ijkl", np.eye(3), np.eye(3))


def lame(young, poisson):
    """(mu, lambda), Pa."""
    return young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))


# --- Reference elements: each returns (values [q, a], gradients [q, a, d], weights [q]) ------------------------------

def _line3(s):
    """Quadratic Lagrange functions on nodes 0, 1/2, 1 and their derivatives."""
    return (np.array([(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)]).T,
            np.array([4 * s - 3, 4 - 8 * s, 4 * s - 1]).T)


def _gauss(n):
    s, w = np.polynomial.legendre.leggauss(n)
    return (s + 1) / 2, w / 2


def hex27(points=3):
    """Node a = i + 3 j + 9 k of the 3 x 3 x 3 grid."""
    s, w = _gauss(points)
    v, d = _line3(s)
    axis = lambda x, y, z: np.einsum("pa,qb,rc->pqrcba", x, y, z).reshape(points ** 3, 27)
    return (axis(v, v, v), np.stack([axis(d, v, v), axis(v, d, v), axis(v, v, d)], -1),
            np.einsum("p,q,r->pqr", w, w, w).ravel())


def quad9(points=4):
    s, w = _gauss(points)
    v, d = _line3(s)
    axis = lambda x, y: np.einsum("pa,qb->pqba", x, y).reshape(points ** 2, 9)
    return axis(v, v), np.stack([axis(d, v), axis(v, d)], -1), np.outer(w, w).ravel()


def _simplex2(lam, pairs):
    """Quadratic functions from barycentric coordinates lam [q, v]; d/d(lam_1..) with lam_0 = 1 - sum."""
    n = lam.shape[1]
    values = [lam[:, i] * (2 * lam[:, i] - 1) for i in range(n)] + [4 * lam[:, i] * lam[:, j] for i, j in pairs]
    by_lam = np.zeros((len(lam), n + len(pairs), n))
    for i in range(n):
        by_lam[:, i, i] = 4 * lam[:, i] - 1
    for a, (i, j) in enumerate(pairs, n):
        by_lam[:, a, i], by_lam[:, a, j] = 4 * lam[:, j], 4 * lam[:, i]
    return np.stack(values, -1), by_lam[:, :, 1:] - by_lam[:, :, :1]


def _triangle_points(n):
    """Gauss points of a square collapsed onto the triangle: barycentric coordinates and weights (sum 1/2)."""
    s, w = _gauss(n)
    x, y = (g.ravel() for g in np.meshgrid(s, s, indexing="ij"))
    return np.stack([1 - x - y * (1 - x), x, y * (1 - x)], -1), np.outer(w, w).ravel() * (1 - x)


def tet10():
    """Gmsh's order of the edges; the four-point rule of degree two."""
    near, far = (5 + 3 * np.sqrt(5)) / 20, (5 - np.sqrt(5)) / 20
    lam = np.full((4, 4), far) + (near - far) * np.eye(4)
    return (*_simplex2(lam, [(0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3)]), np.full(4, 1 / 24))


def tri6(points=3):
    lam, w = _triangle_points(points)
    return (*_simplex2(lam, [(0, 1), (1, 2), (2, 0)]), w)


def tet4():
    """Linear tetrahedron, one point."""
    gradients = np.array([[-1, -1, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])[None]
    return np.full((1, 4), 0.25), gradients, np.array([1 / 6])


# --- Linear solver ---------------------------------------------------------------------------------------------------

class Factor:
    """Factor of a symmetric matrix given by its upper triangle (CSR)."""

    def __init__(self):
        self._solver = None

    def factorise(self, upper):
        if pypardiso:
            if self._solver is None:
                self._solver = pypardiso.PyPardisoSolver(mtype=-2)
            self._upper = sp.csr_matrix(upper)
            self._upper.sort_indices()
            self._solver.factorize(self._upper)
        else:
            full = upper + sp.triu(upper, 1).T
            self._solver = splu(full.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                                options={"SymmetricMode": True})

    def solve(self, right):
        if not pypardiso:
            return self._solver.solve(right)
        self._solver.set_phase(33)
        self._solver._check_A(self._upper)
        return self._solver._call_pardiso(self._upper, np.asfortranarray(right))

    def release(self):
        if pypardiso and self._solver is not None:
            self._solver.free_memory(everything=True)
        self._solver = None


# --- Elastic energy --------------------------------------------------------------------------------------------------

class Elastic:
    """Elastic energy of a mesh; the unknowns are the free components of the nodal displacement.

    law: "small" (small-strain linear), "corotational", "neo-hookean" (mu/2 (tr C - 3) - mu ln J + lambda/2 (J - 1)^2,
    with lambda such that its linearisation is the same), "averaged" (corotational with nodally averaged J; tet4 only).

    least_volume: None, or the share of the whole rest volume that is to be left at least (not with "small").
    barrier: None, or (least det F, c): "averaged" tetrahedra squashed below it resist by themselves, each with a
    pressure lambda (x + c x^3) of x = det F - least.
    """

    def __init__(self, nodes, cells, reference, law, young, poisson, held, least_volume=None,
                 barrier=None):
        self.nodes, self.cells, self.law = nodes, cells, law
        self.mu, self.lam = lame(young, poisson)
        _, gradients, weights = reference
        jacobian = np.einsum("eai,qad->eqid", nodes[cells], gradients, optimize=True)
        determinant = np.linalg.det(jacobian)
        if determinant.min() <= 0:
            raise ValueError(f"inverted element, least Jacobian {determinant.min():g}")
        self.dn = np.einsum("qad,eqdi->eqai", gradients, np.linalg.inv(jacobian), optimize=True)
        self.w = determinant * weights
        self.free = np.flatnonzero(~held.ravel())
        self._number = np.full(held.size, -1)
        self._number[self.free] = np.arange(len(self.free))
        self._pattern()
        if law == "averaged":
            volume = self.w[:, 0]
            share = sp.csr_matrix((np.repeat(volume / 4, 4), (cells.ravel(), np.repeat(np.arange(len(cells)), 4))),
                                  shape=(len(nodes), len(cells)))
            self.node_volume = np.asarray(share.sum(1)).ravel()
            self.share = share
        self.barrier = barrier if law == "averaged" else None
        self.least_volume, self.rest_volume = least_volume, self.w.sum()
        self.holding = 0.0  # multiplier: the uniform pressure that holds the volume, Pa, positive outwards
        # Well above lambda, that few rounds are needed.
        self.holding_stiffness = 30 * self.lam
        self._rank_one = None
        self.factor = Factor()

    @property
    def size(self):
        return len(self.free)

    def determinants(self, u):
        return np.linalg.det(self._gradient(u))

    def volume_ratio(self, u):
        return float((self.w * self.determinants(u)).sum() / self.rest_volume)

    def _holding_trial(self, j):
        beyond = (self.w * j).sum() / self.rest_volume - self.least_volume
        return max(0.0, self.holding - self.holding_stiffness * beyond)

    def settle(self, u):
        """Renews the multiplier of the volume hold; returns how far it was from settled, as a share of the volume."""
        if self.least_volume is None:
            return 0.0
        trial = self._holding_trial(self.determinants(u))
        change = abs(trial - self.holding) / self.holding_stiffness
        self.holding = trial
        return change

    def _pattern(self):
        """Where each entry of each element matrix goes in the CSR upper triangle of the free unknowns."""
        dofs = self._number[(3 * self.cells[:, :, None] + np.arange(3)).reshape(len(self.cells), -1)]
        n = dofs.shape[1]
        rows, cols = np.repeat(dofs, n, 1).ravel(), np.tile(dofs, (1, n)).ravel()
        self._kept = np.flatnonzero((rows >= 0) & (cols >= rows))
        key = rows[self._kept].astype(np.int64) * len(self.free) + cols[self._kept]
        unique, self._slot = np.unique(key, return_inverse=True)
        self._indices = (unique % len(self.free)).astype(np.int32)
        self._indptr = np.concatenate([[0], np.cumsum(np.bincount(unique // len(self.free), minlength=self.size))])
        self._indptr = self._indptr.astype(np.int32)

    def field(self, u):
        full = np.zeros(self.nodes.size)
        full[self.free] = u
        return full.reshape(-1, 3)

    def _gradient(self, u):
        return np.einsum("eai,eqaj->eqij", self.field(u)[self.cells], self.dn, optimize=True) + np.eye(3)

    def _pressure(self, j):
        """Averaged law: nodal Jbar - 1 and its pressure on each tetrahedron."""
        excess = self.share @ j[:, 0] / self.node_volume - 1
        return excess, (self.lam / 4 * excess[self.cells].sum(1))[:, None]

    def evaluate(self, u, hessian=False, projected=False):
        """Energy and its gradient on the free unknowns; with `hessian`, also the upper triangle of the Hessian.

        projected: True clamps the twist modes; "safe" also drops the pressure times the second derivative of J, and is
        never indefinite.
        """
        f, mu, lam = self._gradient(u), self.mu, self.lam
        second, trial = None, 0.0
        if self.law == "small":
            strain = 0.5 * (f + f.swapaxes(-1, -2)) - np.eye(3)
            trace = np.trace(strain, axis1=-2, axis2=-1)
            energy = (self.w * (mu * (strain ** 2).sum((-1, -2)) + lam / 2 * trace ** 2)).sum()
            stress = 2 * mu * strain + lam * trace[..., None, None] * np.eye(3)
            if hessian:
                second = np.broadcast_to(2 * mu * SYMMETRIC_4 + lam * TRACE_4, f.shape + (3, 3))
        else:
            j = np.linalg.det(f)
            if j.min() <= 0:
                return np.inf, None, None
            cof = j[..., None, None] * np.linalg.inv(f).swapaxes(-1, -2)
            if self.law == "averaged":
                excess, pressure = self._pressure(j)
                energy = lam / 2 * (self.node_volume * excess ** 2).sum()
                if self.barrier:
                    least, c = self.barrier
                    x = np.minimum(0, j - least)
                    energy += (self.w * lam * (x ** 2 / 2 + c * x ** 4 / 4)).sum()
                    pressure = pressure + lam * (x + c * x ** 3)
                    squashed = np.where(x < 0, lam * (1 + 3 * c * x ** 2), 0)
            elif self.law == "neo-hookean":
                # ln J contributes mu to the second derivative in J, so that lambda itself is unchanged.
                energy = (self.w * (mu / 2 * ((f ** 2).sum((-1, -2)) - 3) - mu * np.log(j)
                                    + lam / 2 * (j - 1) ** 2)).sum()
                pressure = lam * (j - 1) - mu / j
            else:
                energy = (self.w * lam / 2 * (j - 1) ** 2).sum()
                pressure = lam * (j - 1)
            if self.least_volume is not None:
                trial = self._holding_trial(j)
                energy += self.rest_volume * (trial ** 2 - self.holding ** 2) / (2 * self.holding_stiffness)
                pressure = pressure - trial
            stress = pressure[..., None, None] * cof
            if hessian:
                part = 0 * pressure if projected == "safe" else pressure
                second = np.einsum("eq,ikm,jln,eqmn->eqijkl", part, LEVI_CIVITA, LEVI_CIVITA, f, optimize=True)
                if self.law != "averaged":
                    slope = lam + (mu / j ** 2 if self.law == "neo-hookean" else 0 * j)
                    second += np.einsum("eq,eqij,eqkl->eqijkl", slope, cof, cof, optimize=True)
                elif self.barrier and squashed.any():
                    second += np.einsum("eq,eqij,eqkl->eqijkl", squashed, cof, cof, optimize=True)
            if self.law == "neo-hookean":
                stress += mu * f
                if hessian:
                    second += mu * IDENTITY_4
            else:
                left, sigma, right = np.linalg.svd(f)
                rotation = left @ right
                energy += (self.w * mu * ((f - rotation) ** 2).sum((-1, -2))).sum()
                stress += 2 * mu * (f - rotation)
                if hessian:
                    second += 2 * mu * IDENTITY_4
                    for p, q in ((0, 1), (1, 2), (2, 0)):
                        twist = (left[..., :, p, None] * right[..., None, q, :]
                                 - left[..., :, q, None] * right[..., None, p, :]) / np.sqrt(2)
                        rate = 2 / (sigma[..., p] + sigma[..., q])
                        if projected:
                            rate = np.minimum(rate, 1)
                        second -= np.einsum("eq,eqij,eqkl->eqijkl", 2 * mu * rate, twist, twist, optimize=True)
        gradient = self._divergence(stress)
        if not hessian:
            return energy, gradient, None
        matrix = self._assemble(second)
        self._rank_one = (self._divergence(cof), self.holding_stiffness / self.rest_volume) if trial > 0 else None
        if self.law == "averaged":
            rows = np.einsum("eij,eaj->eai", self.w[:, 0, None, None] / 4 * cof[:, 0], self.dn[:, 0])
            ne, index = len(self.cells), 3 * self.cells[:, :, None] + np.arange(3)
            by_tet = sp.csr_matrix((rows.ravel(), (np.repeat(np.arange(ne), 12), index.ravel())),
                                   shape=(ne, self.nodes.size))[:, self.free]
            at_node = sp.csr_matrix((np.ones(4 * ne), (self.cells.ravel(), np.repeat(np.arange(ne), 4))),
                                    shape=(len(self.nodes), ne)) @ by_tet
            matrix = matrix + sp.triu(at_node.T @ sp.diags(self.lam / self.node_volume) @ at_node, format="csr")
        return energy, gradient, matrix

    def _divergence(self, stress):
        """What a stress does to the free unknowns."""
        force = np.zeros((len(self.nodes), 3))
        per_node = np.einsum("eq,eqij,eqaj->eai", self.w, stress, self.dn, optimize=True)
        for i in range(3):
            force[:, i] = np.bincount(self.cells.ravel(), per_node[:, :, i].ravel(), minlength=len(self.nodes))
        return force.ravel()[self.free]

    def _assemble(self, second):
        ne, nq, na = self.dn.shape[:3]
        block = np.empty((ne, na, 3, na, 3))
        left = self.dn.transpose(0, 2, 1, 3).reshape(ne, na, nq * 3)
        for i in range(3):
            for k in range(3):
                part = (self.w[..., None, None] * second[:, :, i, :, k, :]) @ self.dn.swapaxes(-1, -2)
                block[:, :, i, :, k] = left @ part.reshape(ne, nq * 3, na)
        data = np.bincount(self._slot, block.reshape(-1)[self._kept], minlength=len(self._indices))
        return sp.csr_matrix((data, self._indices, self._indptr), shape=(self.size, self.size))

    def direction(self, matrix, right):
        """Solution of the matrix, with the volume hold's rank-one part as of the last evaluated Hessian."""
        self.factor.factorise(matrix)
        out = self.factor.solve(right).ravel()
        if self._rank_one is not None:
            column, scale = self._rank_one
            answer = self.factor.solve(column).ravel()
            out -= answer * (scale * (column @ out) / (1 + scale * (column @ answer)))
        return out


class Condensed:
    """A linear Elastic body condensed on the unknowns that its contact points depend on: small and dense."""

    def __init__(self, body, points):
        weights = sp.kron(points, sp.identity(3), format="csr")[:, body.free]
        self.kept = np.unique(weights.indices)
        self.nodes, self.free = body.nodes, body.free[self.kept]
        matrix = body.evaluate(np.zeros(body.size), hessian=True)[2]
        body.factor.factorise(matrix)
        compliance = np.empty((len(self.kept), len(self.kept)))
        for start in range(0, len(self.kept), 100):
            some = self.kept[start:start + 100]
            right = np.zeros((body.size, len(some)))
            right[some, np.arange(len(some))] = 1
            compliance[:, start:start + 100] = body.factor.solve(right)[self.kept]
        body.factor.release()
        self.stiffness = scipy.linalg.inv(0.5 * (compliance + compliance.T))
        self.stiffness = 0.5 * (self.stiffness + self.stiffness.T)

    @property
    def size(self):
        return len(self.kept)

    def evaluate(self, u, hessian=False, projected=False):
        force = self.stiffness @ u
        return 0.5 * u @ force, force, self.stiffness if hessian else None

    @staticmethod
    def settle(u):
        return 0.0

    @staticmethod
    def direction(matrix, right):
        return scipy.linalg.solve(matrix, right, assume_a="sym", lower=False)


# --- Contact ---------------------------------------------------------------------------------------------------------

class Plate:
    """Rigid horizontal plate, lower face at height `z`, footprint a square of half-side `half` about the axis.

    A surface point belongs to the plate when its place at rest is under the footprint: no side faces.
    """

    def __init__(self, half, z):
        self.half, self.z = half, z

    def gap(self, at, rest):
        inside = (np.abs(rest[:, :2]) <= self.half * (1 + 1e-9)).all(1)
        normal = np.zeros_like(at)
        normal[:, 2] = -1
        return np.where(inside, self.z - at[:, 2], np.inf), normal, np.zeros((len(at), 3, 3))


class Sphere:
    """Rigid sphere with its lowest point at height `z` on the axis: signed distance at the present place."""

    def __init__(self, radius, z):
        self.radius, self.centre = radius, np.array([0, 0, z + radius])

    def gap(self, at, rest):
        away = at - self.centre
        length = np.linalg.norm(away, axis=1)
        normal = away / length[:, None]
        curve = (np.eye(3) - normal[:, :, None] * normal[:, None, :]) / length[:, None, None]
        return length - self.radius, normal, curve


class Contact:
    """Points of the surface, `points` [m, n] times the nodes, each with a weight (area, or 1) and a multiplier."""

    def __init__(self, body, points, weight, stiffness):
        rest = points @ body.nodes
        self.rest, self.weight, self.stiffness = rest, weight, stiffness
        self.map = sp.kron(points, sp.identity(3), format="csr")[:, body.free]
        self.multiplier = np.zeros(len(rest))

    def evaluate(self, tool, u, hessian=False, projected=False):
        at = self.rest + (self.map @ u).reshape(-1, 3)
        gap, normal, curve = tool.gap(at, self.rest)
        trial = np.maximum(0, self.multiplier - self.stiffness * np.where(np.isfinite(gap), gap, 1e9))
        energy = (self.weight * (trial ** 2 - self.multiplier ** 2)).sum() / (2 * self.stiffness)
        push = -(self.weight * trial)[:, None] * normal
        out = {"energy": energy, "gradient": self.map.T @ push.ravel(), "trial": trial, "gap": gap, "push": push}
        if hessian:
            on = trial > 0
            blocks = self.stiffness * normal[:, :, None] * normal[:, None, :]
            if not projected:
                blocks = blocks - trial[:, None, None] * curve
            blocks = np.where(on[:, None, None], self.weight[:, None, None] * blocks, 0)[on]
            rows = (3 * np.flatnonzero(on)[:, None] + np.arange(3)).ravel()
            some = self.map[rows]
            diagonal = sp.bsr_matrix((blocks, np.arange(len(blocks)), np.arange(len(blocks) + 1)),
                                     shape=(len(rows), len(rows)))
            out["hessian"] = some.T @ (diagonal @ some)
        return out


def equilibrate(body, contact, tool, u, residual=1e-7, exact=True, rounds=30, steps=80):
    """Equilibrium from the guess u. exact: augmented Lagrangian to a penetration below 1e-9 m; else the penalty alone.
    A volume hold of the body is exact in both.

    Returns (u, lifting force on the tool in N, greatest unbalanced force component in N, penetration in m, solves).
    """
    solves, far = 0, True
    for _ in range(rounds):
        for _ in range(steps):
            # Far from equilibrium the exact Hessian is indefinite and leads astray.
            projected = far
            energy, gradient, matrix = body.evaluate(u, hessian=True, projected=projected)
            c = contact.evaluate(tool, u, hessian=True, projected=projected)
            total, r = energy + c["energy"], gradient + c["gradient"]
            if np.abs(r).max() < residual:
                break
            while True:
                if sp.issparse(matrix):
                    step = -body.direction(matrix + sp.triu(c["hessian"], format="csr"), r)
                else:
                    step = -body.direction(matrix + c["hessian"].toarray(), r)
                solves += 1
                # No step so long that a point could come out on the far side of the tool.
                rate, length = step @ r, min(1.0, LONGEST_STEP / np.abs(step).max())
                while rate < 0 and length > 1e-6:
                    e, _, _ = body.evaluate(u + length * step)
                    if e + contact.evaluate(tool, u + length * step)["energy"] <= (
                            total + 1e-4 * length * rate + 1e-13 * abs(total)):
                        break
                    length /= 2
                if rate < 0 and length > 1e-6:
                    break
                if projected == "safe":
                    raise ArithmeticError(f"no descent, {np.abs(r).max():g} N left")
                projected = "safe" if projected else True
                matrix = body.evaluate(u, hessian=True, projected=projected)[2]
                c = contact.evaluate(tool, u, hessian=True, projected=True)
            u = u + length * step
            far = length < 0.3 or np.abs(step).max() > 1e-4
        c = contact.evaluate(tool, u)
        penetration = max(0.0, -c["gap"].min())
        worst = np.abs(body.evaluate(u)[1] + c["gradient"]).max()
        slack = body.settle(u)
        if exact:
            slack = max(slack, np.abs(c["trial"] - contact.multiplier).max() / contact.stiffness)
            contact.multiplier = c["trial"]
        if slack < 1e-9:
            break
    return u, float(c["push"][:, 2].sum()), float(worst), float(penetration), solves
