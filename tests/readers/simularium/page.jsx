// A page that holds Simularium's viewer; open.mjs gives it a file.
import Viewer, { RenderStyle, SimulariumController, loadSimulariumFile } from "@aics/simularium-viewer";
import React from "react";
import { createRoot } from "react-dom/client";

const controller = new SimulariumController({});
const seen = { info: null, names: [], errors: [] };
const selection = { highlightedAgents: [], hiddenAgents: [], colorChange: null, appliedColors: [] };

createRoot(document.getElementById("viewer")).render(
  <Viewer width={300} height={300} renderStyle={RenderStyle.WEBGL2_PREFERRED} backgroundColor={[1, 1, 1]} loggerLevel="error"
          simulariumController={controller} selectionStateInfo={selection} showCameraControls={false} showBounds={true}
          hideAllAgents={false} showPaths={false} lockedCamera={false} disableCache={false} agentColors={["#2066a8", "#d55e00"]}
          onTimeChange={() => {}} onJsonDataArrived={() => {}} onUIDisplayDataChanged={(data) => { seen.names = data.map((entry) => entry.name); }}
          onTrajectoryFileInfoChanged={(info) => { seen.info = info; }} onError={(error) => seen.errors.push(error.message)} />);

window.open_file = async (text) => {
  const file = await loadSimulariumFile(new Blob([text], { type: "text/plain" }));
  await controller.handleFileChange(file, "run.simularium");
};
window.go_to = (time) => controller.gotoTime(time);
window.what_is_seen = () => {
  const { time, agentCount } = controller.visData.currentFrameData;
  return { ...seen, time, agentCount };
};
