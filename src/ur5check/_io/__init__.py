"""Reading and writing models: files, the shipped models, models of engines.

`loading.load` reads any of them; `formats` lists the file formats, one folder each.
"""
