"""Could a link of this size weigh this much and turn this hard?  Findings, not failures."""
