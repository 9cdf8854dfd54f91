/** The live page: the simulation runs in a worker of this tab, and the player draws it as it goes. */
import { fault, h } from "../dom";
import "../page.css";
import "../run/stage.css";
import "../run/plots.css";
import "./live.css";
import { about } from "./lesson";
import { unable } from "./troubles";
import { Live } from "./live";

const page = document.getElementById("page");
if (page) {
  try {
    const reason = unable();
    if (reason) throw new Error(reason);
    const live = new Live();
    page.replaceChildren(
      h("header", {}, h("h1", {}, "Matrigrate live"), h("p", { class: "status" }, "Cell migration through a degradable viscoelastic gel, computed in this tab.")),
      ...live.parts,
      about(),
    );
    window.matrigrateLive = live;
  } catch (reason) {
    page.replaceChildren(fault(reason instanceof Error ? reason.message : String(reason)));
  }
}
