"""The sections in which `diff` explains a difference, one file each."""
