"""The hand-written side: one recursion, asked many questions.  Never imports a reference engine."""
