"""Rules: what can be wrong with a model, one record each, one file a family."""
