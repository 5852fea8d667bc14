"""The ten inertial parameters of a rigid body: mass, centre of mass, inertia tensor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._arguments import number
from .._errors import ModelError
from .pseudo_inertia import EXACT, BodyTest, DigitBounds, judge_body
from .transforms import Array, Transform, frozen, skew

__all__ = [
    "PARAMETERS",
    "Inertia",
    "parameter_map",
    "parameters_from_pseudo_inertia",
    "pseudo_inertia",
]

#: Names of the ten inertial parameters, in the order of Pinocchio's `Inertia.toDynamicParameters`:
#: mass [kg], first moment [kg m], and the tensor about the *frame's origin* [kg m²].
PARAMETERS = ("m", "mx", "my", "mz", "Ixx", "Ixy", "Iyy", "Ixz", "Iyz", "Izz")

_UPPER = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))  # indices of Ixx, Ixy, … in the matrix


@dataclass(frozen=True, eq=False)
class Inertia:
    """Inertia of a rigid body, expressed in one frame.

    Finite numbers with a symmetric tensor are accepted even if no body can have them; see
    `principal_moments`, `triangle_margin` and `judged`.

    Parameters
    ----------
    mass : float
        [kg]
    com : array-like, shape (3,)
        Centre of mass in the frame [m].
    tensor : array-like, shape (3, 3)
        Inertia about the centre of mass, along the axes of the frame [kg m²].
    digits : DigitBounds
        How far the printed digits of the tensor may have moved its principal moments.

    Raises
    ------
    ModelError
        For other shapes, entries that are not finite, or a tensor that is not symmetric.

    Examples
    --------
    >>> import numpy as np
    >>> from ur5check import Inertia
    >>> Inertia(2.0, [0.1, 0.0, 0.0], 0.01 * np.eye(3)).parameters()[:2].tolist()
    [2.0, 0.2]
    """

    mass: float
    com: Array
    tensor: Array
    digits: DigitBounds = EXACT

    def __post_init__(self) -> None:
        object.__setattr__(self, "mass", float(frozen(self.mass, (), "mass")))
        object.__setattr__(self, "com", frozen(self.com, (3,), "com"))
        tensor = frozen(self.tensor, (3, 3), "tensor")
        asymmetry = np.abs(tensor - tensor.T).max()
        # A rotated tensor is asymmetric by rounding: a few ulp of its largest entry.
        if asymmetry > 64 * np.finfo(float).eps * np.abs(tensor).max():
            raise ModelError(
                "the inertia tensor is not symmetric",
                fix="give ixy = iyx, ixz = izx and iyz = izy",
                value=tensor.tolist(),
            )
        object.__setattr__(self, "tensor", frozen((tensor + tensor.T) / 2, (3, 3)))

    @classmethod
    def zero(cls) -> Inertia:
        """No mass and no inertia.

        Returns
        -------
        Inertia
        """
        return cls(0.0, np.zeros(3), np.zeros((3, 3)))

    @classmethod
    def from_entries(
        cls,
        mass: float,
        com: ArrayLike,
        *,
        ixx: float,
        iyy: float,
        izz: float,
        ixy: float = 0.0,
        ixz: float = 0.0,
        iyz: float = 0.0,
    ) -> Inertia:
        """From the mass, the centre of mass and the six entries of the tensor.

        Parameters
        ----------
        mass : float
            [kg]
        com : array-like, shape (3,)
            Centre of mass in the frame [m].
        ixx, iyy, izz, ixy, ixz, iyz : float
            Tensor about the centre of mass, along the axes of the frame [kg m²].

        Returns
        -------
        Inertia

        Raises
        ------
        ModelError, UsageError
            For entries that are not finite numbers.
        """
        ixx, iyy, izz = number("ixx", ixx), number("iyy", iyy), number("izz", izz)
        ixy, ixz, iyz = number("ixy", ixy), number("ixz", ixz), number("iyz", iyz)
        tensor = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
        return cls(mass, frozen(com, (3,), "com"), tensor)

    @classmethod
    def from_parameters(cls, parameters: ArrayLike) -> Inertia:
        """From the ten inertial parameters, in which torques are linear.

        The tensor about the centre of mass is I_c = I_o + m S(c)² (parallel-axis theorem).

        Parameters
        ----------
        parameters : array-like, shape (10,)
            In the order of `PARAMETERS`; all zero if the mass is.

        Returns
        -------
        Inertia

        Raises
        ------
        ModelError
            For another shape, entries that are not finite, or a moment without mass.
        """
        pi = frozen(parameters, (10,), "parameters")
        if pi[0] == 0.0:
            if pi.any():
                raise ModelError(
                    "a body without mass has no centre of mass",
                    fix="give it mass, or ten zeros",
                    value=pi.tolist(),
                )
            return cls.zero()
        about_origin = np.zeros((3, 3))
        for value, (row, column) in zip(pi[4:], _UPPER, strict=True):
            about_origin[row, column] = about_origin[column, row] = value
        com = pi[1:4] / pi[0]
        # Exactly symmetric; m S(c)² is so only to rounding, which shows where the two parts of the
        # tensor nearly cancel.
        parallel_axes = pi[0] * (com @ com * np.eye(3) - np.outer(com, com))
        return cls(float(pi[0]), com, about_origin - parallel_axes)

    def parameters(self) -> Array:
        """The ten inertial parameters, in which torques are linear.

        The tensor is taken about the frame's origin: I_o = I_c − m S(c)².

        Returns
        -------
        ndarray, shape (10,)
            In the order and units of `PARAMETERS`.
        """
        about_origin = self.tensor - self.mass * skew(self.com) @ skew(self.com)
        return np.array(
            [self.mass, *(self.mass * self.com), *(about_origin[entry] for entry in _UPPER)]
        )

    def expressed_in(self, T_ab: Transform) -> Inertia:
        """The same body's inertia in frame a, where this one is in frame b.

        Parameters
        ----------
        T_ab : Transform
            From coordinates in frame b to coordinates in frame a.

        Returns
        -------
        Inertia
        """
        tensor = T_ab.R @ self.tensor @ T_ab.R.T
        return Inertia(self.mass, T_ab.R @ self.com + T_ab.p, tensor, self.digits)

    def __add__(self, other: Inertia) -> Inertia:
        """The inertia of two bodies fixed to each other, both expressed in the same frame."""
        mass = self.mass + other.mass
        if mass == 0.0:
            return Inertia.zero()
        com = (self.mass * self.com + other.mass * other.com) / mass
        tensor = np.zeros((3, 3))
        for part in (self, other):
            lever = skew(part.com - com)
            tensor += part.tensor - part.mass * lever @ lever
        return Inertia(mass, com, tensor, self.digits + other.digits)

    def principal_moments(self) -> Array:
        """Eigenvalues of the tensor about the centre of mass.

        Returns
        -------
        ndarray, shape (3,)
            Ascending [kg m²].
        """
        return np.asarray(np.linalg.eigvalsh(self.tensor), dtype=np.float64)

    def judged(self) -> BodyTest:
        """Whether a body can have this inertia, within its printed digits.

        Returns
        -------
        BodyTest
        """
        return judge_body(self.mass, self.tensor, self.digits)

    def triangle_margin(self) -> float:
        """Smallest of I_a + I_b − I_c over the principal moments.

        It is not negative for any body of positive density (Wensing, Kim & Slotine 2018).

        Returns
        -------
        float
            [kg m²]
        """
        moments = self.principal_moments()
        return float(moments[0] + moments[1] - moments[2])


def parameter_map(T_ab: Transform) -> Array:
    """The matrix A, shape (10, 10), with π_a = A π_b: parameters in frame b to frame a.

    The pseudo-inertia J = [[Σ, m c], [(m c)ᵀ, m]] with Σ = ½ tr(I_o) 1 − I_o moves as
    J_a = T J_b Tᵀ (Wensing, Kim & Slotine 2018), which is linear in π also for a body without mass.
    """
    T = T_ab.matrix()
    columns = [
        parameters_from_pseudo_inertia(T @ pseudo_inertia(unit) @ T.T) for unit in np.eye(10)
    ]
    return np.column_stack(columns)


def pseudo_inertia(pi: Array) -> Array:
    """J, shape (4, 4), of the ten parameters of `PARAMETERS`."""
    about_origin = np.zeros((3, 3))
    for value, (row, column) in zip(pi[4:], _UPPER, strict=True):
        about_origin[row, column] = about_origin[column, row] = value
    J = np.empty((4, 4))
    J[:3, :3] = 0.5 * np.trace(about_origin) * np.eye(3) - about_origin
    J[:3, 3] = J[3, :3] = pi[1:4]
    J[3, 3] = pi[0]
    return J


def parameters_from_pseudo_inertia(J: Array) -> Array:
    """The ten parameters, shape (..., 10), of pseudo-inertias J, shape (..., 4, 4)."""
    sigma = J[..., :3, :3]
    about_origin = np.trace(sigma, axis1=-2, axis2=-1)[..., None, None] * np.eye(3) - sigma
    rows, columns = zip(*_UPPER, strict=True)
    return np.concatenate(
        [J[..., 3, 3, None], J[..., :3, 3], about_origin[..., rows, columns]], axis=-1
    )
