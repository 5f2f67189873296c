"""From a submission to its result: the redacted sheet, the answers that came out, the judge."""
