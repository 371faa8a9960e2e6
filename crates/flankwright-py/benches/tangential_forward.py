"""The forward model of tangential dressing beside the same written with NumPy and SciPy, as an engineer would: one flank of 9 x 9 points by
``scipy.optimize.fsolve``, five equations for every point, warm starts. Both in one run; prints the times, their ratio and that they agree.

    python benches/tangential_forward.py [SAMPLES]
"""

import sys
import time
from pathlib import Path

import flankwright as fw
import numpy as np
from numpy.polynomial import chebyshev
from scipy.optimize import brentq, fsolve, newton

JOB = Path(__file__).parents[3] / "examples/tangential/example-1.toml"
Z1, Z2, M_N, ALPHA, BETA2, B_G, B_W = 3, 19, 3.5, np.radians(17.5), np.radians(-35.0), 40.0, 48.1042
R_P1, R_PD, HAND, SIDE = 95.625, 57.825, -1.0, -1.0  # right flank
KAPPA = B_W / B_G

BETA1 = HAND * (np.pi / 2 - np.arcsin(Z1 * M_N / (2 * R_P1)))
P_SCREW = R_P1 / np.tan(BETA1)
R_P2 = Z2 * M_N / (2 * np.cos(BETA2))
D0, GAMMA0 = R_P1 + R_P2, -(BETA1 + BETA2)
D_A0, GAMMA_A0 = R_P1 + R_PD, BETA1 - HAND * np.pi / 2
SIGMA = SIDE * HAND
PHI_S0 = -np.pi / 2


def body(teeth: float, beta: float, pitch: float) -> tuple[float, float, float, float]:
    """alpha_t, base radius, base helix angle, half space angle at the base."""
    alpha_t = np.arctan(np.tan(ALPHA) / np.cos(beta))
    return (
        alpha_t,
        pitch * np.cos(alpha_t),
        np.arctan(np.tan(beta) * np.cos(alpha_t)),
        np.pi / (2 * teeth) - np.tan(alpha_t) + alpha_t,
    )


ALPHA_T1, R_B1, BETA_B1, ETA1 = body(Z1, BETA1, R_P1)
ALPHA_T2, R_B2, BETA_B2, ETA2 = body(Z2, BETA2, R_P2)


def rx(a: float) -> np.ndarray:
    return np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])


def ry(a: float) -> np.ndarray:
    return np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])


def rz(a: float) -> np.ndarray:
    return np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])


def involute(w: float, z: float, r_b: float, beta_b: float, eta: float) -> tuple[np.ndarray, np.ndarray]:
    """Point and outward normal of a flank."""
    phi = SIDE * (w / r_b + eta) - z * np.tan(beta_b) / r_b
    e_r, e_t = np.array([np.sin(phi), np.cos(phi), 0.0]), -SIDE * np.array([np.cos(phi), -np.sin(phi), 0.0])
    normal = np.cos(beta_b) * e_t - SIDE * np.sin(beta_b) * np.array([0.0, 0.0, 1.0])
    return r_b * e_r + w * e_t + np.array([0.0, 0.0, z]), normal


def dressed_at(w1: float) -> tuple[float, float, float, float]:
    """Where the involute worm touches its dresser at a length of roll: s, theta, z on the worm, half thickness."""
    axis = np.array([0.0, np.sin(GAMMA_A0), np.cos(GAMMA_A0)])
    origin = np.array([D_A0, 0.0, 0.0])

    def turned(z: float) -> tuple[np.ndarray, np.ndarray]:
        point, normal = involute(w1, z, R_B1, BETA_B1, ETA1)
        return rz(PHI_S0) @ point, rz(PHI_S0) @ normal

    def meets(z: float) -> float:
        point, normal = turned(z)
        return float(np.linalg.det(np.array([point - origin, normal, axis])))

    start = SIDE * (w1 / R_B1 + ETA1 - np.arctan(w1 / R_B1)) * R_B1 / np.tan(BETA_B1)
    z1 = float(newton(meets, start, tol=1e-13))
    q = rx(GAMMA_A0) @ (turned(z1)[0] - origin)
    return np.hypot(q[0], q[1]) - R_PD, np.arctan2(-q[1], -q[0]), z1, SIGMA * q[2]


