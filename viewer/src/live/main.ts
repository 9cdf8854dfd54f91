/** The live page: the simulation runs in a worker of this tab, and the player draws it as it goes. */
import { fillPage, h } from "../dom";
import "../page.css";
import "../run/stage.css";
import "../run/plots.css";
import "./live.css";
import { about } from "./lesson";
import { unable } from "./troubles";
import { Live } from "./live";

fillPage((page) => {
  const reason = unable();
  if (reason) throw new Error(reason);
  const live = new Live();
  const status = "Cell migration through a degradable viscoelastic gel, computed in this tab.";
  const head = h("header", {}, h("h1", {}, "Matrigrate live"), h("p", { class: "status" }, status));
  page.replaceChildren(head, ...live.parts, about());
  window.matrigrateLive = live;
  return live.seen;
});
