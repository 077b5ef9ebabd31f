"""The end of the outcome's sentence about faults."""

from gcs.scenario.goal import NAMED
from gcs.supervisor.faults import survival_text


def test_faults_that_were_not_survived_are_named_or_counted() -> None:
    def said(lost: int, of: int) -> str:
        return survival_text([{"survived": k >= lost, "text": f"fault {k}"} for k in range(of)])

    assert said(0, 0) == ""
    assert said(0, 2) == "; 2 of 2 faults survived"
    named = "; ".join(f"fault {k}" for k in range(NAMED))
    assert said(NAMED, NAMED) == f"; 0 of {NAMED} faults survived, not: {named}"
    assert said(NAMED + 1, NAMED + 5) == f"; 4 of {NAMED + 5} faults survived, not: {named}; 1 more"
