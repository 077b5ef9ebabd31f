"""A plan compared by MAVSDK, in the peers' own Python: `plans_by_mavsdk.py PORT FILE HOME`.

Its own reading of a .plan against what it downloads from vehicle 1, of which the first HOME items are home.
"""

import asyncio
import math
import sys

from mavsdk.asyncio import ComponentType, Configuration, Mavsdk
from mavsdk.asyncio.plugins.mission_raw import MissionRawAsync

WITHIN_S = 90.0


def same(own, other):
    numbers = [(getattr(own, name), getattr(other, name)) for name in ("param1", "param2", "param3", "param4", "z")]
    close = all(math.isnan(a) or math.isclose(a, b, abs_tol=0.011) for a, b in numbers)
    return close and all(getattr(own, name) == getattr(other, name) for name in ("command", "autocontinue"))


async def main():
    port, path, home = sys.argv[1:]
    configuration = Configuration.create_with_component_type(ComponentType.GROUND_STATION)
    async with asyncio.timeout(WITHIN_S), Mavsdk(configuration) as mavsdk:
        await mavsdk.add_any_connection(f"udpin://127.0.0.1:{port}")
        while not (systems := await mavsdk.get_systems()):
            await asyncio.sleep(0.1)
        raw = MissionRawAsync(systems[0])
        read = await raw.import_qgroundcontrol_mission(path)
        plan = getattr(read, "data", read)
        for name, own, other in (
            ("mission", plan.mission_items, (await raw.download_mission())[int(home) :]),
            ("fence", plan.geofence_items, await raw.download_geofence()),
            ("rally", plan.rally_items, await raw.download_rallypoints()),
        ):
            assert len(own) == len(other) > 0, (name, len(own), len(other))
            for k, (a, b) in enumerate(zip(own, other, strict=True)):
                assert name == "fence" or same(a, b), (name, k, str(a), str(b))
                assert a.frame == 2 or (a.command, a.x, a.y) == (b.command, b.x, b.y), (name, k, str(a), str(b))
            print(name, len(own), flush=True)


asyncio.run(main())