def profile() -> chebyshev.Chebyshev:
    """Half thickness of the dresser over s."""
    low, high = -1.75 * M_N, 1.55 * M_N
    middle = R_P1 * np.sin(ALPHA_T1)
    nodes = 0.5 * (low + high) + 0.5 * (high - low) * np.cos(np.pi * (np.arange(28) + 0.5) / 28)
    rolls = [brentq(lambda w, s=s: dressed_at(w)[0] - s, 0.9 * middle, 1.1 * middle, xtol=1e-12) for s in nodes]
    return chebyshev.Chebyshev.fit(nodes, [dressed_at(w)[3] for w in rolls], 24, domain=[low, high])


PROFILE = profile()
SLOPE = PROFILE.deriv()


def powers(v: dict[str, float], channel: str) -> np.ndarray:
    return np.array([v.get(f"{channel}{k}", 0.0) for k in range(6)])


class Chain:
    """The equations for one set of design variables."""

    def __init__(self, v: dict[str, float]) -> None:
        poly = np.polynomial.Polynomial
        self.f_p, self.f_z = poly(powers(v, "Fp")), poly(powers(v, "Fz"))
        self.f_c = poly(powers(v, "FC") / R_P2)
        self.gamma = GAMMA0 + v.get("gam0", 0.0) / (2 * np.pi * M_N)
        self.d = D0 + v.get("dist0", 0.0) / np.tan(ALPHA)
        self.d_f_p, self.d_f_z, self.d_f_c = self.f_p.deriv(), self.f_z.deriv(), self.f_c.deriv()
        self.back = ry(-self.gamma)

    def work_angle(self, phi_1: float, z: float) -> float:
        return (
            SIDE * np.pi / Z2
            - np.pi
            - Z1 / Z2 * phi_1
            + 2 * np.sin(BETA1) / (Z2 * M_N) * KAPPA * z
            - np.tan(BETA2) / R_P2 * z
            - self.f_c(2 * z / B_G)
        )

    def ground(self, y: np.ndarray) -> tuple[np.ndarray, float, float, float]:
        s, theta, x_d, phi_1, z = y
        u, zeta, eta = s / M_N, 2 * x_d / B_W, 2 * z / B_G
        h = SIGMA * (PROFILE(s) - self.f_p(u))
        slope = SIGMA * (SLOPE(s) - self.d_f_p(u) / M_N)
        cos, sin = np.cos(theta), np.sin(theta)
        point = np.array([-(R_PD + s) * cos, -(R_PD + s) * sin, h])
        n_d = SIGMA * np.array([slope * cos, slope * sin, 1.0]) / np.hypot(1.0, slope)
        tilt = rx(-GAMMA_A0)
        q, n = tilt @ point, tilt @ n_d
        p = q + np.array([D_A0, -self.f_z(zeta), x_d])
        f1 = n @ (np.array([0.0, -self.d_f_z(zeta) * 2 / B_W, 1.0]) + np.array([-p[1], p[0], 0.0]) / P_SCREW)
        turn = rz(phi_1) @ rz(x_d / P_SCREW - PHI_S0)
        y_point, n_y = turn @ p, turn @ n
        q2 = self.back @ (y_point + np.array([0.0, -self.d, KAPPA * z])) + np.array([0.0, 0.0, z])
        n_q = self.back @ n_y
        c = q2[0] * n_q[1] - q2[1] * n_q[0]
        f2 = n_q @ (self.back @ np.array([-y_point[1], y_point[0], 0.0])) + Z1 / Z2 * c
        turning = 2 * np.sin(BETA1) / (Z2 * M_N) * KAPPA - np.tan(BETA2) / R_P2 - self.d_f_c(eta) * 2 / B_G
        f3 = n_q @ (self.back @ np.array([0.0, 0.0, KAPPA]) + np.array([0.0, 0.0, 1.0])) - turning * c
        return rz(-self.work_angle(phi_1, z)) @ q2, float(f1), float(f2), float(f3)

    def deviation(self, w: float, z_g: float, start: np.ndarray) -> tuple[float, np.ndarray]:
        nominal, normal = involute(w, z_g, R_B2, BETA_B2, ETA2)
        radius = np.hypot(nominal[0], nominal[1])

        def equations(y: np.ndarray) -> list[float]:
            r, f1, f2, f3 = self.ground(y)
            return [np.hypot(r[0], r[1]) - radius, r[2] - z_g, f1, f2, f3]

        # With differences for derivatives it goes no closer; what it says of its progress then counts less than the residual.
        found, told, _, message = fsolve(equations, start, xtol=1e-11, full_output=True)
        if np.abs(told["fvec"]).max() > 1e-8:
            raise RuntimeError(message)
        return float(normal @ (self.ground(found)[0] - nominal)), found


