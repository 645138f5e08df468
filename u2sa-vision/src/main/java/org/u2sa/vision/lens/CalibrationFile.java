package org.u2sa.vision.lens;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;

/** Reads and writes a {@link LensCalibration} as a human-editable XML file. */
public final class CalibrationFile {
  private static final String ROOT = "camera";

  private CalibrationFile() {}

  /**
   * Reads a file.
   *
   * @throws BadInputException if it is missing or malformed; names file, line and value
   */
  public static LensCalibration read(Path file) {
    XmlElement root = XmlReader.read(file, ROOT);
    root.refuseUnknownChildren("picture", "pinhole", "distortion", "quality");
    XmlElement picture = part(root, "picture", "width", "height");
    XmlElement pinhole = part(root, "pinhole", "focalX", "focalY", "centreX", "centreY");
    XmlElement distortion = part(root, "distortion", "k1", "k2", "p1", "p2", "k3");
    XmlElement quality = part(root, "quality", "errorPx", "pictures");
    try {
      return new LensCalibration(
          whole(picture, "width"),
          whole(picture, "height"),
          new Intrinsics(
              number(pinhole, "focalX"),
              number(pinhole, "focalY"),
              number(pinhole, "centreX"),
              number(pinhole, "centreY")),
          number(distortion, "k1"),
          number(distortion, "k2"),
          number(distortion, "p1"),
          number(distortion, "p2"),
          number(distortion, "k3"),
          number(quality, "errorPx"),
          whole(quality, "pictures"));
    } catch (IllegalArgumentException e) {
      throw root.error(e.getMessage(), e);
    }
  }

  /**
   * Writes a file; numbers are exact, so that the calibration round-trips.
   *
   * @throws IOException if it cannot be written
   */
  public static void write(LensCalibration lens, Path file) throws IOException {
    String text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            + "<!-- Geometry of a camera, in pixels: docs/vision.md. -->\n"
            + "<camera>\n"
            + tag("picture", "width", lens.width(), "height", lens.height())
            + tag(
                "pinhole",
                "focalX",
                lens.pinhole().focalX(),
                "focalY",
                lens.pinhole().focalY(),
                "centreX",
                lens.pinhole().centreX(),
                "centreY",
                lens.pinhole().centreY())
            + tag(
                "distortion",
                "k1",
                lens.k1(),
                "k2",
                lens.k2(),
                "p1",
                lens.p1(),
                "p2",
                lens.p2(),
                "k3",
                lens.k3())
            + tag("quality", "errorPx", lens.errorPx(), "pictures", lens.pictures())
            + "</camera>\n";
    Files.write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  private static String tag(String name, Object... attributes) {
    StringBuilder text = new StringBuilder("  <").append(name);
    for (int i = 0; i < attributes.length; i += 2) {
      text.append(String.format(Locale.ROOT, " %s=\"%s\"", attributes[i], attributes[i + 1]));
    }
    return text.append("/>\n").toString();
  }

  private static XmlElement part(XmlElement root, String name, String... attributes) {
    XmlElement part =
        root.child(name).orElseThrow(() -> root.error("element <" + name + "> is missing"));
    part.refuseUnknownAttributes(attributes);
    return part;
  }

  private static double number(XmlElement element, String attribute) {
    String text = element.attribute(attribute);
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return value;
      }
      throw element.error(attribute + " = \"" + text + "\" is not a finite number");
    } catch (NumberFormatException e) {
      throw element.error(attribute + " = \"" + text + "\" is not a number", e);
    }
  }

  private static int whole(XmlElement element, String attribute) {
    String text = element.attribute(attribute);
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw element.error(attribute + " = \"" + text + "\" is not a whole number", e);
    }
  }
}
