/* What page and server say to each other. Lengths in m, forces in N, angles in rad. */

export const PROTOCOL = 1;

export type Pair = [number, number];
export type Triple = [number, number, number];

// -- the plain forms of the library ----------------------------------------------------------

export interface OutlineData {
  vertices: Pair[];
  origin: Pair;
  edge_names: string[];
  precision: number;
}

export interface ToleranceData {
  contact: Pair;
  direction: Pair;
  least_limit: number | null;
  may_be_absent: boolean;
}

export interface BodyData {
  length: number;
  beam: number;
}

export interface RobotData {
  contact: Pair;
  direction: number;
  limit: number;
  name: string;
  mounted: boolean;
  tolerance: ToleranceData | null;
  reverse_limit: number;
  steers: number;
  friction: number | null;
  least: number;
  envelope: Pair[] | null;
  group: string;
  sectors: Pair[] | null;
  body: BodyData | null;
  lever: number;
}

export type Attachment = "push" | "pull" | "free";

export interface NewcomerData {
  limit: number;
  attachment: Attachment;
  half_angle: number | null;
  name: string;
  tolerance: ToleranceData | null;
  steers: boolean;
  reverse_limit: number;
  friction: number | null;
  mounted: boolean;
  body: BodyData | null;
}

export interface StretchData {
  start: number;
  end: number;
  name: string;
}

export interface ZoneData {
  stretch: StretchData | null;
  attachment: Attachment | null;
  half_angle: number | null;
  directions: Pair | null;
  area: Pair[] | null;
  name: string;
}

export interface CriterionData {
  losing: number;
  worst_case: boolean;
  load: Triple;
  task: unknown;
  failures: string[][];
}

export interface SwarmData {
  outline: OutlineData;
  robots: RobotData[];
  characteristic_length: number;
  force_weights: Pair;
}

export interface ProblemData {
  swarm: SwarmData;
  newcomer: NewcomerData;
  zones: ZoneData[] | null;
  no_go: StretchData[];
  spacing: number;
  criterion: CriterionData;
}

/** Wind, current or waves: what stands here is changed in the page, the rest is carried along. */
export interface BlowData {
  speed: number | null;
  bearing: number | null;
  [key: string]: unknown;
}

export interface EnvironmentData {
  wind: BlowData;
  current: BlowData | null;
  waves: (BlowData & { height?: number | null }) | null;
  dynamic_factor: number;
}

/** The whole state of the page: what is asked. */
export interface Doc {
  name: string;
  description: string;
  problem: ProblemData;
  environment: EnvironmentData | null;
  in_weather: boolean;
  newcomer: boolean;
}

export interface UnitData {
  unit: string;
  /** SI per unit. */
  size: number;
  /** What people read: t for tf. */
  label: string;
}

export interface SpeechData {
  length: UnitData;
  force: UnitData;
  angle: UnitData;
  speed: UnitData;
  torque_unit: string;
  robot: string;
  bow: number;
  mirrored: boolean;
  heading: number | null;
  bearings: boolean;
}

export interface Fault {
  line: number | null;
  column: number | null;
  path: string;
  sentence: string;
}

// -- from the page ---------------------------------------------------------------------------

export type Outgoing =
  | { kind: "hello"; key: string; protocol: number }
  | { kind: "open"; n: number; name: string }
  | { kind: "text"; n: number; text: string; name: string }
  | { kind: "ask"; n: number; moving: boolean; doc: Doc; speech: SpeechData }
  | { kind: "write"; n: number; doc: Doc; text: string }
  | { kind: "forces"; n: number; doc: Doc; speech: SpeechData; wrench: Triple }
  | { kind: "sequence"; n: number; doc: Doc; speech: SpeechData; robots: number; together: boolean }
  | { kind: "report"; n: number; doc: Doc; text: string; format: "html" }
  | { kind: "run"; n: number; name: string }
  | { kind: "watch"; n: number; on: boolean }
  | { kind: "control"; n: number; robot: string | null; what: "kill" | "stop" | "go on" | "split" | "join" }
  | { kind: "cancel"; n: number };

// -- from the server -------------------------------------------------------------------------

