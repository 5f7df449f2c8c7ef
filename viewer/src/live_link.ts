import { DataError } from "./blocks";
import type { Vec } from "./header";
import { readBytes, readText, type LiveCommand, type LiveFile, type LiveFrame, type LiveHistory, type LiveStatus } from "./live_message";

export interface LiveListener {
  status(status: LiveStatus): void;
  frame(frame: LiveFrame): void;
  history(history: LiveHistory): void;
  file(file: LiveFile): void;
  errors(messages: string[]): void;
  connected(isConnected: boolean): void;
}

/** How long to wait before the server is asked again [ms]. */
const retryPause = 1000;

/** The WebSocket to the simulation. The token is the one in the page's address. */
export class LiveLink {
  private socket: WebSocket | undefined;

  constructor(private readonly origin: Vec, private readonly listener: LiveListener) {
    this.connect();
  }

  /** Sends a command; what cannot be sent now is lost, and false comes back. */
  send(command: LiveCommand): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(command));
    return true;
  }

  private connect(): void {
    const socket = new WebSocket(`ws://${location.host}/live${location.search}`);
    this.socket = socket;
    socket.binaryType = "arraybuffer";
    socket.addEventListener("open", () => this.listener.connected(true));
    socket.addEventListener("message", (event: MessageEvent<string | ArrayBuffer>) => this.take(event.data));
    socket.addEventListener("close", () => {
      this.listener.connected(false);
      window.setTimeout(() => this.connect(), retryPause);
    });
  }

  private take(data: string | ArrayBuffer): void {
    try {
      if (typeof data === "string") {
        const message = readText(data);
        if (message.type === "status") this.listener.status(message);
        else this.listener.errors(message.messages);
        return;
      }
      const message = readBytes(data, this.origin);
      if ("name" in message) this.listener.file(message);
      else if ("columns" in message) this.listener.history(message);
      else this.listener.frame(message);
    } catch (error) {
      if (!(error instanceof DataError)) throw error;
      this.listener.errors([error.message]);
    }
  }
}
