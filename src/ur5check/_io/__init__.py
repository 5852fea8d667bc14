"""Where an arm comes from: files, the shipped models, engines' models.

All reading, and all strictness, is here.

`load` in `loading` is the one door; the readers behind it stand in files of their own.
"""
