// Made of gcs/schemas/messages.schema.json by types.mjs.

/** The first line, and again when what it says has changed. */
export interface SessionLine {
  type: "session";
  name: string;
  folder: string | null;
  source: "monitor" | "replay" | "session";
  duration_s: number | null;
  clock: "lockstep" | "real" | "replay";
  speed: number | null;
  control: boolean;
  separation_m: number | null;
  ring_m: number | null;
  vehicles: (MemberRow)[];
  obstacles: (ObstacleRow)[];
  bases: (BaseRow)[];
  goal: GoalRow;
  origin?: [number, number, number] | null;
  wind?: WindRow | null;
  events?: (EventRow)[];
  told?: number;
  contest?: ([number, Record<string, number>])[];
}

/** A vehicle, and its route. */
export interface MemberRow {
  sysid: number;
  role: string;
  label: string;
  capacity_j: number | null;
  path_ned: ([number, number, number])[];
  colour: number;
}

/** An obstacle to draw: outline from above, centre, and the down coordinates where it begins and ends. */
export interface ObstacleRow {
  name: string | null;
  label: string;
  kind: string;
  outline_ne: ([number, number])[];
  centre_ned: [number, number, number];
  radius_m: number | null;
  bottom_d: number;
  top_d: number;
}

/** A base. */
export interface BaseRow {
  name: string;
  p_ned: [number, number, number];
}

/** Goal of the session. */
export interface GoalRow {
  separation_m: number | null;
  clearance_m: number | null;
  traffic_m: number | null;
  pursue_within_m: number | null;
  pursue_for_s: number | null;
  refuelled_at_least: number;
}

/** Mean wind, and where it comes from, degrees clockwise from north. */
export interface WindRow {
  speed_m_s: number;
  from_deg: number;
}

/** A happening; `sysid` 0 is the ground station, 255 the traffic. */
export interface EventRow {
  t_s: number;
  sysid: number;
  level: "critical" | "info" | "warning";
  text: string;
  kind: "ack" | "death" | "decision" | "failsafe" | "fault" | "link" | "mode" | "operator" | "session" | "text" | "violation";
}

/** The state at a session time, with the events since the last one. */
export interface SnapshotMessage {
  type: "snapshot";
  t_s: number;
  duration_s: number | null;
  speed: number | null;
  phase: string;
  vehicles: (VehicleRow)[];
  traffic: (TrafficRow)[];
  competition: CompetitionRow;
  services: (ServiceRow)[];
  history: (ServedRow)[];
  refuelled: number;
  goal: GoalStateRow;
  inspected: Record<string, Record<string, InspectedRow>>;
  events: (EventRow)[];
  bases?: (StockRow)[];
  replay?: ReplayRow;
}

/** A vehicle at the snapshot's time. */
export interface VehicleRow {
  sysid: number;
  role: string;
  label: string;
  alive: boolean;
  stage: string;
  mode: string;
  armed: boolean;
  landed: boolean;
  autopilot: string | null;
  p_ned: [number, number, number] | null;
  v_ned: [number, number, number];
  speed_m_s: number;
  height_m: number | null;
  heading_rad: number;
  roll_rad: number;
  pitch_rad: number;
  aim_ned: [number, number, number] | null;
  margin_m: number | null;
  age_s: number | null;
  heard_s: number | null;
  lost: number;
  lost_share: number | null;
  target_m: number | null;
  battery: number | null;
  remaining_j: number | null;
  power_w: number | null;
  endurance_s: number | null;
  energy_source: string;
  v: number | null;
  tau: number | null;
  state: string;
  trouble: (string)[];
  severity: number;
  note: string;
}

/** An aircraft by its ADSB_VEHICLE. */
export interface TrafficRow {
  callsign: string;
  p_ned: [number, number, number];
  v_ned: [number, number, number];
  age_s: number;
}

/** The competition, by system id as text; `threshold` is the share that wins it. */
export interface CompetitionRow {
  v: Record<string, number>;
  tau: Record<string, number>;
  leader: number | null;
  share: number | null;
  runner_up: number | null;
  threshold: number;
}

/** A refuelling under way. */
export interface ServiceRow {
  receiver: number;
  tanker: number | null;
  base: string | null;
  phase: string;
  energy_j: number;
  by: string;
  decided_at_s: number;
  joined_at_s: number | null;
  rendezvous_ned: [number, number, number] | null;
  bids: Record<string, number>;
  why: string;
}

/** A refuelling that has ended. */
export interface ServedRow {
  receiver: number;
  tanker: number | null;
  base: string | null;
  by: string;
  decided_at_s: number;
  joined_at_s: number | null;
  start_s: number | null;
  end_s: number | null;
  energy_j: number;
  reason: string;
}

/** The goal, for how long its pursuit has been held, and what of it is broken. */
export interface GoalStateRow {
  separation_m: number | null;
  clearance_m: number | null;
  traffic_m: number | null;
  pursue_within_m: number | null;
  pursue_for_s: number | null;
  refuelled_at_least: number;
  pursue_held_s: number | null;
  broken: (BrokenRow)[];
}

/** A part of the goal that can no longer be met. */
export interface BrokenRow {
  part: string;
  text: string;
  t_s: number | null;
}

/** The latest of one message of an inspected vehicle, fields in MAVLink's own units. */
export interface InspectedRow {
  count: number;
  rate_hz: number | null;
  age_s: number;
  fields: Record<string, unknown>;
}

/** Energy of a base. */
export interface StockRow {
  name: string;
  remaining_j: number;
  stock_j: number;
}

/** Begin and end of a recording, and how it is played; speed None: without waiting. */
export interface ReplayRow {
  from_s: number;
  to_s: number;
  speed: number | null;
  paused: boolean;
}

/** The answer to a line of a client's; `id` is the one given in it. */
export interface Reply {
  type: "reply";
  id: string | number | null;
  ok: boolean;
  text: string;
}

/** The last line. */
export interface End {
  type: "end";
  outcome: string;
  text: string;
  exit: number;
}

export type Line = SessionLine | SnapshotMessage | Reply | End;
