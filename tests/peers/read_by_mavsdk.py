"""Read by MAVSDK, in the peers' own Python: frames in hex on stdin, one a line; what it makes of each on stdout."""

import queue
import sys

from mavsdk.mavsdk import Configuration, Mavsdk
from mavsdk.plugins.mavlink_direct_server.mavlink_direct_server import MavlinkDirectServer

with Mavsdk(Configuration.create_manual(200, 1, False)) as mavsdk:
    mavsdk.add_any_connection("raw://")
    read = queue.SimpleQueue()
    direct = MavlinkDirectServer(mavsdk.server_component(0))
    direct.subscribe_message("", lambda message, _: read.put(message))
    for line in sys.stdin:
        mavsdk.pass_received_raw_bytes(bytes.fromhex(line))
        try:
            message = read.get(timeout=2.0)
        except queue.Empty:
            print("nothing")
        else:
            print("read", message.system_id, message.component_id, message.fields_json)
