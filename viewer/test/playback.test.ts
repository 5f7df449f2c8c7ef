import { describe, expect, test } from "vitest";
import * as format from "../src/format";
import { Playback, speeds, steppedTime } from "../src/playback";
import { lastAtMost, nearest } from "../src/search";
import { kineticEnergy } from "../src/plots";

describe("playback", () => {
  test("goes with the clock at the chosen speed, and only while it plays", () => {
    const playback = new Playback(0, 10);
    expect(playback.advance(1)).toBe(false);
    playback.toggle();
    playback.speed = 0.5;
    expect(playback.advance(1)).toBe(true);
    expect(playback.time).toBe(0.5);
  });

  test("loops, or stops at the end and begins again", () => {
    const playback = new Playback(1, 3);
    playback.toggle();
    playback.advance(2.5);
    expect(playback.time).toBe(1.5);
    playback.isLooping = false;
    playback.advance(5);
    expect([playback.time, playback.isPlaying]).toEqual([3, false]);
    playback.toggle();
    expect([playback.time, playback.isPlaying]).toEqual([1, true]);
  });

  test("a run of one frame does not play", () => {
    const playback = new Playback(2, 2);
    playback.toggle();
    expect(playback.advance(1)).toBe(false);
    expect(playback.time).toBe(2);
  });

  test("speeds go from a thousandth to ten and stay there", () => {
    const playback = new Playback(0, 1);
    for (let i = 0; i < 30; ++i) playback.changeSpeed(-1);
    expect(playback.speed).toBe(1 / 1000);
    for (let i = 0; i < 30; ++i) playback.changeSpeed(1);
    expect(playback.speed).toBe(10);
    expect(speeds).toContain(1);
  });

  test("a step goes to the neighbouring frame, from between two to either", () => {
    const times = [0, 1, 2, 3];
    expect(steppedTime(times, 1, 1)).toBe(2);
    expect(steppedTime(times, 1, -1)).toBe(0);
    expect(steppedTime(times, 1.5, 1)).toBe(2);
    expect(steppedTime(times, 1.5, -1)).toBe(1);
    expect(steppedTime(times, 3, 10)).toBe(3);
  });
});

describe("small things", () => {
  test("searches in ascending values", () => {
    expect([-1, 0, 0.5, 1, 9].map((x) => lastAtMost([0, 1, 2], x))).toEqual([0, 0, 0, 1, 2]);
    expect(nearest([], 1)).toBe(-1);
    expect(nearest([0, 1, 2], 1.6)).toBe(2);
  });

  test("numbers are short and keep their digits", () => {
    expect(format.number(0.1)).toBe("0.1");
    expect(format.number(-1234.5678)).toBe("−1234.6");
    expect(format.number(1e-7)).toBe("1e−7");
    expect(format.number(100)).toBe("100");
    expect(format.number(NaN)).toBe("–");
    expect(format.speed(0.001)).toBe("1/1000×");
    expect(format.speed(10)).toBe("10×");
    expect(format.time(1.23456, 0.001)).toBe("1.235");
  });

  test("energy of rotation takes the principal frame", () => {
    // A third of a turn about (1, 1, 1) takes the body's x axis to y: there the moment is 2.
    const q: [number, number, number, number] = [0.5, 0.5, 0.5, 0.5];
    const [translation, rotation] = kineticEnergy(3, [2, 5, 7], [1, 2, 0], [0, 4, 0], q);
    expect(translation).toBeCloseTo(7.5, 12);
    expect(rotation).toBeCloseTo(16, 12);
  });
});
