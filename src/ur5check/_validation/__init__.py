"""Laws that can fail.  Those of `laws` hold for any numbers; those of `numbers` are about them."""
