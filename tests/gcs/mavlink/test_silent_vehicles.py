"""Who says nothing but that he is there. Numbers are pymavlink's."""

from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.mavlink.stream_requests import STALE_S, SilentVehicles, everything

HEARTBEAT, ATTITUDE = mav.MAVLINK_MSG_ID_HEARTBEAT, mav.MAVLINK_MSG_ID_ATTITUDE


def test_who_only_beats_is_dealt_with_again_and_again_until_he_tells_more() -> None:
    quiet = SilentVehicles()
    for k in range(12):
        quiet.received(3, HEARTBEAT, 1.0 + k)
        quiet.received(4, HEARTBEAT, 1.0 + k)
        quiet.received(4, ATTITUDE, 1.0 + k)
        assert quiet.due(1.0 + k) == ([3] if k in (STALE_S, 2.0 * STALE_S) else []), k
    quiet.received(3, ATTITUDE, 13.0)
    assert quiet.due(13.0 + STALE_S - 0.1) == [4]
    assert quiet.due(13.0 + STALE_S) == [3]


def test_everything_is_asked_for_in_the_words_that_ardupilot_knows() -> None:
    frame = codec.frame(everything(3, 1), 0, 255, 190)
    (told,) = mav.MAVLink(None).parse_buffer(frame)
    assert told.get_type() == "REQUEST_DATA_STREAM"
    assert (told.target_system, told.target_component) == (3, 1)
    assert (told.req_stream_id, told.req_message_rate, told.start_stop) == (mav.MAV_DATA_STREAM_ALL, 4, 1)
