"""Kinds of answers for any subject. The module `base` says what a new kind of answer must define."""
