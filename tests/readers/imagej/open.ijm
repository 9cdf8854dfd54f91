// Opens a picture as a drag onto ImageJ does, tells its dimensions, scale and labels, and the values of pixels; then the
// same of what Image > Hyperstacks > Stack to Hyperstack makes of it.
// Argument: PICTURE|CHANNELS|FRAMES|FILE, with a line "frame channel row column" for each pixel, counted from 0.
function tell(what, hyper) {
  getDimensions(width, height, channels, slices, frames);
  getVoxelSize(x, y, z, unit);
  print(what, width, height, channels, slices, frames, bitDepth(), x, y, Stack.isHyperstack, Stack.getFrameInterval());
  print(what + " unit", charCodeAt(unit, 0), substring(unit, 1)); // the terminal may not have the letter
  for (i = 0; i < wanted.length; i++) {
    at = split(wanted[i], " ");
    frame = parseInt(at[0]);
    channel = parseInt(at[1]);
    if (hyper)
      Stack.setPosition(channel + 1, 1, frame + 1);
    else
      setSlice(frame * parseInt(told[1]) + channel + 1);
    print(what + " pixel", d2s(getValue(parseInt(at[3]), parseInt(at[2])), -9));
  }
}

told = split(getArgument(), "|");
wanted = split(File.openAsString(told[3]), "\n");
setBatchMode(true);
open(told[0]);
var wanted, told;
print("version", getVersion());
tell("plain", false);
run("Stack to Hyperstack...", "order=xyczt(default) channels=" + told[1] + " slices=1 frames=" + told[2] + " display=Grayscale");
tell("hyperstack", true);
