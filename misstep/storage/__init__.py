"""Answers as JSON: serialized where a submission runs, deserialized where it is judged."""
