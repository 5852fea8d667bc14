"""From samples to signals: one clock, a zero-phase low-pass, velocities and accelerations.

All channels pass the same filter, so that none lags behind another.  Butterworth's filter of order
4, run forward and backward, has no phase; differences are central.  Ends and both sides of a gap
are left out: there the filter has only half of what it needs.

Friction jumps where a joint reverses, and a torque's low-pass rounds the jump.  So the columns of
friction are computed from a velocity of more bandwidth and pass the filter too ("parallel
filtering": Gautier, IEEE ICRA 1997).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .._errors import UsageError
from .._robot.transforms import Array
from .friction import USUAL_V0, FrictionModel
from .recording import Recording
from .row_checks import GAP

__all__ = ["Signals", "choose_cutoff", "filtered"]

#: Signals are kept at this many times the cut-off: enough for a signal whose power falls by 48 dB
#: an octave above it (order 4, twice).
_KEPT_RATE = 8.0

#: The part of the velocity's power that belongs to the motion.  What lies above is noise.
_POWER = 0.9999

#: A chosen cut-off is this many times that frequency: friction changes faster than the motion (five
#: to ten times the motion's bandwidth: Swevers et al., IEEE Control Systems 27(5), 2007).
_ABOVE_MOTION = 5.0

#: … and lies in this range [Hz]: above it the flexibility of drives and links shows in any arm.
_CUTOFFS = (2.0, 10.0)

_ORDER = 4

#: Bandwidth of the velocity that friction's columns are computed from, over the cut-off.
_FRICTION_BAND = 5.0


@dataclass(frozen=True, eq=False)
class Signals:
    """Filtered signals of n joints at N times.

    t : shape (N,) [s];  q, qd, qdd, tau : shape (N, n)
    drive : what each coefficient of friction and rotor inertia is multiplied with, filtered as
        tau is, shape (N, n, k), in the order of `FrictionModel.names`
    segment : number of the uninterrupted part that each sample belongs to, shape (N,)
    model_tau : of the controller's model; None where there is none
    cutoff : of the low-pass [Hz];  rate : of the kept samples [Hz]
    velocity_from_position : whether qd comes from q, because there is no velocity or it is late
    """

    t: Array
    q: Array
    qd: Array
    qdd: Array
    tau: Array
    drive: Array
    segment: NDArray[np.int64]
    model_tau: Array | None
    cutoff: float
    rate: float
    velocity_from_position: bool

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.q.shape[1])

    @property
    def count(self) -> int:
        """Number of samples."""
        return len(self.t)

    def selected(self, part: slice | NDArray[np.bool_]) -> Signals:
        """Some of the samples."""
        names = ("t", "q", "qd", "qdd", "tau", "drive", "segment")
        model_tau = None if self.model_tau is None else self.model_tau[part]
        return replace(
            self, model_tau=model_tau, **{name: getattr(self, name)[part] for name in names}
        )


def choose_cutoff(recording: Recording) -> float:
    """A cut-off [Hz] well above the motion: `_ABOVE_MOTION` times the frequency below which
    `_POWER` of every joint's velocity lies.
    """
    from scipy.signal import welch

    pieces = uniform_segments(recording)
    longest = max(pieces, key=lambda piece: len(piece[0]))
    _, columns = longest
    q = columns["q"]
    rate = recording.rate
    frequencies, power = welch(
        np.gradient(q, 1.0 / rate, axis=0), rate, nperseg=min(len(q), 2048), axis=0, detrend=False
    )
    moving = power.sum(axis=0) > 1e-6 * power.sum(axis=0).max()
    share = np.cumsum(power[:, moving], axis=0) / power[:, moving].sum(axis=0)
    reached = frequencies[(share < _POWER).sum(axis=0).clip(max=len(frequencies) - 1)]
    largest = min(_CUTOFFS[1], 0.4 * rate)
    return float(np.clip(_ABOVE_MOTION * reached.max(), min(_CUTOFFS[0], largest), largest))


def filtered(
    recording: Recording,
    cutoff: float,
    friction: FrictionModel,
    *,
    v0: Array | float = USUAL_V0,
    velocity_from_position: bool,
) -> Signals:
    """Filter a recording with clean rows.

    cutoff : [Hz], below half the rate;  friction : whose columns `Signals.drive` holds
    v0 : speed of Coulomb friction's transition, of all joints or of each, shape (n,) [rad/s or m/s]

    Raises UsageError for a cut-off that the rate does not allow, and a recording too short for it.
    """
    from scipy.signal import butter, sosfiltfilt

    rate = recording.rate
    if not 0.0 < cutoff < 0.5 * rate:
        raise UsageError(f"cutoff must lie between 0 and {0.5 * rate:.4g} Hz, half the sample rate")
    assert recording.tau is not None  # noqa: S101 - of a recording that is compared
    sos = butter(_ORDER, cutoff, fs=rate, output="sos")
    wide = butter(_ORDER, min(_FRICTION_BAND * cutoff, 0.4 * rate), fs=rate, output="sos")
    margin = round(rate / cutoff)
    keep = max(1, int(rate / (_KEPT_RATE * cutoff)))
    kept: list[dict[str, Array]] = []
    for number, (t, columns) in enumerate(uniform_segments(recording)):
        if len(t) <= 4 * margin:
            continue
        smooth = {name: sosfiltfilt(sos, values, axis=0) for name, values in columns.items()}
        if velocity_from_position or "qd" not in smooth:
            smooth["qd"] = derivative(smooth["q"], rate)
        smooth["qdd"] = derivative(smooth["qd"], rate)
        fast = (
            columns["qd"]
            if "qd" in columns and not velocity_from_position
            else derivative(columns["q"], rate)
        )
        inner = slice(margin, len(t) - margin, keep)
        drive = []
        for j, speed in enumerate(np.broadcast_to(v0, fast.shape[1:])):  # one at a time: memory
            wide_qd = sosfiltfilt(wide, fast[:, j])
            rough = friction.columns(wide_qd, smooth["qdd"][:, j], speed)
            columns_j = sosfiltfilt(sos, rough, axis=0)[inner]
            # The rotor's column is filtered once already, as the links' inertia is.
            columns_j[:, -1] = smooth["qdd"][inner, j]
            drive.append(columns_j)
        part = {name: values[inner].copy() for name, values in smooth.items()}
        part["drive"] = np.stack(drive, axis=1)
        part["t"], part["segment"] = t[inner], np.full(len(t[inner]), number)
        kept.append(part)
    if not kept:
        raise UsageError(
            f"{recording.file}: {recording.duration:.3g} s are too short for a cut-off of "
            f"{cutoff:.3g} Hz; record longer, or give a higher --cutoff"
        )
    joined = {name: np.concatenate([part[name] for part in kept]) for name in kept[0]}
    return Signals(
        joined["t"], joined["q"], joined["qd"], joined["qdd"], joined["tau"], joined["drive"],
        joined["segment"], joined.get("model_tau"), cutoff, rate / keep,
        velocity_from_position or recording.qd is None,
    )  # fmt: skip


def derivative(values: Array, rate: float) -> Array:
    """Along the first axis, by central differences over seven samples.

    Over three they are too small by (2π f / rate)² / 6: 4 % at a twelfth of the rate, which would
    pass for rotor inertia.
    """
    slope = np.gradient(values, 1.0 / rate, axis=0)
    if len(values) > 6:
        slope[3:-3] = rate * sum(
            weight * (values[3 + k : len(values) - 3 + k] - values[3 - k : len(values) - 3 - k])
            for k, weight in ((1, 3 / 4), (2, -3 / 20), (3, 1 / 60))
        )
    return slope


def uniform_segments(recording: Recording) -> list[tuple[Array, dict[str, Array]]]:
    """Uninterrupted parts, each resampled on a uniform clock of the recording's rate."""
    t, rate = recording.t, recording.rate
    breaks = np.flatnonzero(np.diff(t) > GAP / rate) + 1
    names = [
        name for name in ("q", "qd", "tau", "model_tau") if getattr(recording, name) is not None
    ]
    segments = []
    for part in np.split(np.arange(len(t)), breaks):
        if len(part) < 4:
            continue
        clock = np.arange(t[part[0]], t[part[-1]], 1.0 / rate)
        columns = {name: getattr(recording, name)[part] for name in names}
        uniform = abs(len(clock) - len(part)) <= 1 and np.allclose(
            clock[: len(part)], t[part][: len(clock)], rtol=0.0, atol=1e-3 / rate
        )
        if uniform:
            clock = clock[: len(part)]
            columns = {name: values[: len(clock)] for name, values in columns.items()}
        else:
            columns = {name: _resampled(t[part], values, clock) for name, values in columns.items()}
        segments.append((clock, columns))
    return segments


def _resampled(t: Array, values: Array, clock: Array) -> Array:
    from scipy.interpolate import CubicSpline

    return np.asarray(CubicSpline(t, values, axis=0)(clock))
