"""A refuelling policy of one's own: in turn, whoever was served longest ago."""

from gcs import RefuellingRequest, Scenario


class InTurn:
    def __init__(self, scenario: Scenario) -> None:
        self.served_at_s = {pursuer.sysid: -1.0 for pursuer in scenario.vehicles.pursuers}

    def choose(self, request: RefuellingRequest) -> int | None:
        waiting = [view.sysid for view in request.candidates]
        chosen = min(waiting, key=lambda sysid: (self.served_at_s[sysid], sysid))
        self.served_at_s[chosen] = request.time_s
        return chosen
