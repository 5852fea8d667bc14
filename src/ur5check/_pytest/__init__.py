"""The pytest plugin: the rules as test items, and fixtures of the models that are checked."""
