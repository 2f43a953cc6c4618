/* What page and server say to each other. Lengths in m, forces in N, angles in rad.

Made of the server's messages and the library's plain forms by `make page`: do not edit. */

export type Pair = [number, number];
export type Triple = [number, number, number];

export const PROTOCOL = 1;

/** A simple polygon, convex or not, with the point that moments are taken about. */
export interface OutlineData {
  vertices: Pair[];
  origin: Pair;
  edge_names: string[];
  precision: number;
}

/** How far a robot's pose and strength may be from what they are said to be. */
export interface ToleranceData {
  contact: Pair;
  direction: Pair;
  least_limit: number | null;
  may_be_absent: boolean;
}

/** The room that a robot takes up, away from its contact: of one that pulls, its line too. */
export interface BodyData {
  length: number;
  beam: number;
}

/** A robot in contact with the object, and the forces that it can exert there. */
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

/** Robots in contact with an object, each known by its name. */
export interface SwarmData {
  outline: OutlineData;
  robots: RobotData[];
  characteristic_length: number;
  force_weights: Pair;
}

/** The robot to place: how hard it can push and which way it may. */
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

/** A stretch of the boundary, counter-clockwise from `start` to `end`. */
export interface StretchData {
  start: number;
  end: number;
  name: string;
}

/** Where a newcomer may attach, and how it may push there. */
export interface ZoneData {
  stretch: StretchData | null;
  attachment: Attachment | null;
  half_angle: number | null;
  directions: Pair | null;
  area: Pair[] | null;
  name: string;
}

/** The convex hull of some wrenches and of no wrench at all. */
export interface PolytopeData {
  vertices: Triple[];
}

/** An ellipsoid of wrenches around no wrench: all sum x_k a_k with sum x_k^2 <= 1. */
export interface EllipsoidData {
  axes: Triple[];
}

/** What quality means: how much of a task is left in the worst of cases. */
export interface CriterionData {
  losing: number;
  worst_case: boolean;
  load: Triple;
  task: PolytopeData | EllipsoidData | null;
  failures: string[][];
}

/** One newcomer looking for a place. */
export interface ProblemData {
  swarm: SwarmData;
  newcomer: NewcomerData;
  zones: ZoneData[] | null;
  no_go: StretchData[];
  spacing: number;
  criterion: CriterionData;
}

/** Blendermann's coefficients of what a vessel shows to the wind. */
export interface WindCoefficientsData {
  transverse: number;
  bow: number;
  stern: number;
  cross_force: number;
}

/** What the object shows to the wind, and perhaps a wind. */
export interface WindData {
  frontal_area: number;
  lateral_area: number;
  coefficients: WindCoefficientsData;
  lateral_centroid: number;
  speed: number | null;
  bearing: number | null;
  density: number;
}

/** The loads of winds by speed and bearing, and perhaps a wind. */
export interface WindTableData {
  speeds: number[];
  bearings: number[];
  loads: Triple[][];
  about: Pair | null;
  speed: number | null;
  bearing: number | null;
}

/** Drag coefficients of the underwater hull; those of DNV-ST-0111 for a ship by default. */
export interface CurrentCoefficientsData {
  surge: number;
  sway: number;
}

/** What the object shows to the current, and the current. */
export interface CurrentData {
  frontal_area: number;
  lateral_area: number;
  speed: number;
  bearing: number | null;
  coefficients: CurrentCoefficientsData;
  lateral_centroid: number;
  density: number;
}

/** A sea, and what of the object meets it; the outline is taken for the waterline. */
export interface WavesData {
  height: number | null;
  period: number | null;
  bearing: number | null;
  bow_angle: number | null;
  aft_fullness: number | null;
  density: number;
}

/** Wind, current and waves around an object. */
export interface EnvironmentData {
  wind: WindData | WindTableData;
  current: CurrentData | null;
  dynamic_factor: number;
  waves: WavesData | null;
}

/** The state of a page: what is asked, in SI units and our frame. */
export interface Doc {
  name: string;
  description: string;
  problem: ProblemData;
  environment: EnvironmentData | null;
  in_weather: boolean;
  newcomer: boolean;
}

/** A unit: its name in the library, its size in SI units, and what people read. */
export interface UnitData {
  unit: string;
  size: number;
  label: string;
}

/** How a file's people speak; angles in radians, the bow in the file's frame. */
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

/** The verdict, and whether it is a good one. */
export interface First {
  text: string;
  good: boolean;
}

/** Who goes where, and does what: a force acts on the object along `way` [rad]. */
export interface Order {
  name: string;
  place: string;
  contact: Pair;
  way: number;
  do: string;
}

/** A large figure before and after, in a unit that people read. */
export interface Figure {
  before: number | null;
  after: number;
  unit: string;
  text: string;
}

