/** Pictures a second. */
const rate = 30;

/** Records what a canvas shows as a film, in the form that the browser can write. */
export class Film {
  private recorder: MediaRecorder | undefined;

  /** done: gets the film and how its name ends. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly done: (film: Blob, suffix: string) => void) {}

  /** Whether this browser can. */
  static get isPossible(): boolean {
    return typeof MediaRecorder !== "undefined" && "captureStream" in HTMLCanvasElement.prototype;
  }

  get isRunning(): boolean {
    return this.recorder?.state === "recording";
  }

  begin(): void {
    const type = ["video/mp4;codecs=avc1", "video/webm;codecs=vp9", "video/webm"].find((one) => MediaRecorder.isTypeSupported(one));
    const recorder = new MediaRecorder(this.canvas.captureStream(rate), { mimeType: type, videoBitsPerSecond: 8e6 });
    const parts: Blob[] = [];
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => this.done(new Blob(parts, { type: recorder.mimeType }), recorder.mimeType.startsWith("video/mp4") ? "mp4" : "webm");
    recorder.start(1000);
    this.recorder = recorder;
  }

  end(): void {
    if (this.isRunning) this.recorder?.stop();
  }
}
