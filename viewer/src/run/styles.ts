/** The styles of what a run is looked at with. Their order matters: those for narrow screens and paper come last. */
import "./stage.css";
import "./plots.css";
