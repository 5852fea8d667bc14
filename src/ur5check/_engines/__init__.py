"""Physics engines behind one protocol, what each does to a model it reads, and the conformance
suite.  An engine is imported when it is first used."""