def nominal_start(w: float, z_g: float) -> np.ndarray:
    """The contact of the unmodified process."""
    zeta = -SIDE * np.tan(BETA_B2) * (w - R_P2 * np.sin(ALPHA_T2))
    z = z_g - zeta
    phi_2 = SIDE * (w / R_B2 + ETA2) - z_g * np.tan(BETA_B2) / R_B2 - np.pi - SIDE * ALPHA_T2
    shift = KAPPA * z
    phi_1 = -(Z2 / Z1) * (
        phi_2 - (SIDE * np.pi / Z2 - np.pi) - 2 * np.sin(BETA1) / (Z2 * M_N) * shift + np.tan(BETA2) / R_P2 * z
    )
    gear = involute(w, z_g, R_B2, BETA_B2, ETA2)[0]
    on_worm = ry(GAMMA0) @ (rz(phi_2) @ gear - np.array([0.0, 0.0, z])) + np.array([0.0, D0, -shift])
    x = rz(-phi_1) @ on_worm
    s, theta, z_c, _ = dressed_at(np.sqrt(x[0] ** 2 + x[1] ** 2 - R_B1**2))
    return np.array([s, theta, x[2] - z_c, phi_1, z])


def main() -> None:
    samples = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    model = fw.TangentialModel(JOB, "right", points=9, equidistant_radii=True)
    random = np.random.default_rng(0)
    names = {"Fp2": 5e-3, "Fz2": 0.1, "dist0": 5e-3, "FC2": 5e-3}
    values = {name: scale * random.standard_normal(samples) for name, scale in names.items()}
    starts = [[nominal_start(w, z) for z in model.z] for w in model.w]

    begun = time.perf_counter()
    plain = np.empty((samples, 9, 9))
    for k in range(samples):
        chain = Chain({name: float(of[k]) for name, of in values.items()})
        for i, w in enumerate(model.w):
            for j, z in enumerate(model.z):
                plain[k, i, j] = 1e3 * chain.deviation(float(w), float(z), starts[i][j])[0]
    with_numpy = (time.perf_counter() - begun) / samples

    many = {name: np.resize(of, 2000) for name, of in values.items()}
    begun = time.perf_counter()
    found = model(many)
    with_flankwright = (time.perf_counter() - begun) / 2000

    difference = np.abs(found[:samples] - plain).max()
    print(f"NumPy and SciPy: {1e3 * with_numpy:.1f} ms for a flank of 9 x 9; flankwright: {1e3 * with_flankwright:.3f} ms")
    print(f"ratio {with_numpy / with_flankwright:.0f}; they differ by up to {difference:.1e} µm")
    if difference > 1e-4:
        raise SystemExit("the two do not agree")


if __name__ == "__main__":
    main()
