/** The worker that simulates, as the page talks to it. */
import type { Answer, FromWorker, ToWorker } from "./protocol";

type Asked<T> = T extends { ticket: number } ? Omit<T, "ticket"> : never;
/** A message that is answered. */
export type Question = Asked<ToWorker>;

export class EngineWorker {
  private readonly worker: Worker;
  private tickets = 0;
  private readonly waiting = new Map<number, (answer: Answer) => void>();

  /** @param hear  receives every message that is not an answer */
  constructor(hear: (message: Exclude<FromWorker, Answer>) => void) {
    const source = document.getElementById("matrigrate-core")?.textContent ?? "";
    if (source.length < 1000) throw new Error("This is the empty page: the simulation has not been put into it (web/build.sh does).");
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.worker = new Worker(address);
    this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
      if (data.kind !== "answer") return hear(data);
      this.waiting.get(data.ticket)?.(data);
      this.waiting.delete(data.ticket);
    };
    this.worker.onerror = (event) => hear({ kind: "failure", text: `The simulation has stopped: ${event.message}` });
  }

  /** @param transfer  memory that is handed over with it */
  tell(message: ToWorker, transfer: Transferable[] = []): void {
    this.worker.postMessage(message, transfer);
  }

  ask(question: Question): Promise<Answer> {
    const ticket = ++this.tickets;
    return new Promise((answered) => {
      this.waiting.set(ticket, answered);
      this.worker.postMessage({ ...question, ticket });
    });
  }
}
