"""usage: modeldir.py DIR LINE.csv SUMMARY.csv SPAN DROP

Read a model directory of modal by numpy, solve its matrices by scipy, and print a line for each
test: 0 (passed) or 1, then its name.  LINE.csv and SUMMARY.csv are the tables
of catenary for the same case.
"""
import configparser
import os
import sys

import numpy as np
from scipy.linalg import eigh


def test(passed, name, number=None):
    """One line; a number that was compared stands in brackets."""
    text = "" if number is None else " (%.2g)" % number
    print(0 if passed else 1, name + text)


def below(number, bound, name):
    test(number <= bound, name, number)  # NaN fails


def full(band):
    """Symmetric matrix from LAPACK's lower band: band[i, j] is entry (i + j, j)."""
    n = band.shape[1]
    a = np.zeros((n, n))
    for i in range(band.shape[0]):
        below_diagonal = band[i, : n - i]
        a += np.diag(below_diagonal, -i)
        if i:
            a += np.diag(below_diagonal, i)
    return a


def read(directory):
    names = ("mass", "stiffness", "mass_support", "stiffness_support", "mass_reaction",
             "stiffness_reaction", "dofs", "static", "omega", "modes")
    return {name: np.load(os.path.join(directory, name + ".npy")) for name in names}


def number(case, section, key):
    return float(case[section][key].split()[0])


def load(case):
    """Mass per metre of the hot unstressed length, and the force per metre of it."""
    stretch = 1 + number(case, "load", "temperature_change") * number(
        case, "load", "expansion_coefficient")
    mass = number(case, "cable", "mass_per_length") + number(case, "load", "ice_mass_per_length")
    force = np.array([float(x) for x in case["load"]["wind"].split()])
    force[1] += mass * number(case, "gravity", "acceleration")
    return mass / stretch, force / stretch, stretch


def rigidity(case):
    if "axial_stiffness" in case["cable"]:
        return number(case, "cable", "axial_stiffness")
    return number(case, "cable", "youngs_modulus") * number(case, "cable", "area")


def test_files(a, n):
    shapes = {"mass": (12, 6 * n), "stiffness": (12, 6 * n),
              "mass_support": (6 * n, 6), "stiffness_support": (6 * n, 6),
              "mass_reaction": (6, 6), "stiffness_reaction": (6, 6),
              "dofs": (6 * n,), "static": (n + 1, 6), "omega": (6 * n,), "modes": (6 * n, 6 * n)}
    test(all(a[k].shape == s for k, s in shapes.items()), "shapes")
    test(all(a[k].dtype == np.dtype("<f8") for k in shapes), "little-endian float64")
    test(all(a[k].flags.f_contiguous for k in shapes), "Fortran order")
    test(all(np.isfinite(a[k]).all() for k in shapes), "finite numbers")
    outside = max(abs(a[k][i, 6 * n - i:]).max(initial=0) for k in ("mass", "stiffness")
                  for i in range(12))
    below(outside, 0, "nothing beyond the ends of the bands")


def test_dofs(a, n):
    free = [6 * node + c for node in range(n + 1) for c in range(6)
            if not (node in (0, n) and c % 2 == 0)]
    test(np.array_equal(a["dofs"], free), "dofs: all but v1, v2, v3 of the supports, ascending")


def test_static(a, case, line, span, drop):
    s, EA = a["static"], rigidity(case)
    below(abs(s[:, 5] / (s[:, 4] / (1 + s[:, 4] / EA)) - 1).max(), 1e-14, "static: T = T*/a")
    below(abs(s[:, [0, 1, 2, 4, 3]] - line[:, [0, 1, 2, 3, 6]]).max(), 0,
          "static: theta, x1, x2, x3, T* of catenary")
    below(abs(s[-1, 1:4] - [span, drop, 0]).max(), 1e-12 * span, "static: ends at the right support")
    length = number(case, "cable", "unstressed_length") * load(case)[2]
    below(abs(s[-1, 0] / length - 1), 1e-15, "static: theta up to the unstressed length")


def assemble(n, h, mu, EA, left, q):
    """M and K over all nodes, law hooke, from theory: K = int D' [EA cc' + T (I - cc')] D with the
    unit tangent c of the static line and T = T*/a; 5 Gauss points an element.  left: tension at
    the left end, q: load per unstressed metre, both vectors in space."""
    M, K = np.zeros((6 * n + 6, 6 * n + 6)), np.zeros((6 * n + 6, 6 * n + 6))
    points, weights = np.polynomial.legendre.leggauss(5)
    for e in range(n):
        here = slice(6 * e, 6 * e + 12)
        for x, w in zip((points + 1) / 2, weights * h / 2):
            f = [1 - 3 * x**2 + 2 * x**3, h * (x - 2 * x**2 + x**3),
                 3 * x**2 - 2 * x**3, h * (x**3 - x**2)]
            f1 = [6 * (x**2 - x) / h, 1 - 4 * x + 3 * x**2, 6 * (x - x**2) / h, 3 * x**2 - 2 * x]
            N, D = np.zeros((3, 12)), np.zeros((3, 12))
            for axis in range(3):
                columns = [2 * axis, 2 * axis + 1, 2 * axis + 6, 2 * axis + 7]
                N[axis, columns], D[axis, columns] = f, f1
            force = left - q * (e + x) * h
            tension = np.linalg.norm(force)
            cc = np.outer(force, force) / tension**2
            T = tension / (1 + tension / EA)
            M[here, here] += w * mu * N.T @ N
            K[here, here] += w * D.T @ (EA * cc + T * (np.eye(3) - cc)) @ D
    return M, K


