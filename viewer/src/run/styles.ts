/** The styles of what a run is looked at with. Their order matters: those for narrow screens and paper come last. */
import "./stage.css";
import "./legend.css";
import "./plots.css";
import "./screens.css";
