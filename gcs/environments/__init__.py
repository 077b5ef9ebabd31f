"""Sessions as environments of reinforcement learning, as PettingZoo and Gymnasium have them: many agents by
`gcs.parallel_env`, one by `gymnasium.make("gcs.environments:skytender/Session-v0", scenario="demo")`.

Importing this package registers the latter; it needs the extra `learn`.
"""

from gcs.extras import require

require("gcs.environments", {"gymnasium": "Gymnasium", "pettingzoo": "PettingZoo"}, "learn")

import gymnasium  # noqa: E402 - what is missing is said first

ID = "skytender/Session-v0"

gymnasium.register(ID, entry_point="gcs.environments.single:SessionEnv")
