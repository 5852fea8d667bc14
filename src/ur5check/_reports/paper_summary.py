"""The paper's verdicts in sentences: the summary, the findings, and a headline for each case.

Every number in them is measured; the sentences follow the verdicts.
"""

from __future__ import annotations

from collections import Counter

from .._paper.paper_models import PRINTED, REPAIRED
from .._paper.reproduction import Reproduction
from .mistake_sentences import sentence

__all__ = ["headline", "headline_of_all", "summarize", "summary"]

#: For each case its own claim, and the headline when it holds and when it fails.
_OWN = {
    1: ("case-1-sine", "A sine, as claimed", "No sine"),
    2: ("case-2-expected", "As expected", "Not as expected"),
    3: ("case-3-less", "Less than case 2, as claimed", "Not less than case 2"),
    4: ("case-4-zero", "Zero and constant, as claimed", "Not zero"),
    5: ("case-5-sine", "A sine, as claimed", "No sine"),
    6: ("case-6-expected", "As expected", "Not as expected"),
    7: ("case-7-low", "Low, as claimed", "Not low"),
    8: ("case-8-low", "Low, as claimed", "Not low"),
}

#: Claims on the shape of a curve, by which the paper judged its program.
_SHAPES = ("-sine", "-less", "-zero", "-low")

#: Claims that the torque itself is right.
_TORQUES = ("-expected", "-holds")


def summary(r: Reproduction) -> str:
    """The verdict in one sentence."""
    count = Counter(r.verdicts.values())
    return (
        f"of {len(r.verdicts)} claims of the paper, {count['confirmed']} are confirmed, "
        f"{count['confirmed after repair']} only after a repair, {count['refuted']} refuted."
    )


def summarize(r: Reproduction) -> list[str]:
    """The findings, one sentence each."""
    return [
        line
        for line in (
            _case_2(r),
            _case_9_sign(r),
            _readings(r),
            _listing_mistakes(r),
            _shapes(r),
            _lightness(r),
            _tensors(r),
            _soft(r),
        )
        if line
    ]


def headline(r: Reproduction, number: int) -> str:
    """What one case shows."""
    if number == 9:
        return _case_9(r)
    claim, yes, no = _OWN[number]
    printed = _printed_holds(r, claim)
    then = _as_printed(r, number)
    if number == 4 and printed:
        then = next(o.why for o in r.outcomes(claim) if o.form == "printed")
    if number == 8 and printed and _weightless(r):
        then = "zero, whatever link 6 weighs"
    return f"{yes if printed else no}; {then}" if then else (yes if printed else no)


def headline_of_all(r: Reproduction) -> str:
    """What the nine cases show together."""
    shapes = _shape_claims(r)
    held = sum(_printed_holds(r, claim) for claim in shapes)
    torques = [c.id for c in r.verdicts if c.id.startswith("case-") and c.id.endswith(_TORQUES)]
    wrong = sum(not _printed_holds(r, claim) for claim in torques)
    return (
        f"As printed, {held} of {len(shapes)} claims on a curve's shape hold, and {wrong} of "
        f"{len(torques)} torques are wrong"
    )


def _as_printed(r: Reproduction, number: int) -> str:
    """The printed curve compared with the moment of the weights."""
    run = r.run(number, PRINTED)
    if _printed_holds(r, f"case-{number}-expected"):
        appendix = r.run(number, "appendix")
        part = 100.0 * (appendix.peak / run.peak - 1.0) if run.peak else 0.0
        more = "more" if part > 0.0 else "less"
        return f"the appendix needs {abs(part):.0f} % {more}" if part else ""
    if not run.expected_peak:
        return f"as printed {run.peak:.3g} N m, with nothing to hold"
    part = 100.0 * (run.peak / run.expected_peak - 1.0)
    turned = ", of opposite sign" if run.opposed else ""
    return f"as printed {abs(part):.1f} % too {'large' if part > 0.0 else 'small'}{turned}"


def _case_9(r: Reproduction) -> str:
    run = r.run(9, PRINTED)
    if _printed_holds(r, "case-9-holds"):
        return "The torques as printed hold the arm"
    joint = int(abs(run.watched - run.expected_watched).argmax())
    tau, wanted = run.watched[joint], run.expected_watched[joint]
    how = "is given the wrong sign" if tau * wanted < 0.0 else "is given a wrong torque"
    return f"As printed, joint {joint + 1} {how}: {_signed(tau, 0)} for {_signed(wanted, 0)} N m"