/** A fact with the mark that is its key in the pictures. */
export interface Fact {
  mark: "proven" | "weakest" | "loss" | "load" | "note";
  label: string;
  text: string;
  names: string[];
}

/** The best of another place; its share is of the best of all. */
export interface NextPlace {
  place: string;
  contact: Pair;
  direction: number;
  value: number;
  text: string;
  share: number;
}

/** The weakest wrench [N, N, N m], and who sets it. */
export interface WeakestTold {
  wrench: Triple;
  names: string[];
}

/** The answer in words and figures. */
export interface AnswerPart {
  name: "answer";
  kind: "part";
  n: number;
  ms: number;
  question: "quality" | "wind" | "load";
  first: First;
  second: string;
  order: Order | null;
  figures: Figure[];
  facts: Fact[];
  next: NextPlace[];
  newcomer: RobotData | null;
  before: number;
  after: number;
  bound: number | null;
  margin: number | null;
  load: Triple;
  weakest: WeakestTold | null;
  worst_loss: string[] | null;
  share: number | null;
}

/** The largest ball, in the mesh's steps: where it is, and where it touches which face. */
export interface Ball {
  centre: Triple;
  radius: number;
  touches: Triple;
  face: number | null;
}

/** The wrench set in the metric's coordinates, in whole steps of `unit` newtons. */
export interface MeshPart {
  name: "mesh";
  kind: "part";
  n: number;
  ms: number;
  unit: number;
  ball: Ball | null;
  before: number | null;
  needed: Triple;
  corners: Int16Array;
  faces: Uint16Array;
  starts: Uint16Array;
  normals: Int8Array;
}

/** The least wind held [m/s], from a bearing [rad]. */
export interface Least {
  bearing: number;
  speed: number;
}

/** The winds held [m/s] at bearings [rad] clockwise from the bow; none is told as NaN. */
export interface CapabilityPart {
  name: "capability";
  kind: "part";
  n: number;
  ms: number;
  least: Least;
  figure: Figure;
  bearings: Float32Array;
  intact: Float32Array;
  lost: Float32Array;
  before_intact?: Float32Array;
  before_lost?: Float32Array;
}

/** What the loss of one leaves [N]. */
export interface LossRow {
  name: string;
  value: number;
  held: boolean;
  worst: boolean;
  text: string;
}

/** What each loss leaves, the worst first, and what all have together [N]. */
export interface LossesPart {
  name: "losses";
  kind: "part";
  n: number;
  ms: number;
  rows: LossRow[];
  all: number;
  text: string;
}

/** How fast the quality rises when one robot moves [N/m] the better way, or turns [N/deg]. */
export interface Slope {
  name: string;
  per_metre: number | null;
  direction: number | null;
  per_degree: number | null;
  text: string;
}

/** The slopes of every robot: clockwise along the boundary or in turning, and the other way. */
export interface SlopesPart {
  name: "slopes";
  kind: "part";
  n: number;
  ms: number;
  rows: Slope[];
}

/** A piece of the boundary: its arc lengths [m], and the part of the array that is its own. */
export interface LandscapePiece {
  name: string;
  edge: string;
  start: number;
  end: number;
  columns: number[];
  rows: number[];
  first: number;
}

/** The quality at every allowed place and direction. */
export interface LandscapePart {
  name: "landscape";
  kind: "part";
  n: number;
  ms: number;
  pieces: LandscapePiece[];
  unit: number;
  low: number;
  high: number;
  values: Uint16Array;
  strip: Uint16Array;
}

/** What the check says of the answer. */
export interface ProofPart {
  name: "proof";
  kind: "part";
  n: number;
  ms: number;
  ok: boolean;
  text: string;
}

/** What a page keeps to: bytes of a message, messages a second, robots. */
export interface Limits {
  message: number;
  rate: number;
  text: number;
  robots: number;
}

/** A scene to choose. */
export interface SceneTitle {
  name: string;
  title: string;
}

/** The answer to the right key: what there is, and whether it can be asked for. */
export interface Welcome {
  kind: "welcome";
  protocol: number;
  version: string;
  limits: Limits;
  scenes: SceneTitle[];
  opens: string;
  run: string | null;
  watch: boolean;
  demonstration: boolean;
  reports: boolean;
}

/** One thing that is wrong: at a line and column of the text, or at a key of the document. */
export interface Fault {
  line: number | null;
  column: number | null;
  path: string;
  sentence: string;
}

/** A scenario as it was read. */
export interface Scene {
  kind: "scene";
  n: number;
  name: string;
  text: string;
  doc: Doc;
  speech: SpeechData;
  warnings: Fault[];
}

/** What is wrong with a text. */
export interface Faults {
  kind: "faults";
  n: number;
  faults: Fault[];
}

/** What is wrong with a document. */
export interface Refused {
  kind: "refused";
  n: number;
  faults: Fault[];
}

/** Why a part has nothing. */
export interface Empty {
  kind: "empty";
  n: number;
  of: PartName;
  why: string;
}

