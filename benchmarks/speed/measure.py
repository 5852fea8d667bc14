"""Runs the measurements one after the other."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from ur5check._errors import UsageError
from ur5check._robot.serial_arm import SerialArm
from ur5check._robot.states import States, random_states

from .command_profiles import profiles
from .first_use import first_use
from .growth import joints, numbers_of_states
from .inverse_dynamics import inverse_dynamics
from .machine import machine, versions
from .matrices import matrices
from .memory import memory
from .operations import operations
from .result import Benchmark, Chapter
from .start_up import start_up

__all__ = ["QUESTIONS", "measure"]

_OPERATIONS, _COMMANDS = "operations", "commands"

#: Names of the measurements, in the order in which they run.
QUESTIONS = (
    "torques", "memory", "matrices", "states", "joints", "first-use", "start-up",
    _OPERATIONS, _COMMANDS,
)  # fmt: skip


def measure(
    arm: SerialArm,
    *,
    only: Collection[str] = (),
    states: int = 1_000_000,
    rounds: int = 5,
    threads: int = 2,
    lengths: Sequence[int] = (6, 12, 24, 48),
    up_to: int = 1_000_000,
    seed: int = 0,
    progress: Callable[[str], None] | None = None,
) -> Benchmark:
    """Measure an arm under its own gravity.

    only : names of the measurements to run; all when empty
    states : number at which torques are computed
    rounds : number of timings, whose median is reported
    threads : measured beside one thread
    lengths : numbers of joints of the longer arms
    up_to : largest number of states in one call
    seed : of the states and the longer arms
    progress : called with a sentence before each measurement

    Raises UsageError for a number below 1 or an unknown measurement.
    """
    for name, value in {"states": states, "rounds": rounds, "threads": threads}.items():
        if value < 1:
            raise UsageError(f"{name} must be at least 1, not {value}")
    if min(lengths, default=1) < 1 or up_to < 1:
        raise UsageError("lengths and up_to must be at least 1")
    if unknown := [key for key in only if key not in QUESTIONS]:
        raise UsageError(f"{unknown[0]!r} is not measured; choose from {', '.join(QUESTIONS)}")
    say = progress or (lambda line: None)
    drawn = random_states(arm.n, states, seed)

    def selected(key: str) -> bool:
        if only and key not in only:
            return False
        say(f"measuring {key}")
        return True

    questions = _questions(arm, drawn, rounds, threads, lengths, up_to, seed)
    return Benchmark(
        arm,
        machine(),
        versions(),
        states,
        rounds,
        threads,
        seed,
        tuple(question() for key, question in questions.items() if selected(key)),
        operations(arm, lengths, seed) if selected(_OPERATIONS) else (),
        profiles(rounds) if selected(_COMMANDS) else (),
    )


def _questions(
    arm: SerialArm,
    drawn: States,
    rounds: int,
    threads: int,
    lengths: Sequence[int],
    up_to: int,
    seed: int,
) -> dict[str, Callable[[], Chapter]]:
    return {
        "torques": lambda: inverse_dynamics(arm, drawn, threads, rounds),
        "memory": lambda: memory(arm, drawn, threads, rounds),
        "matrices": lambda: matrices(arm, drawn, rounds),
        "states": lambda: numbers_of_states(arm, up_to, seed, rounds),
        "joints": lambda: joints(lengths, seed, rounds),
        "first-use": lambda: first_use(arm, lengths, seed, rounds),
        "start-up": lambda: start_up(rounds),
    }
