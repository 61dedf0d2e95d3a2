"""Recipe of the figures in tests/engine/static_truth_test.cpp: small-strain linear elasticity by an independent program.

scikit-fem (pip install scikit-fem), quadratic hexahedra, block a x b x c metres, bottom bonded, a frictionless rigid
plate on the whole top moved down by d: prints the reaction in N per metre of d, on two meshes, so that its own
convergence can be seen.
"""
import numpy as np
from scipy.sparse.linalg import splu
from skfem import Basis, ElementHex2, ElementVector, MeshHex, asm, condense
from skfem.models.elasticity import lame_parameters, linear_elasticity


def slope(size, young, poisson, cells):
    mesh = MeshHex.init_tensor(*(np.linspace(0, s, n + 1) for s, n in zip(size, cells)))
    basis = Basis(mesh, ElementVector(ElementHex2()))
    stiffness = asm(linear_elasticity(*lame_parameters(young, poisson)), basis)
    bottom = basis.get_dofs(lambda x: np.isclose(x[2], 0))
    top = basis.get_dofs(lambda x: np.isclose(x[2], size[2]))
    vertical = np.concatenate([top.all("u^3")])
    u = basis.zeros()
    u[vertical] = -1.0
    held = np.unique(np.concatenate([bottom.all(), vertical]))
    matrix, right, u, free = condense(stiffness, x=u, D=held)
    # A symmetric ordering keeps the factor sparse; the default one takes a hundred times as long.
    factor = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    u[free] = factor.solve(right)
    return -(stiffness @ u)[vertical].sum()


for poisson in (0.3, 0.45, 0.49):
    print(poisson, [round(float(slope((0.03, 0.03, 0.015), 6000.0, poisson, (n, n, n // 2))), 3) for n in (4, 6)])