/** All parts of an ask have been told. */
export interface Done {
  kind: "done";
  n: number;
}

/** What could not be done. */
export interface ErrorTold {
  kind: "error";
  n: number | null;
  say: string;
}

/** The text of a document. */
export interface Written {
  kind: "text";
  n: number;
  text: string;
}

/** The force [N, N] of one robot, and its share of the largest it has that way. */
export interface ForceTold {
  name: string;
  force: Pair;
  share: number;
  say: string;
}

/** How hard each robot pushes: the largest share, and by how much [N] it falls short. */
export interface Forces {
  kind: "forces";
  n: number;
  robots: ForceTold[];
  top: number;
  shortfall: number;
  say: string;
  held: boolean;
}

/** One of several newcomers in its place, with the quality [N] before it came and after. */
export interface Placed {
  newcomer: RobotData;
  place: string;
  do: string;
  before: number;
  after: number;
  text: string;
}

/** Several newcomers, and how far from the best they can be. */
export interface Sequence {
  kind: "sequence";
  n: number;
  answers: Placed[];
  say: string;
}

/** The sheet as one file. */
export interface Report {
  kind: "report";
  n: number;
  html: string;
}

/** A robot of a run: its contact from the outline's origin, its way [rad], when it is there [s]. */
export interface RunRobot {
  name: string;
  contact: Pair;
  direction: number;
  limit: number;
  newcomer: boolean;
  there: Pair[];
}

/** The way of a robot that is sent, in the object's frame, and its times [s]. */
export interface RunRoute {
  robot: string;
  start: number;
  arrival: number;
  joined: number;
  points: Pair[];
}

/** Something that happened. */
export interface RunHappening {
  time: number;
  kind: string;
  robot: string;
  words: string;
}

/** A recorded run of m instants and n robots, in the earth's frame. */
export interface Run {
  kind: "run";
  n: number;
  name: string;
  first: First;
  second: string;
  seed: number;
  within: number;
  turn: number;
  outline: Pair[];
  robots: RunRobot[];
  routes: RunRoute[];
  happenings: RunHappening[];
  times: Float32Array;
  poses: Float32Array;
  references: Float32Array;
  wind: Float32Array;
  water: Float32Array;
  shortfalls: Float32Array;
  forces: Float32Array;
  angles: Float32Array;
}

/** An agent: where it is or will be, by how many of how many it is confirmed, whom it hears. */
export interface LiveRobot {
  name: string;
  phase: "idle" | "coming" | "arrived" | "making fast" | "holds" | "leaving" | "left" | "not answering";
  at: Pair | null;
  direction: number | null;
  limit: number;
  confirmed: number;
  of: number;
  hears: number | null;
  deaf: string[];
  there: boolean;
  process: "runs" | "stopped" | "ended" | null;
}

/** What has changed among agents, or all of it if `whole`; several sides when they are cut. */
export interface Live {
  kind: "live";
  t: number;
  whole: boolean;
  first: First;
  second: string;
  certified: number | null;
  robots: LiveRobot[];
  sides: string[][];
  conflicts: string[];
  cut: boolean | null;
}

export type Attachment =
  | "push"
  | "pull"
  | "free";

export type PartName =
  | "answer"
  | "mesh"
  | "capability"
  | "losses"
  | "landscape"
  | "slopes"
  | "proof";

export type AnyPart =
  | AnswerPart
  | MeshPart
  | CapabilityPart
  | LossesPart
  | SlopesPart
  | LandscapePart
  | ProofPart;

export type Outgoing =
  | { kind: "hello"; key: string; protocol: number }
  | { kind: "open"; n: number; name: string }
  | { kind: "text"; n: number; text: string; name: string }
  | { kind: "ask"; n: number; moving: boolean; doc: Doc; speech: SpeechData; wants?: PartName[] | null; names?: string[] | null }
  | { kind: "write"; n: number; doc: Doc; text: string; names?: string[] | null }
  | { kind: "forces"; n: number; doc: Doc; speech: SpeechData; wrench: Triple; names?: string[] | null }
  | { kind: "sequence"; n: number; doc: Doc; speech: SpeechData; robots: number; together: boolean; names?: string[] | null }
  | { kind: "report"; n: number; doc: Doc; speech: SpeechData; text: string; format: "html"; names?: string[] | null }
  | { kind: "run"; n: number; name: string }
  | { kind: "watch"; n: number; on: boolean }
  | { kind: "control"; n: number; robot: string | null; what: "kill" | "stop" | "go on" | "come" | "leave" | "split" | "join" }
  | { kind: "cancel"; n: number };

export type Incoming =
  | AnyPart
  | Welcome
  | Scene
  | Faults
  | Refused
  | Empty
  | Done
  | ErrorTold
  | Written
  | Forces
  | Sequence
  | Report
  | Run
  | Live;
