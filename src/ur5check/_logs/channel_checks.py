"""Channels that cannot be used as they stand: constant, saturated, late, of another sign."""

from __future__ import annotations

import numpy as np

from .._finding import Place
from .._robot.transforms import Array
from .._rules.finding_log import FindingLog
from .recording import Recording
from .row_checks import place_of
from .signals import uniform_segments

__all__ = ["check_channels", "velocity_is_late"]

#: A torque that stands at its largest value for this part of the time is saturated.
_SATURATED = 0.01

#: A velocity later than this many samples is not used; nor is one later than _LATE [s].
_LATE_SAMPLES, _LATE = 1.5, 0.004

#: Between recorded velocity and derivative of position: the slope lies this near to 1.
_SLOPE = 0.1


def check_channels(recording: Recording, log: FindingLog) -> None:
    """Findings about single channels: constant, saturated."""
    for name, what, rule in (
        ("q", "position", "LOG121"),
        ("qd", "velocity", "LOG121"),
        ("tau", "torque", "LOG121"),
    ):
        values = getattr(recording, name)
        if values is None:
            continue
        for joint, column in zip(recording.joints, values.T, strict=True):
            if np.ptp(column) == 0.0:
                log.add(
                    rule, f"joint {joint!r}", f"its {what} never changes", Place(recording.file),
                    value=float(column[0]),
                )  # fmt: skip
    if recording.tau is not None:
        _check_saturation(recording, recording.tau, log)


def _check_saturation(recording: Recording, tau: Array, log: FindingLog) -> None:
    for joint, column in zip(recording.joints, tau.T, strict=True):
        largest = float(np.abs(column).max())
        at_largest = np.abs(column) >= largest * (1.0 - 1e-9)
        # Two equal samples in a row at the largest value: a rounded peak may have one such pair.
        held = at_largest[1:] & at_largest[:-1]
        share = float(held.mean()) if largest > 0.0 and np.ptp(column) > 0.0 else 0.0
        if share > _SATURATED:
            log.add(
                "LOG122",
                f"joint {joint!r}",
                f"its torque stands at {largest:.4g} N m in {share:.1%} of the samples",
                place_of(recording, int(np.flatnonzero(held)[0])),
                value=share,
                bound=_SATURATED,
            )


def velocity_is_late(recording: Recording, log: FindingLog) -> bool:
    """Whether the velocity column must not be used, with a finding that says why.

    It is compared with the derivative of position: its delay by the peak of their correlation, its
    unit and sign by their ratio.
    """
    if recording.qd is None:
        return False
    _, columns = max(uniform_segments(recording), key=lambda segment: len(segment[0]))
    rate = recording.rate
    derivative = np.gradient(columns["q"], 1.0 / rate, axis=0)
    recorded = columns["qd"]
    moving = derivative.std(axis=0) > 1e-6
    if not moving.any() or len(recorded) < 16:
        return False
    delay = _delay(derivative[:, moving], recorded[:, moving], rate)
    if abs(delay) > max(_LATE, _LATE_SAMPLES / rate):
        log.add(
            "LOG123",
            "velocities",
            f"are {1e3 * abs(delay):.0f} ms {'behind' if delay > 0 else 'ahead of'} the positions",
            Place(recording.file),
            value=delay,
            bound=max(_LATE, _LATE_SAMPLES / rate),
            unit="s",
        )
        return True
    slope = (derivative * recorded).sum(axis=0)[moving] / (derivative**2).sum(axis=0)[moving]
    worst = int(np.abs(slope - 1.0).argmax())
    if abs(slope[worst] - 1.0) > _SLOPE:
        joint = np.array(recording.joints)[moving][worst]
        log.add(
            "LOG124",
            f"joint {joint!r}",
            f"its velocity is {slope[worst]:.3g} times the derivative of its position",
            Place(recording.file),
            value=float(slope[worst]),
            bound=1.0,
        )
        return True
    return False


def _delay(derivative: Array, recorded: Array, rate: float) -> float:
    """By how much `recorded` lags [s]: peak of the summed correlation, refined by a parabola.

    Each lag's correlation is over the samples that overlap: a sum over all would be larger the more
    samples overlap, and draw the peak towards zero.
    """
    n = len(derivative)
    size = 1 << (2 * n - 1).bit_length()
    longest = min(n // 2, int(rate))  # a second, at most
    lags = np.arange(-longest, longest + 1)
    total = np.zeros(len(lags))
    for a, b in zip(derivative.T, recorded.T, strict=True):
        a, b = a - a.mean(), b - b.mean()
        product = np.fft.irfft(np.fft.rfft(b, size) * np.conj(np.fft.rfft(a, size)), size)[lags]
        first = np.concatenate([[0.0], np.cumsum(a * a)])
        second = np.concatenate([[0.0], np.cumsum(b * b)])
        power_a = first[n - lags.clip(min=0)] - first[(-lags).clip(min=0)]
        power_b = second[n - (-lags).clip(min=0)] - second[lags.clip(min=0)]
        total += np.abs(product) / np.sqrt(np.maximum(power_a * power_b, 1e-300))
    k = int(total.argmax())
    shift = 0.0
    if 0 < k < len(total) - 1:
        left, centre, right = total[k - 1 : k + 2]
        bend = left - 2.0 * centre + right
        shift = 0.5 * (left - right) / bend if bend != 0.0 else 0.0
    return float((lags[k] + shift) / rate)
