"""Writes docs/paper-claims.md: a run of `ur5check paper` inside the text of paper-claims.in.md.

python docs/generate_paper_claims.py
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from pathlib import Path

from ur5check._paper.case_runs import Run
from ur5check._paper.cases import CASES, Case
from ur5check._paper.claim import Claim, ClaimOutcome
from ur5check._paper.inertia_formulas import FORMULAS
from ur5check._paper.reproduction import Reproduction, reproduce
from ur5check._reports.mistake_sentences import sentence
from ur5check._reports.paper_summary import headline, headline_of_all, summarize, summary
from ur5check._reports.wording import figures, residue

HERE = Path(__file__).resolve().parent
PAGE = HERE / "paper-claims.md"

#: Below this, digits are those of one machine: the page says "rounding".
ROUNDING = 1e-11


def page(r: Reproduction) -> str:
    """The whole page."""
    text = (HERE / "paper-claims.in.md").read_text(encoding="utf-8")
    return text.format(
        together=headline_of_all(r),
        summary=summary(r)[0].upper() + summary(r)[1:],
        sentences="\n".join(f"- {line}" for line in summarize(r)),
        verdicts=table(("claim", "verdict", "as printed", "must be", "why"), verdicts(r)),
        listing_mistakes="\n".join(
            f"- {sentence(found, r.listing_mistakes.diagnosis.pair)}."
            for found in r.listing_mistakes.diagnosis.mistakes
        ),
        effects=table(
            (
                "case",
                "torque",
                "as printed [N m]",
                "mistakes repaired [N m]",
                "controller's DH [N m]",
                "ratio",
                "Table 1 read literally [N m]",
            ),
            (
                (
                    e.case,
                    f"τ{e.joint}",
                    *map(figures, (e.printed, e.repaired, e.table, e.ratio, e.literal)),
                )
                for e in r.effects
            ),
        ),
        cases="\n\n".join(section(r, case) for case in CASES),
        formulas_tried=len(FORMULAS),
        formulas=table(
            ("link", "I_xx as printed", "r [m]", "l [m]", "formula", "eq. 3 gives", "off by"),
            formulas(r),
        ),
        tests=table(("id", "measured, and its limit", "in the paper"), tests(r.verdicts)),
    )


def section(r: Reproduction, case: Case) -> str:
    """One case: its figure, and the numbers of each model."""
    runs = [run for run in r.cases if run.case is case]
    watched = "all six torques" if case.watched is None else f"τ{case.watched}"
    about = [claim for claim in r.verdicts if claim.id.startswith(f"case-{case.number}-")]
    heads = [claim.id.removeprefix(f"case-{case.number}-") for claim in about]
    measured = ("amplitude [N m]", "phase [°]", "should be [N m]")
    if case.watched is None:
        measured = tuple(f"τ{i} [N m]" for i in range(1, 7))
    title = headline(r, case.number)
    return "\n".join(
        [
            f"### Case {case.number}: {case.claim}",
            "",
            f"θ = {case.in_words()}; watched: {watched}.",
            "",
            f"![{title}](figures/paper-case-{case.number}.svg)",
            "",
            table(("model", *measured, *heads), (case_row(r, run, about) for run in runs)),
        ]
    )


def case_row(r: Reproduction, run: Run, about: list[Claim]) -> list[object]:
    """A model's numbers, and the verdict on each claim about it."""
    came = [next((o.verdict for o in of(r, claim, run)), "") for claim in about]
    if run.harmonic is None:
        numbers = [figures(x) if abs(x) > run.rounding else "0" for x in run.watched]
    elif math.isnan(run.harmonic.phase):
        numbers = ["0", "–", figures(run.expected_peak)]
    else:
        phase = math.degrees(run.harmonic.phase)
        # Half a turn either way is one phase, and rounding decides which.
        shown = f"{180.0 if phase < -179.995 else round(phase, 2) + 0.0:.2f}"
        numbers = [figures(run.harmonic.amplitude), shown, figures(run.expected_peak)]
    return [f"`{run.model.name}`", *numbers, *came]


def of(r: Reproduction, claim: Claim, run: Run) -> Iterator[ClaimOutcome]:
    """The outcomes of a claim on the run's model."""
    return (o for o in r.outcomes(claim.id) if o.model == run.model.name)


def verdicts(r: Reproduction) -> Iterator[tuple[str, ...]]:
    """One row a claim."""
    signs = {"at most": "≤", "at least": "≥", "below": "<", "above": ">"}
    for claim, verdict in r.verdicts.items():
        printed = [o for o in r.outcomes(claim.id) if o.form == "printed"]
        shown = printed[0]
        unit = "" if claim.unit == "1" else f" {claim.unit}"
        small = 0.0 < abs(shown.value) < ROUNDING
        value = "rounding" if small else f"{residue(shown.value)}{unit}"
        limit = f"{signs[shown.bound]} {residue(shown.limit)}{unit}"
        yield claim.text, f"**{verdict}**", value, limit, "; ".join(o.why for o in printed if o.why)


def formulas(r: Reproduction) -> Iterator[tuple[object, ...]]:
    """One row a link."""
    for f in r.formulas:
        found = ("–", "–", "none known")
        if f.formula is not None:
            found = (f"{f.radius:g}", f"{f.length:g}", f.formula.text)
        off = f"{100 * f.honest_error:.1f} %"
        yield f.link, f"{f.across:.9f}", *found, f"{f.honest:.9f}", off


def tests(claims: Iterable[Claim]) -> Iterator[tuple[str, str, str]]:
    """One row a claim."""
    return ((f"`{claim.id}`", claim.test, claim.source) for claim in claims)


def table(heads: tuple[str, ...], rows: Iterable[Iterable[object]]) -> str:
    """As Markdown."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(map(str, line))} |" for line in lines)


if __name__ == "__main__":
    PAGE.write_text(page(reproduce(print)), encoding="utf-8")
