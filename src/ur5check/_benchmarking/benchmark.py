"""`ur5check bench`: every question, one after the other."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from .._errors import UsageError
from .._robot.serial_arm import SerialArm
from .._robot.states import States, random_states
from .commands import profiles
from .first_use import first_use
from .growth import joints, numbers_of_states
from .machine import machine, versions
from .matrices import matrices
from .memory import memory
from .operations import operations
from .result import Benchmark, Chapter
from .start_up import start_up
from .torques import inverse_dynamics

__all__ = ["QUESTIONS", "bench"]

_OPERATIONS, _COMMANDS = "operations", "commands"

#: What can be asked for by name, in the order in which it is measured.
QUESTIONS = (
    "torques", "memory", "matrices", "states", "joints", "first-use", "start-up",
    _OPERATIONS, _COMMANDS,
)  # fmt: skip


def bench(
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
    """Measure, on an arm under its own gravity.

    only : keys of the questions to ask; all when empty
    states : that torques are computed at;  rounds : whose median is taken
    threads : beside one
    lengths : joints of the longer arms;  up_to : states in one call, at most
    seed : of states and of the longer arms
    progress : is told, in a sentence, what is measured next

    Raises UsageError for a number below 1, or a question that there is none of.
    """
    for name, value in {"states": states, "rounds": rounds, "threads": threads}.items():
        if value < 1:
            raise UsageError(f"{name} must be at least 1, not {value}")
    if min(lengths, default=1) < 1 or up_to < 1:
        raise UsageError("lengths and up_to must be at least 1")
    if unknown := [key for key in only if key not in QUESTIONS]:
        raise UsageError(f"{unknown[0]!r} is no question; choose from {', '.join(QUESTIONS)}")
    say = progress or (lambda line: None)
    drawn = random_states(arm.n, states, seed)

    def asked(key: str) -> bool:
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
        tuple(question() for key, question in questions.items() if asked(key)),
        operations(arm, lengths, seed) if asked(_OPERATIONS) else (),
        profiles(rounds) if asked(_COMMANDS) else (),
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
