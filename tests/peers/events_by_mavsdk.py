"""Read by MAVSDK, in the peers' own Python: `events_by_mavsdk.py PORT`; a line of JSON with what it has learnt of the
vehicle's metadata, and of its events while it arms, takes off and lands."""

import asyncio
import json
import sys

from mavsdk.asyncio import ComponentType, Configuration, Mavsdk
from mavsdk.asyncio.plugins.action import ActionAsync
from mavsdk.asyncio.plugins.component_metadata import ComponentMetadataAsync, MetadataType
from mavsdk.asyncio.plugins.events import EventsAsync
from mavsdk.asyncio.plugins.telemetry import TelemetryAsync

WITHIN_S = 90.0


async def first(updates, holds):
    async for one in updates:
        if holds(one):
            return one
    return None


async def main():
    configuration = Configuration.create_with_component_type(ComponentType.GROUND_STATION)
    async with Mavsdk(configuration) as mavsdk, asyncio.timeout(WITHIN_S):
        await mavsdk.add_any_connection(f"udpin://127.0.0.1:{sys.argv[1]}")
        while not (systems := await mavsdk.get_systems()):  # a HEARTBEAT comes once a second
            await asyncio.sleep(0.1)
        metadata, action = ComponentMetadataAsync(systems[0]), ActionAsync(systems[0])
        events, telemetry = EventsAsync(systems[0]), TelemetryAsync(systems[0])
        said = []

        async def listen():
            async for event in events.subscribe_events():
                said.append([event.message, event.log_level.name, event.event_namespace])

        listening = asyncio.create_task(listen())
        updates = metadata.subscribe_metadata_available()
        complete = asyncio.create_task(first(updates, lambda one: one.type == MetadataType.ALL_COMPLETED))
        await metadata.request_autopilot_component()
        await complete
        files = {kind: await metadata.get_metadata(1, kind) for kind in (MetadataType.PARAMETER, MetadataType.EVENTS)}
        await first(telemetry.subscribe_health_all_ok(), bool)
        await action.arm()
        await action.takeoff()
        await first(telemetry.subscribe_in_air(), bool)
        await action.land()
        await first(telemetry.subscribe_armed(), lambda armed: not armed)
        while not any(message == "Landed, disarmed" for message, *_ in said):
            await asyncio.sleep(0.1)
        listening.cancel()
        print(json.dumps({"files": {k.name: json.loads(v.json_metadata) for k, v in files.items()}, "said": said}))


asyncio.run(main())
