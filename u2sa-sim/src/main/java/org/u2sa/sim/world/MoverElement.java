package org.u2sa.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Reads the elements {@code <mover>} of a world file. */
public final class MoverElement {
  private static final double MAX_SPEED_MPS = 1_000.0;
  private static final double FAR = 1e7; // metres, or degrees within XML's own limits

  private MoverElement() {}

  /**
   * Reads a mover.
   *
   * @param element with waypoints, speed and further settings
   * @param object the object in the element, at its start
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static ScriptedMover read(XmlElement element, ObjectDescription object, LocalPlane plane) {
    try {
      List<ScriptedMover.Waypoint> way = new ArrayList<>();
      for (XmlElement child : element.children("waypoint")) {
        way.add(waypoint(child, element, object));
      }
      return new ScriptedMover(
          object,
          plane,
          way,
          ElementValues.choice(element, "end", ScriptedMover.End.class, ScriptedMover.End.STOP),
          ElementValues.number(element, "delay", "s", 0.0, 1e6, 0.0),
          ElementValues.flag(element, "floats"),
          ElementValues.flag(element, "transponder"));
    } catch (BadInputException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw element.error(e.getMessage(), e);
    }
  }

  private static ScriptedMover.Waypoint waypoint(
      XmlElement child, XmlElement element, ObjectDescription object) {
    child.refuseUnknownAttributes();
    child.refuseText();
    child.refuseUnknownChildren("x", "y", "z", "speed", "wait");
    ReferenceFrame frame = object.referenceFrame();
    boolean isDegrees = frame.isEarth() && !frame.isUtm();
    String unit = isDegrees ? "deg" : "m";
    Point place =
        Point.of(
            ElementValues.number(
                child, "x", unit, -(isDegrees ? 180.0 : FAR), isDegrees ? 180.0 : FAR),
            ElementValues.number(
                child, "y", unit, -(isDegrees ? 90.0 : FAR), isDegrees ? 90.0 : FAR),
            ElementValues.number(child, "z", "m", -1e5, 1e5, object.z()));
    XmlElement paced = child.child("speed").isPresent() ? child : element;
    double speed = ElementValues.number(paced, "speed", "m/s", 1e-3, MAX_SPEED_MPS);
    return new ScriptedMover.Waypoint(
        place, speed, ElementValues.number(child, "wait", "s", 0.0, 1e6, 0.0));
  }
}