def test_matrices(a, n, case, left):
    """All six matrix files against an assembly of their own."""
    mu, q, _ = load(case)
    L0 = a["static"][-1, 0]
    held = [6 * node + 2 * axis for node in (0, n) for axis in range(3)]
    free = a["dofs"].astype(int)
    for name, A in zip(("mass", "stiffness"), assemble(n, L0 / n, mu, rigidity(case), left, q)):
        for part, got, wanted in (("", full(a[name]), A[np.ix_(free, free)]),
                                  ("_support", a[name + "_support"], A[np.ix_(free, held)]),
                                  ("_reaction", a[name + "_reaction"], A[np.ix_(held, held)])):
            # by row and column, since the unknowns are lengths and slopes
            size = np.sqrt(np.diag(A))
            rows, columns = (size[held] if part == "_reaction" else size[free],
                             size[free] if part == "" else size[held])
            below(abs((got - wanted) / np.outer(rows, columns)).max(), 1e-12,
                  name + part + ": as assembled here")


def test_translation(a, mass):
    """All nodes and both supports move by the same vector along an axis."""
    dofs = a["dofs"].astype(int)
    K, M = full(a["stiffness"]), full(a["mass"])
    worst, masses = 0, np.zeros((3, 3))
    r = [(dofs % 6 == 2 * axis).astype(float) for axis in range(3)]
    u = [np.array([float(i % 3 == axis) for i in range(6)]) for axis in range(3)]
    for i in range(3):
        force = K @ r[i] + a["stiffness_support"] @ u[i]
        reaction = a["stiffness_support"].T @ r[i] + a["stiffness_reaction"] @ u[i]
        scale = max(a["stiffness"][0][dofs % 2 == 0].max(initial=0), a["stiffness_reaction"].max())
        worst = max(worst, abs(force[dofs % 2 == 0]).max(initial=0) / scale,
                    abs(force[dofs % 2 == 1]).max() / abs(a["stiffness_support"]).max(),
                    abs(reaction).max() / scale)
        for j in range(3):
            masses[i, j] = (r[j] @ M @ r[i] + r[j] @ a["mass_support"] @ u[i]
                            + u[j] @ a["mass_support"].T @ r[i] + u[j] @ a["mass_reaction"] @ u[i])
    below(worst, 1e-13, "a rigid translation needs no force")
    below(abs(masses / mass - np.eye(3)).max(), 1e-14, "the masses add up to mu L0 along each axis")
    test(all(np.array_equal(a[k], a[k].T) for k in ("mass_reaction", "stiffness_reaction")),
         "reaction matrices are symmetric")


def test_modes(a):
    K, M = full(a["stiffness"]), full(a["mass"])
    omega, phi = a["omega"], a["modes"]
    n, top, few = len(omega), omega[-1]**2, min(20, len(omega))
    test(np.all(np.diff(omega) >= 0) and omega[0] > 0, "omega: positive and ascending")
    # scipy's round-off is relative to the largest eigenvalue: so each half from its own problem.
    low = 1 / np.sqrt(eigh(M, K, eigvals_only=True)[::-1])
    high = np.sqrt(eigh(K, M, eigvals_only=True))
    below(abs(low / omega - 1)[: n // 2].max(), 1e-9, "omega: lower half of M phi = nu K phi")
    below(abs(high / omega - 1)[n // 2:].max(), 1e-9, "omega: upper half of K phi = omega^2 M phi")
    mass = phi.T @ M @ phi
    stiffness = phi.T @ K @ phi
    below(abs(mass - np.eye(n)).max(), 1e-10, "modes: orthonormal by M")
    below(abs(np.diag(stiffness) - omega**2).max(), 1e-10 * top, "modes: phi' K phi = omega^2")
    coupling = abs(stiffness - np.diag(np.diag(stiffness)))[:few, :few]
    below((coupling / np.outer(omega[:few], omega[:few])).max(), 1e-6,
          "modes: the first %d orthogonal by K" % few)
    largest = phi[a["dofs"].astype(int) % 2 == 0]
    test(np.all(largest.max(axis=0) >= -largest.min(axis=0) * (1 - 1e-5)),
         "modes: the largest displacement is positive")


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    directory, table, summary = sys.argv[1:4]
    span, drop = float(sys.argv[4]), float(sys.argv[5])
    case = configparser.ConfigParser(interpolation=None)
    case.read(os.path.join(directory, "case.ini"))
    n = int(case["mesh"]["elements"])
    a = read(directory)
    line = np.loadtxt(table, delimiter=",", skiprows=1, ndmin=2)
    key = np.genfromtxt(summary, delimiter=",", names=True)
    left = np.array([key[k] for k in ("horizontal_force_N", "vertical_left_N", "lateral_left_N")])
    test_files(a, n)
    test_dofs(a, n)
    test_static(a, case, line, span, drop)
    test_matrices(a, n, case, left)
    test_translation(a, load(case)[0] * a["static"][-1, 0])
    test_modes(a)


main()
