import type { Contact, ContactMode } from "./contacts";
import { DataError } from "./blocks";
import type { Vec } from "./header";
import { eventKinds, type MotionEvent } from "./run";

/** What a live page asks of its simulation (docs/live.md). Points are in the frame of the body, all else in the world; SI. */
export type LiveCommand =
  | { do: "run" | "pause" | "step" | "back" | "reset" | "reload" | "release" | "save" | "export" }
  | { do: "follow"; value: boolean }
  | { do: "speed" | "target_step"; value: number }
  | { do: "gravity"; value: Vec }
  | { do: "surface"; material: string; friction?: number; restitution?: number }
  | { do: "method"; key: string; value: string }
  | { do: "pull"; body: number; point: Vec; target: Vec }
  | { do: "push"; body: number; point: Vec; impulse: Vec }
  | { do: "motor"; joint: number; coordinate: number; velocity?: number }
  | { do: "rest"; joint: number; coordinate: number; value: number };

/** What can be set of a coordinate of a joint. */
export interface LiveAxis {
  joint: number;
  coordinate: number;
  name: string;
  unit: "rad" | "m";
  /** Velocity of its motor a second; null: it has none. */
  motor: number | null;
  /** Where its spring rests; null: it has none. */
  rest: number | null;
}

/** What the simulation tells of itself besides its motion. */
export interface LiveStatus {
  type: "status";
  /** Counts the scenes that were read. */
  generation: number;
  running: boolean;
  speed: number;
  /** Simulated seconds a second that it reaches. */
  rate: number;
  gravity: Vec;
  surfaces: { material: string; friction: number; restitution: number }[];
  /** Of all joints, in their order. */
  axes: LiveAxis[];
  /** Output times that can be gone back. */
  earlier: number;
  target_step: number;
  method: { key: string; value: string; values: string[] }[];
  /** Empty, or why it cannot go on. */
  stopped: string;
  /** Frames in the recording. */
  recorded: number;
  file: { name: string; follow: boolean; changed: boolean; messages: string[] };
}
export interface LiveError {
  type: "error";
  messages: string[];
}

/** A moment of the simulation; arrays as in Motion, but of the bodies that are not static only. */
export interface LiveFrame {
  generation: number;
  time: number;
  /** The series of the header at the last output time. */
  series: Float64Array;
  /** For each body: position from the origin, orientation x y z w, velocity, angular velocity. */
  bodies: Float32Array;
  contacts: Contact[];
}
/** What happened since the last reset (rigor/view/live/live_history.hpp). */
export interface LiveHistory {
  generation: number;
  /** A column for each series of the header. */
  columns: Float64Array[];
  /** In the order of their times; where there were too many, the stronger ones. */
  events: MotionEvent[];
  /** So far, also those that are not kept. */
  eventCount: number;
}
export interface LiveFile {
  name: string;
  bytes: Uint8Array;
}

export const numbersOfBody = 13;
const numbersOfContact = 13;
const modes: ContactMode[] = ["open", "stick", "slide", "unknown"];

export function readText(text: string): LiveStatus | LiveError {
  const message = JSON.parse(text) as LiveStatus | LiveError;
  if (message.type !== "status" && message.type !== "error") throw new DataError("the server sent a text of an unknown kind");
  return message;
}

/** A frame, a file or a history, as rigor/view/live/live_frame.cpp and live_history.cpp pack them; origin: Header.origin. */
export function readBytes(buffer: ArrayBuffer, origin: Vec): LiveFrame | LiveFile | LiveHistory {
  const view = new DataView(buffer);
  const kind = buffer.byteLength >= 8 ? view.getUint32(0, true) : 0;
  if (kind === 1) return readFrame(buffer, view);
  if (kind === 2) {
    const length = view.getUint32(4, true);
    if (8 + length > buffer.byteLength) throw new DataError("a file from the server is cut");
    return { name: new TextDecoder().decode(new Uint8Array(buffer, 8, length)), bytes: new Uint8Array(buffer, 8 + length) };
  }
  if (kind === 3) return readHistory(buffer, view, origin);
  throw new DataError("the server sent bytes of an unknown kind");
}

function readHistory(buffer: ArrayBuffer, view: DataView, origin: Vec): LiveHistory {
  const head = 28, eventSize = 44;
  if (buffer.byteLength < head) throw new DataError("a history is cut");
  const [generation, series, rows, count] = [4, 8, 12, 16].map((at) => view.getUint32(at, true));
  const eventsAt = head + 8 * series * rows;
  if (buffer.byteLength !== eventsAt + eventSize * count) throw new DataError("a history has not the length that it tells");
  const columns = Array.from({ length: series }, (_, i) => Float64Array.from({ length: rows }, (_row, k) => view.getFloat64(head + 8 * (k * series + i), true)));
  const events = Array.from({ length: count }, (_, i): MotionEvent => {
    const at = eventsAt + eventSize * i;
    const vector = (from: number): Vec => [0, 4, 8].map((step) => view.getFloat32(at + from + step, true)) as Vec;
    return {
      time: view.getFloat64(at, true), kind: eventKinds[view.getUint32(at + 8, true)] ?? "impact",
      bodyA: view.getInt32(at + 12, true), bodyB: view.getInt32(at + 16, true),
      point: vector(20).map((x, c) => x + origin[c]) as Vec, impulse: vector(32),
    };
  });
  return { generation, columns, events: events.sort((a, b) => a.time - b.time), eventCount: view.getFloat64(20, true) };
}

function readFrame(buffer: ArrayBuffer, view: DataView): LiveFrame {
  const head = 28;
  if (buffer.byteLength < head) throw new DataError("a frame is cut");
  const [generation, bodies, contacts, series] = [4, 8, 12, 16].map((at) => view.getUint32(at, true));
  const bodiesAt = head + 8 * series, contactsAt = bodiesAt + 4 * numbersOfBody * bodies;
  if (buffer.byteLength !== contactsAt + 4 * numbersOfContact * contacts) throw new DataError("a frame has not the length that it tells");
  const f32 = (at: number) => view.getFloat32(at, true);
  return {
    generation,
    time: view.getFloat64(20, true),
    series: Float64Array.from({ length: series }, (_, i) => view.getFloat64(head + 8 * i, true)),
    bodies: Float32Array.from({ length: numbersOfBody * bodies }, (_, i) => f32(bodiesAt + 4 * i)),
    contacts: Array.from({ length: contacts }, (_, i): Contact => {
      const at = contactsAt + 4 * numbersOfContact * i;
      const vector = (from: number): Vec => [f32(at + from), f32(at + from + 4), f32(at + from + 8)];
      return {
        bodyA: view.getUint32(at, true), bodyB: view.getUint32(at + 4, true), mode: modes[view.getUint32(at + 8, true)] ?? "unknown",
        gap: f32(at + 12), point: vector(16), normal: vector(28), force: vector(40),
      };
    }),
  };
}
