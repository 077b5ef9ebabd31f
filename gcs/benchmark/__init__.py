"""A benchmark of refuelling schedules: instances, schedules, and a verifier of both (docs/refuelling-benchmark.md)."""
