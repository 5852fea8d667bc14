"""Two arms in one set of joint coordinates, one base frame, and corresponding link frames."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from .._arguments import instance
from .._dynamics.kinematics import link_frames
from .._errors import StateError
from .._robot.as_arm import ArmSource, as_arm
from .._robot.inertia import Inertia
from .._robot.labels import labelled
from .._robot.serial_arm import SerialArm
from .._robot.states import States
from .._robot.transforms import Array, Transform
from .alignment import (
    SAME_ANGLE,
    SAME_LENGTH,
    Alignment,
    align,
    align_as_written,
    arm_in_coordinates_of,
    numbers_as_written,
    same_recipe,
)
from .rounded_constants.exact_constants import Arms, Correction, Side, angles, twelfths, written_out
from .rounded_constants.rounded_angles import with_angles_written_out

__all__ = ["Pair", "Side", "pair_as_written", "pair_up"]

_SAME_MOMENT = 1e-6  # of the largest entry: fewer digits than any table carries


@dataclass(frozen=True, eq=False)
class Pair:
    """Two arms, ready to be compared at the same q.

    Attributes
    ----------
    a : SerialArm
        The first arm, as given.
    b : SerialArm
        The second, in a's joint coordinates and base frame.
    given_b : SerialArm
        The second, as given.
    alignment : Alignment
        How b was brought there.
    link_maps : tuple of Transform, length n
        For each link, the transform T_{a,i ← b,i} from b's link frame to a's in which the links'
        inertias are compared.
    number_by_number : bool
        Whether both sources place their frames by one rule and are compared as they are written,
        wherever their frames stand in space.
    rounded : Pair or None
        The pair with constants as they were written, where this one has them exact.
    """

    a: SerialArm
    b: SerialArm
    given_b: SerialArm
    alignment: Alignment
    link_maps: tuple[Transform, ...]
    number_by_number: bool
    rounded: Pair | None = None

    @cached_property
    def _written_out(self) -> tuple[Arms, tuple[Correction, ...]]:
        arms, made = written_out(angles, {"a": self.a, "b": self.given_b})
        more, cut = written_out(twelfths, arms)
        if len({correction.side for correction in cut}) != 1:
            return arms, made
        # A 1/12 that one arm cut off is the cause only where it makes the tensors equal.
        exact = _paired(more["a"], more["b"], self.alignment, not self.alignment.exact)
        links = {link - 1 for correction in cut for link in correction.links}
        bodies = zip(exact.a.links, exact.inertias_b(), strict=True)
        same = all(
            np.abs(link.inertia.tensor - body.tensor).max()
            <= _SAME_MOMENT * np.abs(body.tensor).max()
            for i, (link, body) in enumerate(bodies)
            if i in links
        )
        return (more, (*made, *cut)) if same else (arms, made)

    @property
    def corrections(self) -> tuple[Correction, ...]:
        """Constants written with few digits in either arm, each with the arm that has it exact.

        Gravity is compared by itself."""
        return self._written_out[1]

    def without_rounding(self) -> Pair:
        """The same pair, aligned in the same way, with every rounded constant exact.

        Returns
        -------
        Pair
            This one where no constant is rounded; else `rounded` of the new one is this one.
        """
        arms, corrections = self._written_out
        if not corrections:
            return self
        as_written = not self.alignment.exact
        exact = _paired(arms["a"], arms["b"], self.alignment, as_written)
        return replace(exact, rounded=self)

    @property
    def effort_limits(self) -> Array:
        """Effort limits, shape (n,) [N m]: a's, else b's, else nan."""
        known = [
            ja.limits.known_effort or jb.limits.known_effort or np.nan
            for ja, jb in zip(self.a.joints, self.b.joints, strict=True)
        ]
        return np.array(known, dtype=np.float64)

    def inertias_b(self) -> tuple[Inertia, ...]:
        """The inertias of arm b in the link frames of arm a.

        Returns
        -------
        tuple of Inertia, length n
        """
        return tuple(
            link.inertia.expressed_in(T)
            for link, T in zip(self.b.links, self.link_maps, strict=True)
        )

    def parameter_difference(self) -> Array:
        """The difference π_a − π_b of the inertial parameters.

        Returns
        -------
        ndarray, shape (10 n,)
            Both in arm a's link frames, in the order and units of `PARAMETERS`.
        """
        pi_b = np.concatenate([inertia.parameters() for inertia in self.inertias_b()])
        return np.asarray(self.a.parameters() - pi_b)

    def arm(self, geometry: Side, inertias: Side, gravity: Side) -> SerialArm:
        """The arm with the geometry, the inertias and the gravity of either side.

        Parameters
        ----------
        geometry, inertias, gravity : {"a", "b"}

        Returns
        -------
        SerialArm
            In a's joint coordinates and base frame.
        """
        arm = self.a if geometry == "a" else self.b
        if geometry == "a" and inertias == "b":
            arm = arm.with_inertias(self.inertias_b())
        elif geometry == "b" and inertias == "a":
            arm = arm.with_inertias(
                [
                    link.inertia.expressed_in(T.inverse())
                    for link, T in zip(self.a.links, self.link_maps, strict=True)
                ]
            )
        return arm.with_gravity((self.a if gravity == "a" else self.b).gravity)


def pair_up(a: ArmSource, b: ArmSource, *, as_written: bool = False) -> Pair:
    """Align b with a and find the frames in which their links correspond.

    Arms with the same label are given labels that tell them apart.

    Parameters
    ----------
    a, b : name, path, pin.Model or SerialArm
        See `load`.
    as_written : bool
        Whether joint angles are compared as they stand; else joints are reversed and shifted so
        that the axes coincide.

    Returns
    -------
    Pair
        Both arms in a's joint coordinates and base frame.

    Raises
    ------
    InputError
        For an arm that cannot be read, or arms with different numbers or kinds of joints.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("paper", "appendix")
    >>> pair.a.label, pair.b.label, pair.alignment.exact
    ('paper', 'appendix', True)
    """
    arm_a, arm_b = labelled((as_arm(a), as_arm(b)))
    if as_written:
        return pair_as_written(arm_a, arm_b)
    alignment = align(arm_a, arm_b)
    return _paired(arm_a, arm_b, alignment, not alignment.exact)


def check_pair(pair: Pair, states: States) -> None:
    """Raise an InputError unless these are a Pair and States of its number of joints."""
    instance("pair", pair, Pair, "see ur5check.pair_up")
    instance("states", states, States, "see ur5check.random_states")
    if states.q.shape[1] != pair.a.n or not len(states):
        raise StateError(
            f"states have shape {states.q.shape}, but the arms have {pair.a.n} joints; give states "
            f"of shape (N, {pair.a.n}), at least one"
        )


def pair_as_written(a: SerialArm, b: SerialArm) -> Pair:
    """The same with joint angles, and as far as may be all numbers, as they are written."""
    return _paired(a, b, align_as_written(a, b), True)


def _paired(a: SerialArm, b: SerialArm, alignment: Alignment, as_written: bool) -> Pair:
    moved = arm_in_coordinates_of(a, b, alignment)
    number_by_number = as_written and same_recipe(a, moved)
    maps = numbers_as_written(a, moved) if number_by_number else _maps_in_space(a, b, alignment)
    return Pair(a, moved, b, alignment, maps, number_by_number)


def _maps_in_space(a: SerialArm, b: SerialArm, alignment: Alignment) -> tuple[Transform, ...]:
    """Link frames correspond as they stand in space at q = 0, rounded angles as they are meant.

    Two files written in the same frames are compared digit by digit, untouched by rounding: a map
    between source frames that is the identity within the tolerance of the axes becomes exactly so.
    """
    exact_a, exact_b = with_angles_written_out(a), with_angles_written_out(b)
    moved = arm_in_coordinates_of(exact_a, exact_b, alignment)
    rest = [0.0] * a.n
    maps = []
    for i, (T_a, T_b) in enumerate(
        zip(link_frames(exact_a, rest), link_frames(moved, rest), strict=True)
    ):
        T = Transform.from_matrix(T_a).inverse() @ Transform.from_matrix(T_b)
        E = exact_a.links[i].source_frame.inverse() @ T @ exact_b.links[i].source_frame
        if E.angle() < SAME_ANGLE and abs(E.p).max() < SAME_LENGTH:
            maps.append(a.links[i].source_frame @ b.links[i].source_frame.inverse())
        elif exact_a is a and exact_b is b:
            maps.append(T)
        else:
            maps.append(a.links[i].source_frame @ E @ b.links[i].source_frame.inverse())
    return tuple(maps)
