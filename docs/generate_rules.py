"""Write docs/rules.md from the records of the rules: `python docs/generate_rules.py`."""

from __future__ import annotations

from pathlib import Path

from ur5check._rules.registry import all_rules
from ur5check._rules.rule import FAMILIES, Rule

PAGE = Path(__file__).resolve().parent / "rules.md"

HEAD = """\
# Rules

What `ur5check validate` asks of a model, and what comparing two models, reading what an engine
imported, and expanding a xacro may find. Written from the rules' own records by `python
docs/generate_rules.py`; `ur5check rules ID` prints one of them.

A finding has a rule, a severity, a place (file, line, column), a value with its bound, a
consequence and a fix. **error**: this cannot be a real robot, or an engine refuses or alters
it. **warning**: probably a mistake. **note**: worth knowing. A rule's severity is the most that
its findings have: a massless sensor frame with an impossible tensor is a warning, since no
torque shows it.

Rules judge a model's numbers. The [laws](checks.md) hold for any numbers: they test the
computation.

## What a body of some size can have

Of a body with mass m, centre c and tensor I about c, the spread along a unit vector u is σ =
√(uᵀ Σ u / m) with Σ = ½ tr(I) 1 − I. If all of the body lies between two planes across u, at
*low* and *high*, then σ² ≤ (c − low)(high − c), since (x − low)(high − x) ≥ 0 for each of its
points. `INE108` asks it of a link's own shapes (10 mm are allowed for covers and coarse shapes)
along the axes of link, shapes and tensor. Where there is no shape, `INE109` compares σ with the
link's length from joint to joint and with the robot's reach.

## What a project accepts

"""


def page() -> str:
    """The whole page."""
    rules = list(all_rules().values())
    parts = [HEAD, _configuration()]
    for family, about in FAMILIES.items():
        members = [rule for rule in rules if rule.family == family]
        if members:
            parts.append(f"\n## {family}: {about}\n\n{_table(members)}")
    return "".join(parts)


def _configuration() -> str:
    """The settings, as the reader of configurations describes them."""
    from ur5check._validation import configuration

    text = (configuration.__doc__ or "").strip()
    return (
        text.replace("    fail-level", "```toml\nfail-level", 1)
        .replace("\n\nAn accepted finding", "\n```\n\nAn accepted finding", 1)
        .replace("\n    ", "\n")
        + "\n"
    )


def _table(rules: list[Rule]) -> str:
    lines = ["| rule | severity | what is checked | why | what to do |", "|---|---|---|---|---|"]
    for rule in rules:
        cells = (
            f"`{rule.id}` {rule.name}",
            rule.severity,
            rule.checks,
            f"{rule.why} Otherwise: {rule.consequence}.",
            rule.fix,
        )
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
