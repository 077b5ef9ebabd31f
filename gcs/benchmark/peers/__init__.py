"""Methods of the field on the benchmark's instances, under the same rules and in equal time."""