def _case_2(r: Reproduction) -> str:
    run = r.run(2, PRINTED)
    part = 100.0 * (run.peak / run.expected_peak - 1.0)
    sign = "opposite" if run.opposed else "same"
    return (
        f"As printed, joint 2 needs up to {run.peak:.2f} N m in case 2; with the controller's DH "
        f"and the paper's own gravity it needs {run.expected_peak:.2f} N m: {abs(part):.1f} % too "
        f"{'large' if part > 0.0 else 'small'}, of {sign} sign."
    )


def _case_9_sign(r: Reproduction) -> str:
    (nine,) = (effect for effect in r.effects if effect.case == 9)
    return (
        f"Case 9 sends joint {nine.joint} {_signed(nine.printed)} N m where the controller's DH "
        f"needs {_signed(nine.table)} N m: the {'wrong' if nine.ratio < 0.0 else 'right'} sign."
    )


def _readings(r: Reproduction) -> str:
    two = next(effect for effect in r.effects if effect.case == 2)
    return (
        "Table 1 prints −a2 and −a3. With the appendix's a2 = −0.425 m that is +0.425 m, which is "
        "the listing's vector and not the robot's: table and listing then differ in the sign of "
        f"link 5 only ({two.literal_peak:.2f} against {r.run(2, PRINTED).peak:.2f} N m in case 2), "
        "and both contradict the appendix. With a2 > 0 the table is the controller's DH, and the "
        "listing has lost two more signs."
    )


def _listing_mistakes(r: Reproduction) -> str:
    left = max(effect.left for effect in r.effects)
    gap = max(effect.gap for effect in r.effects)
    diagnosis = r.listing_mistakes.diagnosis
    found = "; ".join(sentence(mistake, diagnosis.pair) for mistake in diagnosis.mistakes)
    return (
        "Compared with the controller's DH under one gravity, diagnosis finds in the listing: "
        f"{found}. Repairing them reduces the largest torque difference in the cases from "
        f"{gap:.0f} to {left:.1g} N m."
    )


def _shapes(r: Reproduction) -> str:
    shapes = _shape_claims(r)
    held = sum(_printed_holds(r, claim) for claim in shapes)
    if held < len(shapes):
        return f"Of {len(shapes)} claims on the shape of a curve, {held} hold as printed."
    return (
        f"All {held} claims on the shape of a curve hold for the program as printed: the gravity "
        "torque of the joint that turns is a sine for any arm, so that a shape cannot reveal a "
        "wrong number."
    )


def _lightness(r: Reproduction) -> str:
    if not _weightless(r):
        return ""
    (seven,) = (o for o in r.outcomes("case-7-light") if o.model == REPAIRED)
    (eight,) = (o for o in r.outcomes("case-8-light") if o.model == REPAIRED)
    return (
        "The torques of cases 7 and 8 are low, but that of case 8 not because link 6 is light: it "
        f"is {eight.why}. In case 7, link 5 is the cause of {100.0 * seven.value:.0f} % of the "
        "torque."
    )


def _tensors(r: Reproduction) -> str:
    honest = [f for f in r.formulas if f.formula is not None and f.formula.honest]
    made = Counter(f.formula.text for f in r.formulas if f.formula is not None)
    if not made:
        return "No known formula gives the printed inertia tensors."
    text, count = made.most_common(1)[0]
    return (
        f"{len(honest)} of {len(r.formulas)} printed inertia tensors follow eq. 3, m(3r² + l²)/12; "
        f"{count} follow {text}, to every digit printed."
    )


def _soft(r: Reproduction) -> str:
    wrong = [o for o in r.outcomes("soft-limits") if o.form == "printed" and not o.holds]
    if not wrong:
        return ""
    return f"One joint's soft limits lie outside its own, and never act: {wrong[0].why}."


def _printed_holds(r: Reproduction, claim: str) -> bool:
    return all(outcome.holds for outcome in r.outcomes(claim) if outcome.form == "printed")


def _shape_claims(r: Reproduction) -> list[str]:
    return [claim.id for claim in r.verdicts if claim.id.endswith(_SHAPES)]


def _weightless(r: Reproduction) -> bool:
    """Whether case 8's torque is zero for every model."""
    return not any(run.peak for run in r.cases if run.case.number == 8)


def _signed(value: float, decimals: int = 1) -> str:
    return f"{value:+.{decimals}f}".replace("-", "−")
