// The live socket: opens it, waits for the snapshot, notices silence, and tries again when lost.
// What the messages mean is up to the listener.
import type { LiveMessage } from "../api/types";
import { backOffMs, mayFollow, SILENCE_MS, type ConnectionState } from "./connection";

export interface Listener {
  state(state: ConnectionState): void;
  message(message: LiveMessage): void;
}

export class LiveSocket {
  private socket: WebSocket | null = null;
  private current: ConnectionState = "lost";
  private attempt = 0;
  private retry: ReturnType<typeof setTimeout> | undefined;
  private silence: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly url: string,
    private readonly listener: Listener,
  ) {}

  /** Connects now; a wait for the next trial is cut short. */
  open(): void {
    if (this.current !== "lost") return;
    clearTimeout(this.retry);
    this.enter("connecting");
    const socket = new WebSocket(this.url);
    this.socket = socket;
    socket.onopen = () => {
      this.enter("identifying");
      this.expectMessage();
    };
    socket.onmessage = (event) => this.receive(event);
    socket.onclose = () => this.lose();
    this.expectMessage();
  }

  /** Ends the connection for good. */
  close(): void {
    clearTimeout(this.retry);
    if (this.current !== "lost") this.drop();
  }

  /** Sends to the server if there is a connection; says whether it could. */
  send(message: object): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  private receive(event: MessageEvent): void {
    const message = parse(event.data);
    if (message === null) return;
    this.expectMessage();
    if (this.current === "identifying") {
      if (message.type !== "snapshot") return;
      this.attempt = 0;
      this.enter("live");
    }
    this.listener.message(message);
  }

  /** A connection that says nothing is as good as none: phones change networks without notice. */
  private expectMessage(): void {
    clearTimeout(this.silence);
    this.silence = setTimeout(() => this.lose(), SILENCE_MS);
  }

  private lose(): void {
    if (this.current === "lost") return;
    this.drop();
    this.retry = setTimeout(() => this.open(), backOffMs(this.attempt, Math.random()));
    this.attempt += 1;
  }

  private drop(): void {
    clearTimeout(this.silence);
    if (this.socket) {
      this.socket.onopen = this.socket.onmessage = this.socket.onclose = null;
      this.socket.close();
      this.socket = null;
    }
    this.enter("lost");
  }

  private enter(next: ConnectionState): void {
    if (!mayFollow(this.current, next)) {
      throw new Error(`live connection: ${this.current} must not become ${next}`);
    }
    this.current = next;
    this.listener.state(next);
  }
}

function parse(data: unknown): LiveMessage | null {
  try {
    const value: unknown = JSON.parse(String(data));
    const known = typeof value === "object" && value !== null && "type" in value;
    return known ? (value as LiveMessage) : null;
  } catch {
    return null;
  }
}
