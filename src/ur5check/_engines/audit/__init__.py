"""Engine agreement: what each engine imported, and how far apart the engines' answers are."""
