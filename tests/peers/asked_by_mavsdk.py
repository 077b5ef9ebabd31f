"""Standard modes and operator control as MAVSDK reads them, in the peers' own Python: `asked_by_mavsdk.py PORT XML`."""

import asyncio
import contextlib
import json
import sys
from pathlib import Path

from mavsdk.asyncio import ComponentType, Configuration, Mavsdk
from mavsdk.asyncio.plugins.mavlink_direct import MavlinkDirectAsync
from mavsdk.plugins.mavlink_direct import MavlinkMessage

WITHIN_S = 60.0
LAND, OURS = 7, 245
LAND_MODE = 4 << 16 | 6 << 24


async def main():
    port, definitions = sys.argv[1:]
    configuration = Configuration.create_with_component_type(ComponentType.GROUND_STATION)
    configuration.system_id = OURS
    async with asyncio.timeout(WITHIN_S), Mavsdk(configuration) as mavsdk:
        await mavsdk.add_any_connection(f"udpin://127.0.0.1:{port}")
        while not (systems := await mavsdk.get_systems()):
            await asyncio.sleep(0.05)
        direct = MavlinkDirectAsync(systems[0])
        await direct.load_custom_xml(Path(definitions).read_text(encoding="utf-8"))
        heard = asyncio.Queue()

        async def listen(name):
            async for message in direct.subscribe_message(name):
                heard.put_nowait((name, json.loads(message.fields_json)))

        async def command(number, *params):
            fields = {f"param{k}": float(value) for k, value in enumerate(params, 1)}
            fields |= {"target_system": 1, "target_component": 1, "command": number, "confirmation": 0}
            sent = MavlinkMessage("COMMAND_LONG", 0, 0, 1, 1, json.dumps(fields))
            return json.loads((await direct.send_command(sent)).fields_json)["result"]

        async def next_of(name, holds=lambda _: True):
            while True:
                kind, fields = await heard.get()
                if kind == name and holds(fields):
                    return fields

        names = ("AVAILABLE_MODES", "CURRENT_MODE", "CONTROL_STATUS")
        listeners = [asyncio.create_task(listen(name)) for name in names]
        await asyncio.sleep(0)
        assert await command(512, 435, 0) == 0
        first = await next_of("AVAILABLE_MODES")
        modes = [first] + [await next_of("AVAILABLE_MODES") for _ in range(first["number_modes"] - 1)]
        assert [one["mode_index"] for one in modes] == list(range(1, len(modes) + 1)), modes
        assert {one["custom_mode"] for one in modes if one["standard_mode"] == LAND} == {LAND_MODE}, modes
        assert await command(262, LAND) == 0
        await next_of("CURRENT_MODE", lambda fields: fields["custom_mode"] == LAND_MODE)
        assert await command(32100, 1, 0, 10, OURS) == 0
        status = await next_of("CONTROL_STATUS")
        assert (status["gcs_main"], status["flags"]) == (OURS, 1), status
        assert await command(32100, 0, 0, 10, OURS) == 0
        status = await next_of("CONTROL_STATUS", lambda fields: fields["gcs_main"] == 0)
        assert status["flags"] == 3, status
        for listener in listeners:
            listener.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await listener


asyncio.run(main())
