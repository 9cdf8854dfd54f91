/** A made-up life of a cell: a walk and protrusions that look like those of the model, without any physics. */
import type { ProtrusionRow, Tracks } from "../src/contract";
import { normal, type Random } from "./pack";

export const outlinePoints = 235;

export function protrusionRows(u: Random, end: number): ProtrusionRow[] {
  const rows: ProtrusionRow[] = [];
  let t = 60 + 200 * u();
  for (let id = 1; t < end; ++id, t += 300 + 1900 * u()) {
    const start = Math.round(t);
    const unadhered = u() < 0.12;
    const [adhesion, mature] = [start + 400, start + 1000];
    const gone = mature + Math.round(300 - 2400 * Math.log(1 - u()));
    const end_ = (unadhered ? adhesion : gone) + 400;
    const fMat = [0.2, 0.4, 0.6, 0.8, 0.9][Math.floor(5 * u())];
    const force = 0.05 + 0.6 * u();
    const until = <T>(time: number, value: T): T | null => (time <= end ? value : null);
    rows.push({
      id,
      centre_particle: Math.floor(outlinePoints * u()),
      t_initiation_s: start,
      t_adhesion_s: unadhered ? null : until(adhesion, adhesion),
      t_mature_s: unadhered ? null : until(mature, mature),
      t_disassembly_s: unadhered ? until(adhesion, adhesion) : until(gone, gone),
      t_end_s: until(end_, end_),
      length_um: until(adhesion, 26 + 6 * u()),
      f_mat: unadhered ? null : until(mature, fMat),
      force_nN: unadhered ? null : until(gone, force),
      f_adh_rel: unadhered ? null : until(gone, force / (0.6 * fMat)),
      cause: unadhered ? "unadhered" : until(gone, "disassembly"),
    });
  }
  return rows;
}

export function tracks(u: Random, end: number, rows: ProtrusionRow[]): Tracks {
  const out: Tracks = {
    t_s: [],
    x_um: [],
    y_um: [],
    area_um2: [],
    perimeter_um: [],
    polarization_rad: [],
    n_simultaneous: [],
  };
  let [x, y] = [0, 0];
  for (let t = 0; t <= end; t += 60) {
    const alive = rows.filter((r) => r.t_initiation_s <= t && (r.t_end_s ?? end) >= t);
    out.t_s.push(t);
    out.x_um.push(x);
    out.y_um.push(y);
    out.area_um2.push(700 + 60 * alive.length + 25 * Math.sin(t / 900) + 4 * normal(u));
    out.perimeter_um.push(94 + 25 * alive.length);
    out.polarization_rad.push(rows[0] && t > rows[0].t_initiation_s ? 0.6 + 0.5 * Math.sin(t / 5000) : null);
    out.n_simultaneous.push(alive.length);
    for (const r of alive) {
      if (r.t_mature_s === null || t < r.t_mature_s || t > (r.t_disassembly_s ?? end)) continue;
      const angle = (2 * Math.PI * r.centre_particle) / outlinePoints;
      x += 0.2 * Math.cos(angle);
      y += 0.2 * Math.sin(angle);
    }
    x += 0.12 + 0.15 * normal(u);
    y += 0.06 + 0.15 * normal(u);
  }
  return out;
}
