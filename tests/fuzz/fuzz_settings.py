"""Settings of the fuzz targets: few examples in a normal run, and as many as the profile says under `nox -s fuzz` or `evidence`."""

from contextlib import suppress

from hypothesis import HealthCheck, settings

IS_FUZZING = settings.get_current_profile_name() in {"fuzz", "nightly"}

MEMORY_BYTES = 6 << 30

if IS_FUZZING:
    with suppress(ImportError):  # Windows has no such limit; elsewhere a case that needs too much memory fails
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))


def fuzz_settings(max_examples):
    """Return the settings of one target; `max_examples` is for normal runs."""
    examples = {} if IS_FUZZING else {"max_examples": max_examples}
    return settings(suppress_health_check=list(HealthCheck), **examples)