export interface Welcome {
  kind: "welcome";
  protocol: number;
  version: string;
  limits: { message: number; robots: number; [name: string]: number };
  scenes: { name: string; title: string }[];
  opens: string;
  run: string | null;
  watch: boolean;
  demonstration: boolean;
}

export interface Scene {
  kind: "scene";
  n: number;
  name: string;
  text: string;
  doc: Doc;
  speech: SpeechData;
  warnings: Fault[];
}

export type PartName =
  | "answer" | "mesh" | "capability" | "losses" | "slopes" | "landscape" | "proof";

interface Part {
  kind: "part";
  n: number;
  /** What it took the server. */
  ms: number;
}

export interface Figure {
  before: string | null;
  after: string;
  unit: string;
  text: string;
}

export interface Fact {
  mark: "proven" | "weakest" | "loss" | "load" | "note";
  label: string;
  text: string;
  names: string[];
}

export interface NextPlace {
  place: string;
  contact: Pair;
  direction: number;
  value: number;
  text: string;
  share: number;
}

export interface AnswerPart extends Part {
  name: "answer";
  first: { text: string; good: boolean };
  second: string;
  order: { name: string; place: string; contact: Pair; way: number; do: string } | null;
  figures: Figure[];
  facts: Fact[];
  next: NextPlace[];
  newcomer: RobotData | null;
  before: number;
  after: number;
  bound: number | null;
  margin: number | null;
  load: Triple;
  weakest: { wrench: Triple; names: string[] } | null;
  worst_loss: string[] | null;
  question: "quality" | "wind" | "load";
  share: number | null;
}

export interface MeshPart extends Part {
  name: "mesh";
  /** N per step of a corner. */
  unit: number;
  corners: Int16Array;
  faces: Uint16Array;
  starts: Uint16Array;
  normals: Int8Array;
  ball: { centre: Triple; radius: number; touches: Triple; face: number | null } | null;
  before: number | null;
  needed: Triple;
}

export interface CapabilityPart extends Part {
  name: "capability";
  bearings: Float32Array;
  intact: Float32Array;
  lost: Float32Array;
  before_intact?: Float32Array;
  before_lost?: Float32Array;
  least: { bearing: number; speed: number };
  figure: Figure;
}

export interface LossesPart extends Part {
  name: "losses";
  rows: { name: string; value: number; held: boolean; worst: boolean; text: string }[];
  all: number;
  text: string;
}

export interface SlopesPart extends Part {
  name: "slopes";
  rows: { name: string; per_metre: [number | null, number | null]; per_radian: [number | null, number | null]; text: string }[];
}

export interface LandscapePiece {
  name: string;
  edge: string;
  start: number;
  end: number;
  /** Angles off square. */
  rows: number[];
  /** Arc lengths. */
  columns: number[];
  /** Where its values begin, column by column. */
  first: number;
}

export interface LandscapePart extends Part {
  name: "landscape";
  pieces: LandscapePiece[];
  unit: number;
  low: number;
  high: number;
  /** 0 where nothing is allowed, else 1 + value / unit. */
  values: Uint16Array;
  strip: Uint16Array;
}

export interface ProofPart extends Part {
  name: "proof";
  ok: boolean;
  text: string;
}

export type AnyPart =
  | AnswerPart | MeshPart | CapabilityPart | LossesPart | SlopesPart | LandscapePart | ProofPart;

export interface Forces {
  kind: "forces";
  n: number;
  robots: { name: string; force: Pair; share: number; say: string }[];
  top: number;
  shortfall: number;
  say: string;
  held: boolean;
}

export interface Sequence {
  kind: "sequence";
  n: number;
  answers: { newcomer: RobotData; place: string; do: string; before: number; after: number; text: string }[];
}

export type Incoming =
  | Welcome
  | Scene
  | AnyPart
  | { kind: "faults"; n: number; faults: Fault[] }
  | { kind: "empty"; n: number; of: PartName; why: string }
  | { kind: "done"; n: number }
  | { kind: "refused"; n: number; faults: Fault[] }
  | { kind: "text"; n: number; text: string }
  | Forces
  | Sequence
  | { kind: "report"; n: number; html: string }
  | { kind: "run"; n: number; [key: string]: unknown }
  | { kind: "live"; [key: string]: unknown }
  | { kind: "error"; n: number | null; say: string };
