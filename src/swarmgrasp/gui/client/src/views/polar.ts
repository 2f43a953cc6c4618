/* The wind rose's measures: rim, rings, and where their figures stand. In units of the page, no DOM. */

const STEPS = [1, 2, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000, 2000, 2500, 5000];
const MOST_RINGS = 4;
/** A rim never smaller than this; in SI it is 40 kn. */
export const LEAST_RIM = 40 * (1852 / 3600);
/** A rim stays until another is so much larger or smaller, so that it is calm under a hand. */
const CALM = 1.12;

export interface Reach {
  readonly intact: readonly number[];
  readonly lost: readonly number[];
  /** Speed of the wind that is asked about, or 0. */
  readonly wind: number;
}

export interface Rim {
  /** Speed at the rim: a whole number of rings. */
  readonly rim: number;
  readonly step: number;
}

/** Rim and rings in SI, for a unit of so much SI. The curves beyond are held at the rim. */
export function rimOf(reach: Reach, unit: number): Rim {
  const intact = reach.intact.filter(Number.isFinite);
  const lost = reach.lost.filter(Number.isFinite);
  const largest = Math.max(0, ...intact);
  const wanted = Math.max(
    1.3 * Math.min(Infinity, ...intact.length > 0 ? intact : [0]),
    1.15 * percentile(lost.length > 0 ? lost : intact, 0.6),
    1.25 * reach.wind,
    LEAST_RIM,
  );
  return ringsTo(Math.max(Math.min(largest > 0 ? largest : wanted, wanted), 1.25 * reach.wind), unit);
}

/** The least number of rings, at most four, that reach so far. */
export function ringsTo(speed: number, unit: number): Rim {
  const reach = speed / unit;
  const step = STEPS.find((size) => Math.ceil(reach / size - 1e-9) <= MOST_RINGS) ?? 5000;
  return { step: step * unit, rim: Math.max(1, Math.ceil(reach / step - 1e-9)) * step * unit };
}

/** The new rim, or the one before where they hardly differ and the wind is within. */
export function calmRim(before: Rim | null, now: Rim, wind: number, wanted: number): Rim {
  if (before === null || wind > before.rim || before.rim === now.rim) return now;
  const within = wanted <= before.rim * CALM && now.rim * CALM >= before.rim;
  return within ? before : now;
}

export function percentile(values: readonly number[], share: number): number {
  if (values.length === 0) return 0;
  const sorted = [...values].sort((a, b) => a - b);
  const at = share * (sorted.length - 1);
  const [low, high] = [Math.floor(at), Math.ceil(at)];
  return sorted[low]! + (sorted[high]! - sorted[low]!) * (at - low);
}

export type Point = readonly [number, number];

/** On the screen, from the middle: a bearing clockwise from the bow, which is up. */
export function polar(bearing: number, radius: number): Point {
  return [radius * Math.sin(bearing), -radius * Math.cos(bearing)];
}

/** A closed path through speeds at bearings, held at the rim; broken where there is none. */
export function curve(bearings: ArrayLike<number>, speeds: ArrayLike<number>, scale: number, rim: number): string {
  let path = "";
  let open = false;
  let whole = true;
  for (let i = 0; i < bearings.length; i++) {
    const speed = speeds[i]!;
    if (!Number.isFinite(speed)) {
      open = whole = false;
      continue;
    }
    const [x, y] = polar(bearings[i]!, Math.min(speed, rim) * scale);
    path += `${open ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`;
    open = true;
  }
  return path !== "" && whole ? `${path}Z` : path;
}

/** Speed of a curve at a bearing, between the two that were computed. */
export function speedAt(bearings: ArrayLike<number>, speeds: ArrayLike<number>, bearing: number): number {
  const turn = 2 * Math.PI;
  const at = ((bearing % turn) + turn) % turn;
  let best = 0;
  for (let i = 0; i < bearings.length; i++) if (((bearings[i]! % turn) + turn) % turn <= at + 1e-12) best = i;
  const next = (best + 1) % bearings.length;
  const from = ((bearings[best]! % turn) + turn) % turn;
  const span = ((bearings[next]! - bearings[best]!) % turn + turn) % turn || turn;
  return speeds[best]! + (speeds[next]! - speeds[best]!) * (((at - from) % turn + turn) % turn) / span;
}

/** A bearing is kept until another is so many pixels freer. */
const STAY = 4;
/** Two figures touch where they are nearer than this, across and up [px]. */
const [FIGURE_WIDE, FIGURE_HIGH] = [28, 14];

/** The bearing, 20 to 70 degrees into a quadrant, where figures at these radii are farthest from points. */
export function freeBearing(radii: readonly number[], points: readonly Point[], before: number | null): number {
  const room = (bearing: number): number => {
    let least = Infinity;
    for (const radius of radii) {
      const [x, y] = polar(bearing, radius);
      for (const [u, v] of points) least = Math.min(least, Math.hypot(x - u, y - v));
    }
    return least;
  };
  let best = before ?? (Math.PI * 7) / 4;
  let most = before === null || touch(radii, before) ? -1 : room(best) + STAY;
  for (let quadrant = 0; quadrant < 4; quadrant++) {
    for (let degrees = 20; degrees <= 70; degrees += 5) {
      const bearing = ((90 * quadrant + degrees) * Math.PI) / 180;
      if (touch(radii, bearing)) continue;
      const free = room(bearing);
      if (free > most + 1e-9) [best, most] = [bearing, free];
    }
  }
  return best;
}

/** Whether figures at these radii stand on each other. */
function touch(radii: readonly number[], bearing: number): boolean {
  const [x, y] = polar(bearing, radii.length > 1 ? radii[1]! - radii[0]! : Infinity);
  return Math.abs(x) < FIGURE_WIDE && Math.abs(y) < FIGURE_HIGH;
}
