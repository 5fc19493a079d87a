/**
 * Requests and answers, as docs/explorer.md describes them.
 *
 * @typedef {[number, number, number]} Vector
 *
 * @typedef {{ source?: string, vehicle?: string, values?: Record<string, number | string> }} Touchdown
 *
 * @typedef {"stable" | "unstable" | "bottomed" | "failure" | "undecided"} Class
 *
 * @typedef {{ name: string, title: string, file: string | null, kind: string, legs: number,
 *   search: { from_fps: number, to_fps: number } }} Source
 * @typedef {{ name: string, title: string, file: string | null, kind: "map" | "profile" | "sample", source: string,
 *   axes: string[], points: number }} ResultsEntry
 * @typedef {{ class: Class, word: string, mark: string, region: string }} Kind
 * @typedef {{ program: { name: string, version: string, model: number }, units: Units, sources: Source[],
 *   results: ResultsEntry[], classes: Kind[] }} Inputs
 * @typedef {"US" | "SI"} Units
 *
 * @typedef {{ from: number, to: number, step: number }} Slider
 * @typedef {{ name: string, title: string, meaning: string, unit: string, value: number | string | null, slider: Slider | null,
 *   si: { name: string, unit: string, value: number | null, slider: Slider | null } | null,
 *   allowed: { lower: number | null, upper: number | null, text: string } | null,
 *   is_given: boolean, group: string, leg: number | null, is_own: boolean, words: string[] }} Parameter
 *
 * @typedef {{ name: string, title: string, unit: string, values: number[] }} Column
 * @typedef {{ time_s: number, kind: string, leg: number | null, title: string }} LandingEvent
 * @typedef {{ unit: string, total: number[], parts: { name: string, title: string, values: number[] }[],
 *   closure: number[] }} Energies
 *
 * @typedef {{ leg: number, of: "pad" | "block", point: Vector, normal: Vector, is_even: boolean }} Patch
 * @typedef {{ slope_deg: number, normal: Vector, downhill: Vector, surface_point: Vector, velocity_direction: Vector,
 *   patches: Patch[] }} Ground
 * @typedef {{ from: Vector, length: number, minimum_length: number, maximum_length: number, collar: number | null }} StrutShape
 * @typedef {{ azimuth_deg: number, outboard: Vector, lower_hardpoint: Vector, upper_hardpoint: Vector,
 *   link_length: number | null, struts: StrutShape[],
 *   footpad: { diameter: number, height: number },
 *   block: { face: Vector, diameter: number, height: number } | null }} LegShape
 * @typedef {{ center: Vector, body: { top: number, bottom: number, radius: number }, ring: number[],
 *   legs: LegShape[] }} VehicleShape
 * @typedef {{ pivot: Vector[], pad_axis: Vector[], pad_crush: [number, number][], block_crush: number[],
 *   pad_interference: [number, number][], block_interference: number[], strokes: number[][], strut_forces: number[][],
 *   pad_force: Vector[], block_force: Vector[], is_down: boolean[] }} LegInstants
 * @typedef {{ time_s: number[], center_of_gravity: Vector[], rotation: number[][], legs: LegInstants[],
 *   critical_edge: ([number, number] | null)[], stability_angle_deg: number[] }} Instants
 * @typedef {{ ground: Ground, vehicle: VehicleShape, instants: Instants }} Drawing
 *
 * @typedef {Kind & { outcome: string, why: string, failure: string | null,
 *   end_time_s: number, verdict_time_s: number, warning: string | null,
 *   report: { result: Record<string, number | string | null>, min_stability_time_s: number } & Record<string, unknown>,
 *   result_units?: Record<string, string>, history: { columns: Column[] } | null, events: LandingEvent[], energies: Energies | null,
 *   drawing: Drawing | null }} Landing
 *
 * @typedef {{ speed_fps: number, class: Class, outcome?: string }} StripLanding
 * @typedef {Kind & { from_fps: number, to_fps: number, outcome?: string,
 *   certainty?: string, bracket_width_fps?: number | null }} Band
 * @typedef {{ landings: StripLanding[], bands: Band[], is_done: boolean }} Strip
 * @typedef {{ to: Class, speed_fps: number, low_fps: number | null, high_fps: number | null,
 *   certainty: string | null, disputed_fps: [number, number] | null, stable_landings_below: number,
 *   patchy: { to_fps: number, landings: number, not_stable: number } | null }} Transition
 * @typedef {{ bands: Band[], first_transition: Transition | null, landings: number }} Bands
 *
 * @typedef {{ name: string, title: string, unit: string, values: number[], fixed?: number | string }} Axis
 * @typedef {{ place: number[], speed: number | null, low: number | null, high: number | null, to: Class | null,
 *   certainty: string | null, disputed: [number, number] | null, patchy_to: number | null, bands?: (Kind & { from: number, to: number })[] }} MapPoint
 * @typedef {{ title: string, conditions: string, statement: string | null, source: string, speed_unit: string, speed_column: string, axes: Axis[],
 *   other_axes: Axis[], points: MapPoint[], grid: { speeds: (number | null)[][] } | null,
 *   triangles: [number, number, number][][] | null, jump: number | null, jump_bars: [number, number][][], bisector: [number, number][][],
 *   jump_cells: [number, number][], edges: { kind: "end" | "jump" | "bands", places: [number, number][] }[],
 *   levels: { speed: number | null, colour: string }[], searched_to: number | null, lowest: [number, number][],
 *   words: Record<string, string | null>, colours: Record<string, string>,
 *   kinds: Kind[] }} MapAnswer
 * @typedef {{ touchdown: Touchdown, axes: string[], from_fps: number, to_fps: number, table: string }} Computed
 * @typedef {{ place: Record<string, number>, speed: number | null, low: number | null, high: number | null, to: Class | null,
 *   certainty: string | null, below: Touchdown | null, above: Touchdown | null }} At
 *
 * @typedef {{ title: string, source: string, inputs: { name: string, title: string, unit: string, values: (number | string | null)[],
 *   written?: { name: string, values: (number | string | null)[] } }[],
 *   outcomes: string[], outcome: number[], classes: Kind[], class: number[],
 *   results: { name: string, title: string, unit: string, values: (number | null)[] }[], ramp: string[] }} Sample
 * @typedef {{ column: string, from: number, to: number }} Range
 * @typedef {{ landings: number, classes: { landings: number, probability: number | null, low_95: number, high_95: number }[] }} Counted
 * @typedef {{ column: string, all: Counted, within: Counted, bins: { from: number, to: number, all: Counted, within: Counted }[] }} Bins
 *
 * @typedef {{ message: string, key: string | null, value: string | null, allowed: string | null }} Complaint
 */

export {};
