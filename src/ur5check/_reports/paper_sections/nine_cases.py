"""The nine cases, model by model, and the effect of the listing's mistakes on each."""

from __future__ import annotations

import math
from collections.abc import Mapping

from ..._paper.case_runs import Run
from ..._paper.cases import CASES
from ..._paper.harmonic import Harmonic
from ..._paper.reproduction import Reproduction
from ..document import Column, Picture, Row, Section, Table
from ..mistake_sentences import sentence
from ..paper_summary import headline
from ..wording import MISSING, figures, residue

__all__ = ["cases_section", "listing_mistakes_section"]


def cases_section(r: Reproduction, pictures: Mapping[int, str]) -> Section:
    """Every curve as a sine, and the six torques of case 9.

    pictures : of each case, where its picture is, if one was drawn
    """
    drawn = (
        Picture(path, f"Case {number}. {headline(r, number)}") for number, path in pictures.items()
    )
    return Section("The nine cases", (), (_curves(r), _posture(r)), tuple(drawn))


def listing_mistakes_section(r: Reproduction) -> Section:
    """The printed torque, with the mistakes repaired, and by both readings of Table 1."""
    diagnosis = r.listing_mistakes.diagnosis
    lines = [
        f"{sentence(found, diagnosis.pair)}: {figures(found.before)} → {residue(found.after)} N m "
        "RMS over random motions."
        for found in diagnosis.mistakes
    ]
    table = Table(
        (
            Column("case"),
            Column("torque"),
            Column("as printed [N m]", number=True),
            Column("mistakes repaired [N m]", number=True),
            Column("DH [N m]", number=True),
            Column("printed over DH", number=True),
            Column("Table 1 read literally [N m]", number=True),
        ),
        tuple(
            Row(
                (
                    str(e.case),
                    f"τ{e.joint}",
                    figures(e.printed),
                    figures(e.repaired),
                    figures(e.table),
                    figures(e.ratio),
                    figures(e.literal),
                ),
                bad=e.gap > e.left and abs(e.ratio - 1.0) > 0.01,
            )
            for e in r.effects
        ),
        note="DH: the controller's DH parameters. At the angle of its largest torque, under the "
        "listing's gravity; cases without torque are omitted. Read literally: with the "
        "appendix's a2 = −0.425 m.",
    )
    return Section("The effect of the listing's mistakes", tuple(lines), (table,))


def _curves(r: Reproduction) -> Table:
    rows = []
    for case in CASES:
        shown = (str(case.number), f"τ{case.watched}", case.claim)
        for run in r.cases:
            if run.case is case and run.harmonic is not None:
                rows.append(
                    Row(
                        (*shown, run.model.name, *_sine(run.harmonic), figures(run.expected_peak)),
                        bad=not run.as_expected,
                    )
                )
                shown = ("", "", "")
    return Table(
        (
            Column("case"),
            Column("of"),
            Column("claim"),
            Column("model"),
            Column("amplitude [N m]", number=True),
            Column("phase [°]", number=True),
            Column("residual [N m]", number=True),
            Column("expected [N m]", number=True),
        ),
        tuple(rows),
        title="Cases 1 to 8: torque ≈ amplitude · sin(θ + phase)",
        note="Residual: of the fit, its offset included. Expected: the peak moment of the "
        "model's own weights, on the UR5's geometry.",
    )


def _sine(fit: Harmonic) -> tuple[str, ...]:
    nothing = math.isnan(fit.phase)
    return (
        "0" if nothing else figures(fit.amplitude),
        MISSING if nothing else f"{round(math.degrees(fit.phase), 2) + 0.0:.2f}",
        residue(fit.residual + abs(fit.offset)),
    )


def _posture(r: Reproduction) -> Table:
    runs = [run for run in r.cases if run.case.watched is None]
    rows = [
        Row((run.model.name, *(_torque(run, x) for x in run.watched)), bad=not run.as_expected)
        for run in runs
    ]
    joints = (Column(f"τ{i} [N m]", number=True) for i in range(1, 7))
    posture = runs[0].case.in_words()
    return Table((Column("model"), *joints), tuple(rows), title=f"Case 9: θ = {posture}")


def _torque(run: Run, value: float) -> str:
    return figures(float(value)) if abs(value) > run.rounding else "0"
